#include "lancer/image/encode.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace lancer {
namespace {

double decode(double encoded) { return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4); }

// The table's cells: the floats of [2^-12, 1) cut at their upper bits, 128 for each power of two. Within a cell the code grows by less than
// one, most (0.66) just above 0.5, so that comparing with the next border settles it.
constexpr int dropped_bits = 23 - 7;
constexpr float first_cell = 0x1p-12f;  // the border of code 1 lies below it, that of code 2 above
constexpr std::uint32_t first_cell_bits = std::bit_cast<std::uint32_t>(first_cell) >> dropped_bits;
constexpr std::uint32_t cell_count = (std::bit_cast<std::uint32_t>(1.0f) >> dropped_bits) - first_cell_bits;

struct QuantisingTable {
    std::array<float, 256> from;               // the smallest float with each code
    std::array<std::uint8_t, cell_count> low;  // the code of each cell's first float

    QuantisingTable() {
        from[0] = 0.0f;
        for (std::size_t code = 1; code < from.size(); ++code) {
            const double border = decode((static_cast<double>(code) - 0.5) / 255.0);
            from[code] = static_cast<float>(border);
            if (static_cast<double>(from[code]) < border) {
                from[code] = std::nextafter(from[code], 2.0f);
            }
        }
        for (std::uint32_t cell = 0; cell < cell_count; ++cell) {
            const float start = std::bit_cast<float>((cell + first_cell_bits) << dropped_bits);
            const auto next = std::upper_bound(from.begin(), from.end(), start);
            low[cell] = static_cast<std::uint8_t>(next - from.begin() - 1);
        }
    }

    std::uint8_t code(float linear) const {
        if (!(linear >= from[1])) {
            return 0;
        }
        if (linear >= 1.0f) {
            return 255;
        }
        if (linear < first_cell) {
            return 1;
        }
        const std::size_t code = low[(std::bit_cast<std::uint32_t>(linear) >> dropped_bits) - first_cell_bits];
        return static_cast<std::uint8_t>(code < 255 && linear >= from[code + 1] ? code + 1 : code);
    }
};

const QuantisingTable& quantising_table() {
    static const QuantisingTable table;
    return table;
}

std::uint8_t quantise_linear(float value) {
    return value > 0.0f ? static_cast<std::uint8_t>(std::min(value, 1.0f) * 255.0f + 0.5f) : std::uint8_t{0};
}

}  // namespace

float srgb_encode(float linear) {
    const double value = static_cast<double>(linear);
    return static_cast<float>(value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055);
}

float srgb_decode(float encoded) { return static_cast<float>(decode(static_cast<double>(encoded))); }

std::uint8_t quantise_srgb(float linear) { return quantising_table().code(linear); }

ByteImage quantise_srgb(const Image& image) {
    const QuantisingTable& table = quantising_table();
    ByteImage result{image.width, image.height, image.channels, std::vector<std::uint8_t>(image.pixels.size())};
    std::vector<std::uint8_t>& bytes = result.pixels;
    const std::size_t channels = static_cast<std::size_t>(image.channels);
    const std::size_t colors = has_alpha(image) ? channels - 1 : channels;
    for (std::size_t i = 0; i + channels <= bytes.size(); i += channels) {
        for (std::size_t c = 0; c < colors; ++c) {
            bytes[i + c] = table.code(image.pixels[i + c]);
        }
        if (colors < channels) {
            bytes[i + colors] = quantise_linear(image.pixels[i + colors]);
        }
    }
    return result;
}

Image without_alpha(const Image& image, bool as_rgb) {
    const std::size_t from = static_cast<std::size_t>(image.channels);
    const std::size_t colors = has_alpha(image) ? from - 1 : from;
    const std::size_t to = as_rgb ? 3 : colors;
    Image result{image.width, image.height, static_cast<int>(to), {}};
    result.pixels.reserve(image.pixels.size() / from * to);
    for (std::size_t i = 0; i + from <= image.pixels.size(); i += from) {
        for (std::size_t c = 0; c < to; ++c) {
            result.pixels.push_back(image.pixels[i + std::min(c, colors - 1)]);
        }
    }
    return result;
}

}  // namespace lancer
