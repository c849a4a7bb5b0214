#include "lancer/film/tiles.h"

#include <algorithm>
#include <random>
#include <utility>

namespace lancer {

std::vector<Tile> cut_tiles(int width, int height, int tile_size) {
    std::vector<Tile> tiles;
    for (int y = 0; y < height; y += tile_size) {
        for (int x = 0; x < width; x += tile_size) {
            tiles.push_back({x, y, std::min(x + tile_size, width), std::min(y + tile_size, height)});
        }
    }
    return tiles;
}

void shuffle(std::vector<std::size_t>& numbers, std::uint32_t seed) {
    // std::shuffle may differ between standard libraries; the generator itself is fully specified.
    std::mt19937 generator(seed);
    for (std::size_t i = numbers.size(); i > 1; --i) {
        std::swap(numbers[i - 1], numbers[generator() % i]);
    }
}

}  // namespace lancer
