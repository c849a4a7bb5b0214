#include "lancer/image/hdr.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lancer/image/encode.h"

namespace lancer {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

// Mantissas of eight bits under the exponent of the largest, biased by 128 [Ward 1991]: value = mantissa * 2^(exponent - 136).
Rgbe to_rgbe(const float* rgb) {
    std::array<float, 3> color;
    for (std::size_t c = 0; c < 3; ++c) {
        color[c] = rgb[c] > 0.0f ? std::min(rgb[c], 0x1.fdp126f) : 0.0f;  // NaN is not above 0
    }
    const float largest = std::max({color[0], color[1], color[2]});
    if (largest < 0x1p-127f) {
        return {};
    }
    int exponent = 0;
    std::frexp(largest, &exponent);
    if (std::lround(std::ldexp(largest, 8 - exponent)) == 256) {
        ++exponent;
    }
    Rgbe result{};
    for (std::size_t c = 0; c < 3; ++c) {
        result[c] = static_cast<std::uint8_t>(std::lround(std::ldexp(color[c], 8 - exponent)));
    }
    result[3] = static_cast<std::uint8_t>(exponent + 128);
    return result;
}

// Runs as 128 + length and the value, everything else as a length of at most 128 and the values.
void append_packed(std::string& bytes, const std::vector<std::uint8_t>& values) {
    constexpr std::size_t shortest_run = 4, longest_run = 127, longest_dump = 128;
    const std::size_t count = values.size();
    const auto run_at = [&](std::size_t start) {
        std::size_t end = start + 1;
        while (end < count && end - start < longest_run && values[end] == values[start]) {
            ++end;
        }
        return end - start;
    };
    for (std::size_t at = 0; at < count;) {
        std::size_t run_start = at, run = 0;
        while (run_start < count && run_start - at < longest_dump && (run = run_at(run_start)) < shortest_run) {
            run_start += run;
        }
        const std::size_t dump = std::min(run_start - at, longest_dump);
        if (dump > 0) {
            bytes += static_cast<char>(dump);
            bytes.append(reinterpret_cast<const char*>(values.data() + at), dump);
            at += dump;
        } else {
            bytes += static_cast<char>(128 + run);
            bytes += static_cast<char>(values[at]);
            at += run;
        }
    }
}

std::string one_line(std::string_view text) {
    std::string line(text);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r' || c == '\0'; }, ' ');
    return line;
}

}  // namespace

std::string encode_hdr(const Image& image, const Metadata& metadata) {
    const Image rgb = without_alpha(image, true);
    std::string bytes = "#?RADIANCE\n";
    for (const auto& [key, value] : metadata) {
        bytes += one_line(key == "Software" ? "SOFTWARE" : key) + "=" + one_line(value) + "\n";
    }
    bytes += "PRIMARIES=0.64 0.33 0.30 0.60 0.15 0.06 0.3127 0.3290\nFORMAT=32-bit_rle_rgbe\n\n";
    bytes += fmt::format("-Y {} +X {}\n", image.height, image.width);

    const std::size_t width = static_cast<std::size_t>(image.width);
    const bool packed = width >= 8 && width <= 32767;
    std::vector<Rgbe> row(width);
    std::vector<std::uint8_t> component(width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            row[x] = to_rgbe(rgb.pixels.data() + 3 * (y * width + x));
        }
        if (!packed) {
            bytes.append(reinterpret_cast<const char*>(row.data()), 4 * width);
            continue;
        }
        bytes += {'\2', '\2', static_cast<char>(width >> 8), static_cast<char>(width & 0xff)};
        for (std::size_t c = 0; c < 4; ++c) {
            std::transform(row.begin(), row.end(), component.begin(), [c](const Rgbe& pixel) { return pixel[c]; });
            append_packed(bytes, component);
        }
    }
    return bytes;
}

}  // namespace lancer
