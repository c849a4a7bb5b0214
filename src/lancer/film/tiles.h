// The picture cut into squares, each the work of one thread for a moment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lancer {

struct Tile {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // pixels, the last ones excluded

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
};

// Covers the picture without overlap, row by row; tiles at the right and lower edge may be smaller.
std::vector<Tile> cut_tiles(int width, int height, int tile_size);

// A permutation that depends on the seed alone [Fisher and Yates 1938].
void shuffle(std::vector<std::size_t>& numbers, std::uint32_t seed);

}  // namespace lancer
