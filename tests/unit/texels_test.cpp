// Pictures in the world's tables: what bytes become, and smaller copies of them.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "lancer/kernel/texture.h"
#include "lancer/world/mipmaps.h"
#include "lancer/world/texels.h"

namespace lancer {
namespace {

MipLevel noise(int width, int height) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    MipLevel level{width, height, {}};
    for (int i = 0; i < width * height * 4; ++i) {
        level.pixels.push_back(unit(random));
    }
    return level;
}

// The mean of a channel over a rectangle in pixels, by many points.
double mean_over(const MipLevel& level, int channel, double x0, double y0, double x1, double y1) {
    const int n = 240;
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < n; ++k) {
            const auto x = static_cast<int>(x0 + (x1 - x0) * (i + 0.5) / n);
            const auto y = static_cast<int>(y0 + (y1 - y0) * (k + 0.5) / n);
            sum += static_cast<double>(level.pixels[static_cast<std::size_t>((y * level.width + x) * 4 + channel)]);
        }
    }
    return sum / (n * n);
}

TEST(Mipmaps, EachPixelIsTheMeanOverWhatItCovers) {
    for (const auto& [width, height] : {std::pair(8, 8), std::pair(7, 5), std::pair(3, 2), std::pair(1, 9), std::pair(12, 1)}) {
        const MipLevel level = noise(width, height);
        const MipLevel half_size = half_as_large(level);
        ASSERT_EQ(half_size.width, std::max(width / 2, 1));
        ASSERT_EQ(half_size.height, std::max(height / 2, 1));
        const double step_x = static_cast<double>(width) / half_size.width;
        const double step_y = static_cast<double>(height) / half_size.height;
        for (int y = 0; y < half_size.height; ++y) {
            for (int x = 0; x < half_size.width; ++x) {
                const double expected = mean_over(level, 2, x * step_x, y * step_y, (x + 1) * step_x, (y + 1) * step_y);
                const float found = half_size.pixels[static_cast<std::size_t>((y * half_size.width + x) * 4 + 2)];
                EXPECT_NEAR(static_cast<double>(found), expected, 0.01) << width << " x " << height;
            }
        }
    }
}

StoredPixels bytes_of(int width, int height, int channels) {
    StoredPixels pixels{{width, height, channels, {}}, 8};
    for (int i = 0; i < width * height * channels; ++i) {
        pixels.image.pixels.push_back(static_cast<float>((i * 37) % 256) / 255.0f);
    }
    return pixels;
}

kernel::TextureRecord record_of(const StoredPixels& pixels, bool encoded) {
    kernel::TextureRecord texture{};
    texture.kind = kernel::TEXTURE_IMAGE;
    texture.storage = storage_of(pixels);
    texture.encoded = encoded ? 1 : 0;
    return texture;
}

TEST(Texels, BytesStayBytesAndComeBackAsLight) {
    for (const int channels : {1, 2, 3, 4}) {
        for (const bool encoded : {false, true}) {
            const StoredPixels pixels = bytes_of(13, 11, channels);
            World world;
            EXPECT_EQ(add_texels(pixels, encoded, false, world), 1);
            EXPECT_EQ(world.texels.size(), channels == 1 ? 36u : 143u) << "four grey ones share an int";
            const kernel::WorldRecord record = world.record();
            for (int i = 0; i < 143; ++i) {
                const kernel::vec4 found = kernel::stored_texel(record, record_of(pixels, encoded), i);
                const float* from = &pixels.image.pixels[static_cast<std::size_t>(i * channels)];
                const auto light = [&](float value) { return encoded ? srgb_decode(value) : value; };
                EXPECT_FLOAT_EQ(found.x, light(from[0]));
                EXPECT_FLOAT_EQ(found.z, light(channels >= 3 ? from[2] : from[0]));
                EXPECT_FLOAT_EQ(found.w, channels == 4 ? from[3] : channels == 2 ? from[1] : 1.0f) << "alpha is never encoded";
            }
        }
    }
}

TEST(Texels, SmallerCopiesAreMeansOfLight) {
    // Black and white in turn: half of the light is 188 as sRGB, not 128.
    StoredPixels pixels{{4, 4, 3, {}}, 8};
    for (int i = 0; i < 16; ++i) {
        for (int c = 0; c < 3; ++c) {
            pixels.image.pixels.push_back((i + i / 4) % 2 == 0 ? 1.0f : 0.0f);
        }
    }
    World world;
    EXPECT_EQ(add_texels(pixels, true, true, world), 3);
    EXPECT_EQ(world.levels, (std::vector<int>{0, 4, 4, 16, 2, 2, 20, 1, 1}));
    EXPECT_EQ(world.texels.back() & 255, 188);
    EXPECT_NEAR(kernel::stored_texel(world.record(), record_of(pixels, true), 20).x, 0.5f, 0.005f);
}

TEST(Texels, OddSizesAndFloats) {
    StoredPixels pixels{{5, 3, 1, {}}, 0};
    for (int i = 0; i < 15; ++i) {
        pixels.image.pixels.push_back(static_cast<float>(i));
    }
    World world;
    EXPECT_EQ(add_texels(pixels, false, true, world), 3);
    EXPECT_EQ(world.levels, (std::vector<int>{0, 5, 3, 15, 2, 1, 17, 1, 1}));
    EXPECT_NEAR(world.float_texels.back(), 7.0f, 1e-5f) << "the mean of all";
}

// A picture whose smallest copy is its mean, looked up through a beam as wide as all of it.
TEST(Texels, AWideBeamSeesTheMean) {
    StoredPixels pixels = bytes_of(64, 64, 3);
    World world;
    kernel::TextureRecord texture = record_of(pixels, false);
    texture.level_count = add_texels(pixels, false, true, world);
    texture.look = kernel::LOOK_MIPMAPS;
    texture.row_u = {1.0f, 0.0f, 0.0f};
    texture.row_v = {0.0f, 1.0f, 0.0f};
    texture.size = 1.0f;
    double sum = 0.0;
    for (std::size_t i = 0; i < pixels.image.pixels.size(); i += 3) {
        sum += static_cast<double>(pixels.image.pixels[i]);
    }
    kernel::SurfacePoint point = kernel::no_surface();
    point.uv = {0.3f, 0.8f};
    point.across = {1.0f, 0.0f};
    point.down = {0.0f, 1.0f};
    EXPECT_NEAR(kernel::texture_color(world.record(), texture, point, true).x, sum / 4096.0, 0.01);
    // Longer one way: the mean along that way, with the detail of the other.
    point.across = {1.0f, 0.0f};
    point.down = {0.0f, 1.0f / 8.0f};
    const float one_row = kernel::texture_color(world.record(), texture, point, true).x;
    double rows = 0.0;
    for (int y = 8; y < 16; ++y) {  // v = 0.8 is row 12.8 from above
        for (int x = 0; x < 64; ++x) {
            rows += static_cast<double>(pixels.image.pixels[static_cast<std::size_t>((y * 64 + x) * 3)]);
        }
    }
    EXPECT_NEAR(one_row, rows / 512.0, 0.04);
}

// The mean of a checker over a patch, against many points in it.
TEST(Checkers, AreAveragedOverWhatABeamCovers) {
    World world;
    kernel::TextureRecord texture{};
    texture.kind = kernel::TEXTURE_CHECKER_UV;
    texture.first = {1.0f, 0.5f, 0.25f};
    texture.size = 0.5f;
    texture.row_u = {1.0f, 0.0f, 0.0f};
    texture.row_v = {0.0f, 1.0f, 0.0f};
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    for (int i = 0; i < 50; ++i) {
        kernel::SurfacePoint point = kernel::no_surface();
        point.uv = {10.0f * unit(random) - 5.0f, 10.0f * unit(random) - 5.0f};
        point.across = {2.0f * unit(random), 0.0f};
        point.down = {0.0f, 2.0f * unit(random)};
        double sum = 0.0;
        const int n = 300;
        for (int a = 0; a < n; ++a) {
            for (int b = 0; b < n; ++b) {
                const double u = static_cast<double>(point.uv.x) + static_cast<double>(point.across.x) * ((a + 0.5) / n - 0.5);
                const double v = static_cast<double>(point.uv.y) + static_cast<double>(point.down.y) * ((b + 0.5) / n - 0.5);
                const auto cells = static_cast<long>(std::floor(u / 0.5)) + static_cast<long>(std::floor(v / 0.5));
                sum += cells % 2 == 0 ? 1.0 : 0.0;
            }
        }
        EXPECT_NEAR(kernel::texture_color(world.record(), texture, point, true).x, sum / (n * n), 0.01);
    }
}

}  // namespace
}  // namespace lancer
