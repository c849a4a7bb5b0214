// Pictures in the tables of the world.
#pragma once

#include "lancer/image/image.h"
#include "lancer/world/world.h"

namespace lancer {

// Appends the pixels to the tables: bytes as they are, all else as floats. With `halves` also copies of half the size, and so on down to one pixel.
// `encoded`: colours are sRGB; they are averaged as light. Returns the number of levels. Throws std::runtime_error when the tables are full.
int add_texels(const StoredPixels& pixels, bool encoded, bool halves, World& world);

// TEXELS_*
int storage_of(const StoredPixels& pixels);

}  // namespace lancer
