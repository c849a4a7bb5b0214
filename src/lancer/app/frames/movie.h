// Pictures one after the other as a film, through ffmpeg.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lancer::app {

struct MovieRequest {
    std::vector<std::string> pictures;
    std::string output;
    double fps = 24.0;
    std::optional<std::string> view;  // as the first picture says of itself, if not given
    std::optional<double> exposure;
};

// The endings that films may have, with their dots.
const std::vector<std::string>& movie_endings();

// `tell` hears how many pictures are done. The film appears whole or not at all: false where `interrupted` became true before its end. Throws
// std::runtime_error with a sentence when a picture is missing, broken or of another size than the first; MachineFailure when ffmpeg is not
// there or fails.
bool make_movie(const MovieRequest& request, const std::function<void(int)>& tell, const std::atomic<bool>& interrupted);

}  // namespace lancer::app
