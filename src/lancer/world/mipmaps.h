// Smaller copies of pictures.
#pragma once

#include <vector>

namespace lancer {

// Linear RGBA, row-major, top row first.
struct MipLevel {
    int width = 0;
    int height = 0;
    std::vector<float> pixels;
};

// Half as wide and half as high, at least 1: each pixel is the mean over the area that it covers of `level`.
MipLevel half_as_large(const MipLevel& level);

}  // namespace lancer
