// Whether a frame is there already.
#pragma once

#include <string>

#include "lancer/image/image.h"

namespace lancer::app {

// What a file that stands for a frame must say of itself.
struct FrameFacts {
    std::string command;  // as prepared pictures say it: "lancer render SCENE ..."
    std::string hash;     // of the scene and all that it reads
};

// That what a file says of itself is this, and that it was made by this version of lancer.
bool says(const Metadata& texts, const FrameFacts& facts);

// That the file is there and whole, says this, and was not stopped before its goal.
// Pictures of every format that is written, and films.
bool is_frame_done(const std::string& path, const FrameFacts& facts);

}  // namespace lancer::app
