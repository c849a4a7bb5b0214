#include "lancer/image/layers.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "lancer/base/failure.h"
#include "lancer/image/cryptomatte.h"
#include "temporary_folder.h"

namespace {

using namespace lancer;
namespace fs = std::filesystem;

class Layers : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder_.file(name); }
    std::string bytes(const std::string& name) const { return folder_.read(name); }
    // What reading it throws.
    std::string complaint(const std::string& name) const {
        try {
            read_layers(path(name));
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    }

    tests::TemporaryFolder folder_;
};

Channel ramp(const std::string& name, Stored stored, int count, float scale) {
    Channel channel{name, stored, {}, {}};
    for (int i = 0; i < count; ++i) {
        channel.values.push_back(static_cast<float>(i) * scale);
    }
    return channel;
}

LayeredImage many() {
    LayeredImage image{5, 4, {}, {{"lancer:command", "lancer render x.toml"}, {"compression", "a taken key"}}};
    image.channels = {ramp("R", Stored::half, 20, 0.25f),          ramp("G", Stored::half, 20, 0.5f),
                      ramp("B", Stored::half, 20, 1.0f),           ramp("normal.X", Stored::float32, 20, 0.1f),
                      ramp("depth.Z", Stored::float32, 20, 1e30f), ramp("S0.400,000000nm", Stored::half, 20, 0.125f)};
    Channel ids{"id", Stored::uint32, {}, {}};
    for (std::uint32_t i = 0; i < 20; ++i) {
        ids.numbers.push_back(0xffffffffu - i);
    }
    image.channels.push_back(ids);
    return image;
}

TEST_F(Layers, AreReadAsWritten) {
    const LayeredImage image = many();
    write_layers(path("a.exr"), image);
    const LayeredImage read = read_layers(path("a.exr"));
    EXPECT_EQ(read.width, 5);
    EXPECT_EQ(read.height, 4);
    EXPECT_FALSE(read.display);
    ASSERT_EQ(read.channels.size(), image.channels.size());
    for (const Channel& channel : image.channels) {
        const Channel* found = find_channel(read, channel.name);
        ASSERT_NE(found, nullptr) << channel.name;
        EXPECT_EQ(found->stored, channel.stored) << channel.name;
        EXPECT_EQ(found->values, channel.values) << channel.name;
        EXPECT_EQ(found->numbers, channel.numbers) << channel.name;
    }
    EXPECT_EQ(find_channel(read, "albedo.R"), nullptr);
    EXPECT_EQ(read.metadata.at("lancer:command"), "lancer render x.toml");
    EXPECT_EQ(read.metadata.at("text:compression"), "a taken key");
}

TEST_F(Layers, HaveTheSameBytesInAnyOrder) {
    LayeredImage image = many();
    write_layers(path("a.exr"), image);
    std::reverse(image.channels.begin(), image.channels.end());
    write_layers(path("b.exr"), image);
    EXPECT_FALSE(bytes("a.exr").empty());
    EXPECT_TRUE(bytes("a.exr") == bytes("b.exr"));
}

TEST_F(Layers, ThatOverflowAHalfAreWidenedAsAWhole) {
    LayeredImage image{2, 1, {}, {}};
    image.channels = {{"R", Stored::half, {1.0f, 2.0f}, {}},
                      {"light.R", Stored::half, {1.0f, 70000.0f}, {}},
                      {"light.G", Stored::half, {0.5f, std::numeric_limits<float>::infinity()}, {}}};
    write_layers(path("a.exr"), image);
    const LayeredImage read = read_layers(path("a.exr"));
    EXPECT_EQ(find_channel(read, "R")->stored, Stored::half);
    EXPECT_EQ(find_channel(read, "light.R")->stored, Stored::float32);
    EXPECT_EQ(find_channel(read, "light.G")->stored, Stored::float32);
    EXPECT_EQ(find_channel(read, "light.R")->values[1], 70000.0f);
    EXPECT_TRUE(std::isinf(find_channel(read, "light.G")->values[1]));
}

TEST_F(Layers, MeetThePicturesOfTheOtherWriter) {
    const Image image{2, 2, 3, {0.0f, 0.25f, 0.5f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f, 8.0f, 9.0f}};
    write_image(path("a.exr"), image, {});
    EXPECT_EQ(picture_of(read_layers(path("a.exr")), {"R", "G", "B"}).pixels, image.pixels);
    write_layers(path("b.exr"), read_layers(path("a.exr")));
    EXPECT_EQ(read_image(path("b.exr")).pixels, image.pixels);
    EXPECT_TRUE(bytes("a.exr") == bytes("b.exr"));  // one way to write them
}

TEST_F(Layers, AreAlsoFoundInOtherFormats) {
    const ByteImage image{2, 1, 4, {0, 128, 255, 7, 3, 2, 1, 255}};
    write_image(path("a.png"), image, {});
    const LayeredImage read = read_layers(path("a.png"));
    EXPECT_TRUE(read.display);
    EXPECT_FLOAT_EQ(find_channel(read, "G")->values[0], srgb_decode(128.0f / 255.0f));
    EXPECT_FLOAT_EQ(find_channel(read, "A")->values[0], 7.0f / 255.0f);
    write_image(path("a.hdr"), Image{1, 1, 3, {1.0f, 2.0f, 4.0f}}, {});
    EXPECT_FALSE(read_layers(path("a.hdr")).display);
    EXPECT_EQ(picture_of(read_layers(path("a.hdr")), {"B", "nothing"}).pixels, (std::vector<float>{4.0f, 0.0f}));
}

TEST_F(Layers, ThatAreBrokenAreRefusedInWords) {
    EXPECT_EQ(complaint("none.exr"), "cannot read the image " + path("none.exr") + ": there is no such file");
    std::ofstream(path("text.exr")) << "not a picture";
    EXPECT_NE(complaint("text.exr").find("no image format that lancer knows"), std::string::npos);
    write_layers(path("whole.exr"), many());
    const std::string whole = bytes("whole.exr");
    // Cut anywhere, or with any byte changed, it is read or refused; nothing worse.
    for (std::size_t length = 4; length < whole.size(); length += 7) {
        std::ofstream(path("cut.exr"), std::ios::binary) << whole.substr(0, length);
        EXPECT_NE(complaint("cut.exr").find("cannot read the image " + path("cut.exr") + ": "), std::string::npos) << length;
    }
    for (std::size_t i = 4; i < whole.size(); i += 3) {
        std::string changed = whole;
        changed[i] = static_cast<char>(changed[i] ^ 0x55);
        std::ofstream(path("changed.exr"), std::ios::binary) << changed;
        complaint("changed.exr");
    }
}

TEST_F(Layers, CantBeWrittenToOtherFormatsOrNowhere) {
    EXPECT_THROW(write_layers(path("a.png"), many()), MachineFailure);
    EXPECT_THROW(write_layers(path("nowhere/a.exr"), many()), MachineFailure);
    EXPECT_TRUE(fs::is_empty(folder_.path()));
}

// Files by another program. The value of channel c at x, y is x + 100 y + 10000 c, as far as a half holds it.
std::string foreign(const std::string& name) { return std::string(LANCER_SOURCE_FOLDER "/tests/unit/pictures/") + name; }

float foreign_value(int channel, std::size_t pixel) {
    return static_cast<float>(pixel % 20) + 100.0f * static_cast<float>(pixel / 20) + 10000.0f * static_cast<float>(channel);
}

// 8 x 8 tiles, one type a channel, and a data window that starts at 3,-2 of a larger picture.
TEST(ForeignLayers, MayBeTiled) {
    const LayeredImage image = read_layers(foreign("tiled.exr"));
    ASSERT_EQ(image.width, 20);
    ASSERT_EQ(image.height, 12);
    ASSERT_EQ(image.channels.size(), 3u);
    for (std::size_t i = 0; i < 240; ++i) {
        EXPECT_EQ(find_channel(image, "R")->values[i], foreign_value(0, i));
        EXPECT_EQ(find_channel(image, "depth.Z")->values[i], foreign_value(1, i));
        EXPECT_EQ(find_channel(image, "id")->numbers[i], 0xffffffffu);  // more than a float holds
    }
    EXPECT_EQ(find_channel(image, "R")->stored, Stored::half);
}

// Two parts of one size, both with R, G and B, and a smaller one.
TEST(ForeignLayers, MayComeInParts) {
    const LayeredImage image = read_layers(foreign("parts.exr"));
    ASSERT_EQ(image.channels.size(), 6u);
    const char* const names[] = {"R", "G", "B", "albedo.R", "albedo.G", "albedo.B"};
    for (int c = 0; c < 6; ++c) {
        const Channel* channel = find_channel(image, names[c]);
        ASSERT_NE(channel, nullptr) << names[c];
        EXPECT_EQ(channel->values[57], foreign_value(c, 57)) << names[c];
    }
}

// The values that the specification's own tests state.
TEST(Cryptomatte, HashesNamesAsSpecified) {
    EXPECT_EQ(cryptomatte_id("hello"), 6.0705627102400005616e-17f);
    EXPECT_EQ(cryptomatte_id("\xd1\x80\xd0\xb0\xd0\xb2\xd0\xbd\xd0\xb8\xd0\xbd\xd0\xb0"), -1.3192631212399999468e-25f);
    EXPECT_EQ(cryptomatte_id("m\xc3\xa4"
                             "dchen"),
              6.2361298211599995797e+25f);
    // SMHasher's own check of the 32-bit variant: hashes of 0, 1, ... 255 bytes, hashed.
    std::string keys, hashes;
    for (std::uint32_t i = 0; i < 256; ++i) {
        const std::uint32_t hash = murmur3_32(keys, 256 - i);
        hashes.append(reinterpret_cast<const char*>(&hash), 4);
        keys += static_cast<char>(i);
    }
    EXPECT_EQ(murmur3_32(hashes), 0xb0f57ee3u);
}

TEST(Cryptomatte, NeverMakesAnIdThatIsNoOrdinaryNumber) {
    int turned = 0;
    for (int i = 0; i < 5000; ++i) {
        const std::string name = "object " + std::to_string(i);
        EXPECT_TRUE(std::isnormal(cryptomatte_id(name))) << name;
        turned += cryptomatte_bits(name) != murmur3_32(name) ? 1 : 0;
    }
    EXPECT_GT(turned, 0);  // 1 of 128
}

TEST(Cryptomatte, DescribesItself) {
    const Metadata metadata = cryptomatte_metadata("CryptoObject", {"b", "say \"a\""});
    ASSERT_EQ(metadata.size(), 4u);
    const std::string key = metadata.begin()->first.substr(0, 20);
    EXPECT_EQ(metadata.at(key + "name"), "CryptoObject");
    EXPECT_EQ(metadata.at(key + "hash"), "MurmurHash3_32");
    EXPECT_EQ(metadata.at(key + "conversion"), "uint32_to_float32");
    EXPECT_EQ(metadata.at(key + "manifest").substr(0, 6), "{\"b\":\"");
    EXPECT_NE(metadata.at(key + "manifest").find("\"say \\\"a\\\"\":\""), std::string::npos);
}

TEST_F(Layers, KeepTheIdsOfMattes) {
    const float a = cryptomatte_id("a"), b = cryptomatte_id("b"), c = cryptomatte_id("c");
    LayeredImage image{2, 1, cryptomatte_channels("CryptoObject", 2, {{{a, 0.25f}, {b, 0.5f}, {c, 0.125f}}, {}}), {}};
    write_layers(path("a.exr"), image);
    const LayeredImage read = read_layers(path("a.exr"));
    ASSERT_EQ(read.channels.size(), 4u);
    const auto at = [&](const char* part) { return find_channel(read, std::string("CryptoObject00.") + part)->values[0]; };
    EXPECT_EQ(std::bit_cast<std::uint32_t>(at("R")), cryptomatte_bits("b"));
    EXPECT_EQ(at("G"), 0.5f);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(at("B")), cryptomatte_bits("a"));
    EXPECT_EQ(at("A"), 0.25f);
    EXPECT_EQ(find_channel(read, "CryptoObject00.R")->values[1], 0.0f);
}

}  // namespace
