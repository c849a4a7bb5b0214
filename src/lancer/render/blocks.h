// The order of points inside a rectangle: blocks of neighbours as large as a device's lanes, so that what is followed together is near together.
#pragma once

#include <algorithm>

namespace lancer {

struct BlockShape {
    int width = 1;
    int height = 1;
};

// 4x4 for 16, 4x2 for 8, 2x2 for 4; a row for anything that is not a power of two.
constexpr BlockShape block_shape(int lanes) {
    BlockShape shape;
    if ((lanes & (lanes - 1)) != 0) {
        shape.width = lanes;
        return shape;
    }
    for (int left = lanes; left > 1; left /= 2) {
        (shape.width <= shape.height ? shape.width : shape.height) *= 2;
    }
    return shape;
}

// Calls visit(x, y) once for each point of a width x height grid.
template <typename Visit>
void for_each_in_blocks(int width, int height, int lanes, Visit&& visit) {
    const BlockShape block = block_shape(lanes);
    for (int block_y = 0; block_y < height; block_y += block.height) {
        for (int block_x = 0; block_x < width; block_x += block.width) {
            for (int y = block_y; y < std::min(block_y + block.height, height); ++y) {
                for (int x = block_x; x < std::min(block_x + block.width, width); ++x) {
                    visit(x, y);
                }
            }
        }
    }
}

}  // namespace lancer
