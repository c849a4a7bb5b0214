// Linear light to the eight bits of a display.
#pragma once

#include <cstdint>

#include "lancer/image/image.h"

namespace lancer {

// round(255 * srgb_encode(linear)), clipped; not-a-number is 0. Exact, and several times faster than the curve.
std::uint8_t quantise_srgb(float linear);

// Every channel sRGB-encoded but for alpha, which is only scaled. In the order of the pixels.
ByteImage quantise_srgb(const Image& image);

// Whether the last channel is alpha.
inline bool has_alpha(const Image& image) { return image.channels == 2 || image.channels == 4; }

// The image without its alpha; grey is repeated to three channels if `as_rgb`.
Image without_alpha(const Image& image, bool as_rgb);

}  // namespace lancer
