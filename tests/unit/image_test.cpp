#include "lancer/image/image.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <thread>

#include "lancer/base/failure.h"
#include "lancer/image/encode.h"
#include "lancer/image/images_module.h"
#include "lancer/image/replace_file.h"
#include "temporary_folder.h"

namespace {

using namespace lancer;
namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void put(const fs::path& path, std::string_view bytes) { std::ofstream(path, std::ios::binary) << bytes; }

// Hard to pack.
Image noise(int width, int height) {
    Image image{width, height, 3, std::vector<float>(static_cast<std::size_t>(3 * width * height))};
    std::uint32_t state = 1;
    for (float& value : image.pixels) {
        state = state * 1664525u + 1013904223u;
        value = static_cast<float>(state >> 8) * 0x1p-24f;
    }
    return image;
}

// What `action` throws, or nothing.
template <class Exception, class Action>
std::string message_of(Action action) {
    try {
        action();
    } catch (const Exception& error) {
        return error.what();
    }
    return "";
}

class ImageFiles : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder_.file(name); }
    std::size_t files() const { return folder_.names().size(); }

    tests::TemporaryFolder folder_;
};

// Every channel and pixel different, so that a swap shows.
Image gradient(int width, int height, int channels) {
    Image image{width, height, channels, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < channels; ++c) {
                image.pixels.push_back(static_cast<float>(1 + x + 7 * y + 3 * c) / static_cast<float>(width + 7 * height + 3 * channels));
            }
        }
    }
    return image;
}

TEST(Srgb, CurveHasTheValuesOfTheStandard) {
    EXPECT_FLOAT_EQ(srgb_encode(0.0f), 0.0f);
    EXPECT_FLOAT_EQ(srgb_encode(1.0f), 1.0f);
    EXPECT_NEAR(srgb_encode(0.18f), 0.461356f, 1e-6f);
    EXPECT_NEAR(srgb_encode(0.0031308f), 0.04045f, 1e-6f);
    EXPECT_NEAR(srgb_decode(0.5f), 0.214041f, 1e-6f);
    for (int i = -100; i <= 1000; ++i) {
        const float value = static_cast<float>(i) / 500.0f;
        EXPECT_NEAR(srgb_decode(srgb_encode(value)), value, 1e-6f);
    }
}

TEST(Srgb, QuantisingIsTheRoundedCurve) {
    const auto expected = [](float v) {
        const double linear = static_cast<double>(v);
        const double curve = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
        return static_cast<int>(std::floor(255.0 * curve + 0.5));
    };
    int differences = 0;
    for (int i = 0; i <= 200000; ++i) {
        const float value = static_cast<float>(i) / 200000.0f;
        differences += quantise_srgb(value) != expected(value);
    }
    EXPECT_EQ(differences, 0);
    for (float value = 1e-6f; value < 1.0f; value *= 1.001f) {
        EXPECT_EQ(quantise_srgb(value), expected(value)) << value;
    }
    for (int code = 0; code < 256; ++code) {
        EXPECT_EQ(quantise_srgb(srgb_decode(static_cast<float>(code) / 255.0f)), code);
    }
    EXPECT_EQ(quantise_srgb(-1.0f), 0);
    EXPECT_EQ(quantise_srgb(7.0f), 255);
    EXPECT_EQ(quantise_srgb(std::numeric_limits<float>::infinity()), 255);
    EXPECT_EQ(quantise_srgb(-std::numeric_limits<float>::infinity()), 0);
    EXPECT_EQ(quantise_srgb(std::nanf("")), 0);
    EXPECT_EQ(quantise_srgb(std::nextafter(1.0f, 0.0f)), 255);
}

TEST(Srgb, AlphaIsNotEncoded) {
    const ByteImage bytes = quantise_srgb(Image{1, 1, 4, {0.5f, 0.5f, 0.5f, 0.5f}});
    EXPECT_EQ(bytes.pixels, (std::vector<std::uint8_t>{188, 188, 188, 128}));
}

TEST_F(ImageFiles, RoundTripsThroughEveryFormat) {
    struct Format {
        const char* name;
        double tolerance;
        int most_channels;  // that survive
    };
    for (const Format& format : {Format{"a.png", 0.005, 4},
                                 {"a.exr", 5e-4, 4},
                                 {"a.hdr", 0.005, 3},
                                 {"a.tif", 0.0, 4},
                                 {"a.TIFF", 0.0, 4},
                                 {"a.jpg", 0.03, 3},
                                 {"a.jpeg", 0.03, 3}}) {
        for (int channels = 1; channels <= 4; ++channels) {
            const Image image = gradient(37, 23, channels);
            write_image(path(format.name), image, {});
            const Image read = read_image(path(format.name));
            ASSERT_EQ(read.width, 37);
            ASSERT_EQ(read.height, 23);
            const bool grey = channels <= 2;
            const bool hdr = std::string(format.name) == "a.hdr";
            const int expected = hdr ? 3 : format.most_channels == 3 ? (grey ? 1 : 3) : channels;
            ASSERT_EQ(read.channels, expected) << format.name << " from " << channels;
            double worst = 0.0;
            for (std::size_t i = 0; i < 37u * 23u; ++i) {
                for (std::size_t c = 0; c < static_cast<std::size_t>(read.channels); ++c) {
                    const std::size_t from = hdr && grey ? 0 : c;
                    const float was = image.pixels[i * static_cast<std::size_t>(channels) + from];
                    worst =
                        std::max(worst, std::fabs(static_cast<double>(was - read.pixels[i * static_cast<std::size_t>(read.channels) + c])));
                }
            }
            EXPECT_LE(worst, format.tolerance) << format.name << " from " << channels;
        }
    }
}

TEST_F(ImageFiles, SameImageSameBytes) {
    const Metadata metadata = {{"Software", "lancer 0.1"}, {"lancer:command", "lancer render scene.toml"}};
    for (const std::string& ending : writable_endings()) {
        write_image(path("a" + ending), gradient(20, 10, 3), metadata);
        const std::string first = bytes_of(path("a" + ending));
        write_image(path("a" + ending), gradient(20, 10, 3), metadata);
        EXPECT_EQ(bytes_of(path("a" + ending)), first) << ending;
        EXPECT_GT(first.size(), 200u);
    }
    EXPECT_NE(bytes_of(path("a.tif")).find("1970:01:01 00:00:00"), std::string::npos);  // it insists on a date
}

TEST_F(ImageFiles, MetadataIsInTheFile) {
    const std::string command = "lancer render \"scène.toml\" -o a";
    const Metadata metadata = {
        {"Software", "lancer 1.2.3"}, {"lancer:command", command}, {"lancer:hash", "0123abcd"}, {"channels", "many"}};
    for (const char* ending : {".png", ".exr", ".tif", ".jpg", ".hdr"}) {
        write_image(path(std::string("a") + ending), gradient(16, 16, 3), metadata);
        const std::string bytes = bytes_of(path(std::string("a") + ending));
        for (const char* words : {"Software", "lancer 1.2.3", "lancer:command", command.c_str(), "lancer:hash", "0123abcd", "many"}) {
            const bool spelled = ending == std::string(".png") || ending == std::string(".exr");
            if (std::strcmp(words, "Software") == 0 && !spelled) {
                continue;  // a number, or in capitals
            }
            EXPECT_NE(bytes.find(words), std::string::npos) << words << " in " << ending;
        }
        EXPECT_EQ(read_image(path(std::string("a") + ending)).width, 16);
    }
}

TEST_F(ImageFiles, PngSaysThatItIsSrgb) {
    write_image(path("a.png"), gradient(4, 4, 3), {});
    const std::string bytes = bytes_of(path("a.png"));
    EXPECT_NE(bytes.find("sRGB"), std::string::npos);
    EXPECT_EQ(bytes.find("tIME"), std::string::npos);
}

TEST_F(ImageFiles, ExrKeepsWhatHalfCannotHold) {
    Image image = gradient(4, 4, 3);
    image.pixels[5] = 1e6f;
    image.pixels[6] = -0.25f;
    write_image(path("a.exr"), image, {});
    const Image read = read_image(path("a.exr"));
    EXPECT_EQ(read.pixels, image.pixels);  // 32-bit floats, then
    image.pixels[5] = std::numeric_limits<float>::infinity();
    write_image(path("b.exr"), image, {});
    EXPECT_TRUE(std::isinf(read_image(path("b.exr")).pixels[5]));
    EXPECT_LT(fs::file_size(path("b.exr")), fs::file_size(path("a.exr")));
}

TEST_F(ImageFiles, HdrHoldsEveryWidthAndRange) {
    for (const int width : {1, 7, 8, 9, 127, 128, 129, 300, 1000}) {
        Image image = gradient(width, 3, 3);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            image.pixels[i] =
                (i / 3) % 50 < 20 ? 0.5f : image.pixels[i] * std::ldexp(1.0f, static_cast<int>(i / 3 % 80) - 40);  // runs, too
        }
        write_image(path("a.hdr"), image, {});
        const Image read = read_image(path("a.hdr"));
        ASSERT_EQ(read.width, width);
        for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
            const float largest = std::max({image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]});
            for (std::size_t c = 0; c < 3; ++c) {
                ASSERT_NEAR(read.pixels[i + c], image.pixels[i + c], largest / 255.0f) << width << " at " << i;
            }
        }
    }
    const float infinite = std::numeric_limits<float>::infinity();
    write_image(path("b.hdr"), Image{2, 1, 3, {infinite, -infinite, std::nanf(""), -1.0f, 1e-44f, 3e38f}}, {});
    const Image odd = read_image(path("b.hdr"));
    EXPECT_GT(odd.pixels[0], 1e38f);
    EXPECT_EQ(odd.pixels[1], 0.0f);
    EXPECT_EQ(odd.pixels[2], 0.0f);
    EXPECT_EQ(odd.pixels[3], 0.0f);
    EXPECT_GT(odd.pixels[5], 1e38f);
}

TEST_F(ImageFiles, EncodingCanBeTold) {
    write_image(path("a.png"), Image{1, 1, 2, {0.5f, 0.5f}}, {});
    const Image automatic = read_image(path("a.png"));
    const Image linear = read_image(path("a.png"), Encoding::linear);
    EXPECT_NEAR(automatic.pixels[0], 0.5f, 0.005f);
    EXPECT_FLOAT_EQ(linear.pixels[0], 188.0f / 255.0f);
    EXPECT_NEAR(automatic.pixels[1], 0.5f, 0.005f);
    EXPECT_EQ(automatic.pixels[1], linear.pixels[1]);  // alpha
    write_image(path("a.exr"), Image{1, 1, 1, {0.5f}}, {});
    EXPECT_EQ(read_image(path("a.exr")).pixels[0], 0.5f);
    EXPECT_FLOAT_EQ(read_image(path("a.exr"), Encoding::srgb).pixels[0], srgb_decode(0.5f));
}

// Three pixels of a palette with transparency; two of 16-bit grey, 0x8000 and 1; eight of 1-bit grey, 1011 0000.
TEST_F(ImageFiles, PngKindsThatWeDoNotWrite) {
    using namespace std::string_view_literals;
    put(path("palette.png"),
        "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x03\x00\x00\x00\x01\x02\x03\x00\x00\x00\x66"
        "\x8e\xfc\x27\x00\x00\x00\x09\x50\x4c\x54\x45\xff\x00\x00\x00\xff\x00\x0a\x14\x1e\xd9\x7e\x4d\xe7\x00\x00\x00\x02\x74\x52"
        "\x4e\x53\xff\x80\x08\x0f\xb3\x6a\x00\x00\x00\x0a\x49\x44\x41\x54\x78\xda\x63\x90\x00\x00\x00\x1a\x00\x19\x80\x00\x8e\xbb"
        "\x00\x00\x00\x00\x49\x45\x4e\x44\xae\x42\x60\x82"sv);
    const Image palette = read_image(path("palette.png"), Encoding::linear);
    ASSERT_EQ(palette.channels, 4);
    ASSERT_EQ(palette.width, 3);
    const std::vector<float> expected = {1, 0, 0, 1, 0, 1, 0, 128.0f / 255.0f, 10.0f / 255.0f, 20.0f / 255.0f, 30.0f / 255.0f, 1};
    EXPECT_EQ(palette.pixels, expected);

    put(path("grey.png"),
        "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x02\x00\x00\x00\x01\x10\x00\x00\x00\x00\x81"
        "\xd9\xfc\x15\x00\x00\x00\x0d\x49\x44\x41\x54\x78\xda\x63\x68\x60\x60\x60\x04\x00\x02\x06\x00\x82\x2e\x10\xf1\xfa\x00\x00"
        "\x00\x00\x49\x45\x4e\x44\xae\x42\x60\x82"sv);
    const Image grey = read_image(path("grey.png"), Encoding::linear);
    ASSERT_EQ(grey.channels, 1);
    EXPECT_EQ(grey.pixels, (std::vector<float>{32768.0f / 65535.0f, 1.0f / 65535.0f}));
    EXPECT_FLOAT_EQ(read_image(path("grey.png")).pixels[0], srgb_decode(32768.0f / 65535.0f));

    put(path("bits.png"),
        "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x08\x00\x00\x00\x01\x01\x00\x00\x00\x00\xcb"
        "\x7b\xd2\xee\x00\x00\x00\x0a\x49\x44\x41\x54\x78\xda\x63\xd8\x00\x00\x00\xb2\x00\xb1\xf8\x82\x92\xa7\x00\x00\x00\x00\x49"
        "\x45\x4e\x44\xae\x42\x60\x82"sv);
    EXPECT_EQ(read_image(path("bits.png")).pixels, (std::vector<float>{1, 0, 1, 1, 0, 0, 0, 0}));
}

TEST_F(ImageFiles, UnpremultipliedAlphaComesBack) {
    const Image image{1, 1, 4, {1.0f, 0.5f, 0.25f, 0.2f}};
    for (const char* name : {"a.png", "a.tif"}) {
        write_image(path(name), image, {});
        const Image read = read_image(path(name));
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_NEAR(read.pixels[c], image.pixels[c], 0.005f) << name;
        }
    }
}

TEST_F(ImageFiles, FailuresNameThePathAndLeaveNothing) {
    const Image image = gradient(4, 4, 3);
    for (const std::string& ending : writable_endings()) {
        const std::string missing = path("nowhere/a" + ending);
        const std::string words = message_of<MachineFailure>([&] { write_image(missing, image, {}); });
        EXPECT_NE(words.find(missing), std::string::npos) << words;
        EXPECT_NE(words.find("no folder"), std::string::npos) << words;
    }
    fs::create_directory(path("folder.png"));
    EXPECT_NE(message_of<MachineFailure>([&] { write_image(path("folder.png"), image, {}); }).find("directory"), std::string::npos);
    EXPECT_NE(message_of<MachineFailure>([&] { write_image(path("a.gif"), image, {}); }).find(".png"), std::string::npos);
    EXPECT_EQ(files(), 1u);  // the folder
}

TEST_F(ImageFiles, ReplacedFilesKeepOldBytesOnFailure) {
    // A file size limit makes write() fail half way, as a full disk does.
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = ::signal(SIGXFSZ, SIG_IGN);
    put(path("a.png"), "old");
    rlimit limit = before;
    limit.rlim_cur = 4096;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
    std::vector<std::string> words;
    for (const std::string& ending : writable_endings()) {
        words.push_back(message_of<MachineFailure>([&] { write_image(path("a" + ending), noise(100, 100), {}); }));
    }
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    ::signal(SIGXFSZ, handler);
    for (std::size_t i = 0; i < words.size(); ++i) {
        EXPECT_NE(words[i].find(path("a" + writable_endings()[i])), std::string::npos) << words[i];
        EXPECT_NE(words[i].find("too large"), std::string::npos) << words[i];
    }
    EXPECT_EQ(bytes_of(path("a.png")), "old");
    EXPECT_EQ(files(), 1u);
}

TEST_F(ImageFiles, FullDisk) {
    if (!fs::exists("/dev/full") || ::mkdir(path("full").c_str(), 0777) != 0) {
        GTEST_SKIP();
    }
    const std::string mount = "mount -t tmpfs -o size=16k tmpfs " + path("full") + " 2>/dev/null";
    if (std::system(mount.c_str()) != 0) {
        GTEST_SKIP() << "needs the right to mount";
    }
    put(path("full/a.png"), "old");
    const std::string words = message_of<MachineFailure>([&] { write_image(path("full/a.png"), noise(100, 100), {}); });
    const std::string kept = bytes_of(path("full/a.png"));
    const auto left = std::distance(fs::directory_iterator(path("full")), {});
    EXPECT_EQ(std::system(("umount " + path("full")).c_str()), 0);
    EXPECT_NE(words.find("No space left on device"), std::string::npos) << words;
    EXPECT_EQ(kept, "old");
    EXPECT_EQ(left, 1);
}

TEST_F(ImageFiles, WrittenFilesHaveOrdinaryPermissions) {
    const mode_t mask = ::umask(022);
    replace_file(path("a.txt"), "words");
    ::umask(mask);
    struct stat status {};
    ASSERT_EQ(::stat(path("a.txt").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0644u);
    EXPECT_EQ(bytes_of(path("a.txt")), "words");
}

TEST_F(ImageFiles, SweepersLeaveWhatIsBeingWritten) {
    std::atomic<bool> done = false;
    std::thread sweeper([&] {
        while (!done) {
            remove_leftovers(path("a.txt"));
        }
    });
    for (int i = 0; i < 3000; ++i) {
        EXPECT_NO_THROW(replace_file(path("a.txt"), std::to_string(i)));
        EXPECT_EQ(bytes_of(path("a.txt")), std::to_string(i));
    }
    done = true;
    sweeper.join();
    EXPECT_EQ(files(), 1u);
}

TEST_F(ImageFiles, UnreadableFilesAreExplained) {
    const auto words = [&](const std::string& name) { return message_of<std::runtime_error>([&] { read_image(path(name)); }); };
    EXPECT_NE(words("none.png").find("no such file"), std::string::npos) << words("none.png");
    EXPECT_NE(words("none.png").find(path("none.png")), std::string::npos);
    put(path("empty.png"), "");
    EXPECT_NE(words("empty.png").find("no image format"), std::string::npos) << words("empty.png");
    put(path("text.png"), "This is no picture.");
    EXPECT_NE(words("text.png").find("no image format"), std::string::npos) << words("text.png");
    EXPECT_NE(words(".").find("not a file"), std::string::npos) << words(".");
    ASSERT_EQ(::mkfifo(path("pipe.png").c_str(), 0600), 0);
    EXPECT_NE(words("pipe.png").find("not a file"), std::string::npos);
}

TEST_F(ImageFiles, TheFirstBytesDecideTheFormat) {
    write_image(path("a.png"), gradient(5, 3, 3), {});
    fs::rename(path("a.png"), path("a.jpg"));
    EXPECT_EQ(read_image(path("a.jpg")).width, 5);
}

TEST_F(ImageFiles, MissingModuleNamesThePackage) {
    const auto words = [&] { return message_of<MachineFailure>([&] { load_images_module({folder_.path().string()}); }); };
    EXPECT_NE(words().find("libopenimageio-dev"), std::string::npos) << words();
    EXPECT_NE(words().find(folder_.path().string()), std::string::npos) << words();
    put(path("lancer_images.so"), "no library");
    EXPECT_NE(words().find("cannot load " + path("lancer_images.so")), std::string::npos) << words();
    EXPECT_NE(words().find("libopenimageio2.4"), std::string::npos) << words();
}

// Cut anywhere, or with any byte changed: an image or a message, never anything else.
TEST_F(ImageFiles, BrokenFilesNeverCrash) {
    const Metadata metadata = {{"Software", "lancer"}};
    for (const char* const name : {".png", ".jpg", ".exr", ".hdr", ".tif"}) {
        const std::string ending = name;
        write_image(path("whole" + ending), gradient(19, 11, 3), metadata);
        const std::string whole = bytes_of(path("whole" + ending));
        int refused = 0;
        const auto attempt = [&](const std::string& bytes) {
            put(path("broken" + ending), bytes);
            try {
                const Image image = read_image(path("broken" + ending));
                EXPECT_LE(image.pixels.size() * 4, 4 * (4096 * bytes.size() + (1u << 20)));
            } catch (const std::runtime_error& error) {
                ++refused;
                EXPECT_NE(std::string(error.what()).find("broken"), std::string::npos);
            }
        };
        for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 20) {
            attempt(whole.substr(0, size));
        }
        for (std::size_t at = 0; at < whole.size(); at += 1 + (at < 300 ? 2 : whole.size() / 20)) {
            for (const char value : {'\0', '\x7f', '\xff'}) {
                std::string bytes = whole;
                bytes[at] = value;
                attempt(bytes);
            }
        }
        EXPECT_GT(refused, 5) << ending;
    }
}

// A header that asks for more memory than the file could fill.
TEST_F(ImageFiles, AbsurdSizesAreRefused) {
    const std::string pixels(64, 'x');
    put(path("a.ppm"), "P6 30000 30000 255\n" + pixels);
    put(path("b.pfm"), "PF\n100000 100000\n-1.0\n" + pixels);
    put(path("c.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 40000 +X 40000\n" + pixels);
    for (const char* name : {"a.ppm", "b.pfm", "c.hdr"}) {
        const std::string words = message_of<std::runtime_error>([&] { read_image(path(name)); });
        EXPECT_NE(words.find(name), std::string::npos) << words;
    }
}

}  // namespace
