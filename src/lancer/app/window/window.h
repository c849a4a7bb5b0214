// A window with a picture in it that is still being made.
#pragma once

#include <string>

#include "lancer/app/prepare.h"

namespace lancer::app {

// Whether there is a display to open windows on; `reason` says why not.
class Display {
public:
    Display();
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    bool is_there() const { return there_; }
    const std::string& reason() const { return reason_; }

private:
    bool there_ = false;
    std::string reason_;
};

// Renders `prepared` in a window until it is closed or Esc is pressed. S writes what is seen to `save_as`. Throws MachineFailure.
void run_window(const Display& display, const Prepared& prepared, const std::string& title, const std::string& save_as);

}  // namespace lancer::app
