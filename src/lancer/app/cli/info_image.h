// lancer info for pictures.
#pragma once

#include <string>

namespace lancer::app {

// Prints size, channels with their range and mean, values that are no numbers, and what the file says about itself. Returns the exit status.
int show_image_info(const std::string& path, bool as_json);

}  // namespace lancer::app
