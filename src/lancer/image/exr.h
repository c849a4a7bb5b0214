// Images as the bytes of an OpenEXR file.
#pragma once

#include <string>

#include "lancer/image/image.h"

namespace lancer {

// Linear sRGB primaries, half float (32-bit floats when a finite value would overflow), ZIP, with the metadata as string attributes. Throws
// std::exception with the reason.
std::string encode_exr(const Image& image, const Metadata& metadata);

}  // namespace lancer
