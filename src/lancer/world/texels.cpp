#include "lancer/world/texels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "lancer/world/mipmaps.h"

namespace lancer {

namespace {

// The byte whose light is nearest: found among the middles between neighbours, so that every byte comes back as itself.
class Encoder {
public:
    Encoder() {
        for (int i = 0; i < 255; ++i) {
            middles_[static_cast<std::size_t>(i)] =
                0.5f * (srgb_decode(static_cast<float>(i) / 255.0f) + srgb_decode(static_cast<float>(i + 1) / 255.0f));
        }
        middles_.back() = std::numeric_limits<float>::infinity();
        std::size_t byte = 0;
        for (std::size_t i = 0; i < steps; ++i) {
            while (middles_[byte] <= static_cast<float>(i) / steps) {
                ++byte;
            }
            first_[i] = static_cast<std::uint8_t>(byte);
        }
    }

    std::uint32_t encode(float linear) const {
        std::size_t byte = first_[static_cast<std::size_t>(std::clamp(linear * steps, 0.0f, steps - 1.0f))];
        while (middles_[byte] <= linear) {
            ++byte;
        }
        return static_cast<std::uint32_t>(byte);
    }

private:
    static constexpr int steps = 4096;  // hardly more than one byte begins in each
    std::array<float, 256> middles_{};
    std::array<std::uint8_t, steps> first_{};
};

std::uint32_t to_byte(float value) { return static_cast<std::uint32_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f); }

class Writer {
public:
    Writer(int storage, bool encoded, World& world) : storage_(storage), encoded_(encoded), world_(world) {}

    void write(const MipLevel& level) {
        const std::size_t count = level.pixels.size() / 4;
        const bool bytes = storage_ == kernel::TEXELS_GREY8 || storage_ == kernel::TEXELS_RGBA8;
        const std::size_t in_an_int = storage_ == kernel::TEXELS_GREY8 ? 4 : 1;
        const std::size_t first = bytes ? world_.texels.size() * in_an_int : world_.float_texels.size() / values();
        if ((first + count) * values() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
            throw std::runtime_error("the scene's images together have more pixels than can be numbered");
        }
        world_.levels.push_back(static_cast<int>(first));
        world_.levels.push_back(level.width);
        world_.levels.push_back(level.height);
        if (bytes) {
            write_bytes(level, count, in_an_int);
        } else {
            for (std::size_t i = 0; i < count; ++i) {
                world_.float_texels.insert(world_.float_texels.end(), &level.pixels[4 * i], &level.pixels[4 * i] + values());
            }
        }
    }

private:
    std::size_t values() const { return storage_ == kernel::TEXELS_RGBA_FLOAT ? 4 : 1; }

    std::uint32_t color_byte(float value) const { return encoded_ ? encoder_.encode(value) : to_byte(value); }

    void write_bytes(const MipLevel& level, std::size_t count, std::size_t in_an_int) {
        world_.texels.reserve(world_.texels.size() + count / in_an_int + 1);
        for (std::size_t i = 0; i < count; i += in_an_int) {
            std::uint32_t word = 0;
            if (in_an_int == 4) {
                for (std::size_t k = 0; k < 4 && i + k < count; ++k) {
                    word |= color_byte(level.pixels[4 * (i + k)]) << (8 * k);
                }
            } else {
                const float* p = &level.pixels[4 * i];
                word = color_byte(p[0]) | color_byte(p[1]) << 8 | color_byte(p[2]) << 16 | to_byte(p[3]) << 24;
            }
            world_.texels.push_back(static_cast<int>(word));
        }
    }

    int storage_;
    bool encoded_;
    World& world_;
    Encoder encoder_;
};

}  // namespace

int storage_of(const StoredPixels& pixels) {
    const bool grey = pixels.image.channels == 1;
    if (pixels.bits == 8) {
        return grey ? kernel::TEXELS_GREY8 : kernel::TEXELS_RGBA8;
    }
    return grey ? kernel::TEXELS_GREY_FLOAT : kernel::TEXELS_RGBA_FLOAT;
}

int add_texels(const StoredPixels& pixels, bool encoded, bool halves, World& world) {
    const Image& image = pixels.image;
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    // Bytes are few: each is decoded once.
    std::array<float, 256> decoded{};
    for (int i = 0; i < 256; ++i) {
        decoded[static_cast<std::size_t>(i)] = srgb_decode(static_cast<float>(i) / 255.0f);
    }
    const auto light = [&](float stored) {
        if (!encoded) {
            return stored;
        }
        return pixels.bits == 8 ? decoded[to_byte(stored)] : srgb_decode(stored);
    };
    MipLevel level{image.width, image.height, std::vector<float>(count * 4)};
    for (std::size_t i = 0; i < count; ++i) {
        const float* from = &image.pixels[i * channels];
        float* to = &level.pixels[i * 4];
        for (std::size_t c = 0; c < 3; ++c) {
            to[c] = channels >= 3 || c == 0 ? light(from[channels >= 3 ? c : 0]) : to[0];
        }
        to[3] = channels == 4 ? from[3] : channels == 2 ? from[1] : 1.0f;
    }
    if (encoded && pixels.bits == 8 && world.decoding.empty()) {
        world.decoding.assign(decoded.begin(), decoded.end());
    }
    Writer writer(storage_of(pixels), encoded && pixels.bits == 8, world);
    writer.write(level);
    int levels = 1;
    while (halves && (level.width > 1 || level.height > 1)) {
        level = half_as_large(level);
        writer.write(level);
        ++levels;
    }
    return levels;
}

}  // namespace lancer
