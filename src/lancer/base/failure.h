// What the machine does to us: disk full, no display, out of memory. Thrown anywhere, caught in app/ only, exit status 3.
#pragma once

#include <stdexcept>

namespace lancer {

class MachineFailure : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace lancer
