// The command that a picture says it was made by.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lancer/image/image.h"

namespace lancer::app {

struct PictureWords {
    std::vector<std::string> words;  // "render", the scene, options; no -o
    Metadata metadata;
};

// Nothing where the file can't be read or was not made by lancer: that is said on standard error.
std::optional<PictureWords> words_of_picture(const std::string& path);

}  // namespace lancer::app
