#include "lancer/import/made_picture.h"

#include <bit>
#include <cassert>
#include <cstring>

#include <fmt/format.h>

#include "lancer/base/hash.h"

namespace lancer {

// A portable float map, "PF": three floats a pixel, the lowest row first.
scene::ImageTexture made_picture(const Image& rgb, const SourcePosition& position) {
    static_assert(std::endian::native == std::endian::little);
    assert(rgb.channels == 3);
    std::string bytes = fmt::format("PF\n{} {}\n-1.0\n", rgb.width, rgb.height);
    const std::size_t head = bytes.size(), row = static_cast<std::size_t>(rgb.width) * 3 * sizeof(float);
    const auto rows = static_cast<std::size_t>(rgb.height);
    bytes.resize(head + rows * row);
    for (std::size_t y = 0; y < rows; ++y) {
        std::memcpy(bytes.data() + head + (rows - 1 - y) * row, rgb.pixels.data() + y * row / sizeof(float), row);
    }
    scene::ImageTexture texture;
    texture.file = "made " + to_hexadecimal(hash_bytes(bytes)) + ".pfm";
    texture.bytes = std::make_shared<const std::string>(std::move(bytes));
    texture.linear = true;
    texture.position = position;
    return texture;
}

}  // namespace lancer
