// Images as the bytes of a Radiance HDR file.
#pragma once

#include <string>

#include "lancer/image/image.h"

namespace lancer {

// Linear sRGB primaries, run-length encoded RGBE, rounded to nearest; grey becomes RGB and alpha is left out. The metadata are header lines
// "key=value". What RGBE can't hold is moved to what it can: negative and not-a-number to 0, infinite to the largest.
std::string encode_hdr(const Image& image, const Metadata& metadata);

}  // namespace lancer
