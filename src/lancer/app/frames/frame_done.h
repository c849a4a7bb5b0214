// Whether a frame is there already.
#pragma once

#include <string>

namespace lancer::app {

// What a file that stands for a frame must say of itself.
struct FrameFacts {
    std::string command;  // as prepared pictures say it: "lancer render SCENE ..."
    std::string hash;     // of the scene and all that it reads
};

// That the file is there, whole, of this version of lancer, was made by this command from these inputs, and was not stopped before its goal.
// Pictures of every format that is written, and films.
bool is_frame_done(const std::string& path, const FrameFacts& facts);

}  // namespace lancer::app
