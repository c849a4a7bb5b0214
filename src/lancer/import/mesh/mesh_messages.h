// Errors of a mesh file, of which only the first few are worth reading.
#pragma once

#include <string>
#include <string_view>

#include "lancer/base/diagnostic.h"

namespace lancer {

class MeshMessages {
public:
    MeshMessages(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

    // `line` and `column` count from 1; 0 where they mean nothing, as in binary data.
    void error(int line, int column, std::string message);
    void warning(int line, int column, std::string message);
    void note(std::string message) { diagnostics_.note({file_, 0, 0}, std::move(message)); }

    bool has_errors() const { return errors_ > 0; }
    bool has_too_many_errors() const { return errors_ > most_; }

private:
    static constexpr int most_ = 20;

    std::string file_;
    Diagnostics& diagnostics_;
    int errors_ = 0;
    int warnings_ = 0;
};

// A word from a file in quotes, shortened, with bytes that are no printable ASCII replaced by '?'.
std::string quoted(std::string_view word);

}  // namespace lancer
