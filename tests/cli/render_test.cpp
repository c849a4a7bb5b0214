// lancer render, info and figures on scenes that are right.
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <set>
#include <sstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "lancer/image/image.h"

namespace lancer::test {
namespace {

using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Words = std::vector<std::string>;

class Render : public testing::Test {
protected:
    Render() { folder.write("scene.toml", small_scene); }

    Finished render(const Words& options) {
        Words words = {"render", "scene.toml"};
        words.insert(words.end(), options.begin(), options.end());
        return run_lancer(folder, words);
    }
    Image picture(const Words& options) {
        Words words = options;
        words.insert(words.end(), {"-o", "picture.exr", "--quiet"});
        const Finished finished = render(words);
        EXPECT_EQ(finished.status, 0) << finished.err;
        return read_image(folder.file("picture.exr"));
    }

    Folder folder;
};

double mean(const Image& image) {
    double sum = 0.0;
    for (const float value : image.pixels) {
        sum += static_cast<double>(value);
    }
    return sum / static_cast<double>(image.pixels.size());
}

TEST_F(Render, WritesEveryFormatAndSaysSo) {
    const Finished finished = render({"-o", "a.png", "-o", "b.exr", "c.jpg", "-o", "d.hdr", "e.tif"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.out, ContainsRegex("^a.png, b.exr, d.hdr, c.jpg, e.tif written: 40x30 in .* rays a second"));
    for (const char* name : {"a.png", "b.exr", "c.jpg", "d.hdr", "e.tif"}) {
        const Image image = read_image(folder.file(name));
        EXPECT_EQ(image.width, 40) << name;
        EXPECT_EQ(image.height, 30) << name;
        EXPECT_NEAR(mean(image), mean(read_image(folder.file("b.exr"))), 0.01) << name;
        EXPECT_GT(mean(image), 0.02) << name;
    }
}

TEST_F(Render, OptionsHaveTheLastWord) {
    const Image plain = picture({});
    EXPECT_EQ(picture({"--size", "64x20"}).width, 64);
    for (const Words& options : {Words{"--camera", "above"}, Words{"--bounces", "0"}, Words{"--lights", "lamp"}, Words{"--lights", "2"},
                                 Words{"--ssaa", "3"}, Words{"--aa", "adaptive"}, Words{"--adaptive-depth", "1"}}) {
        EXPECT_NE(picture(options).pixels, plain.pixels) << options[0] << " " << options[1];
    }
    EXPECT_EQ(picture({"--lights", "2"}).pixels, picture({"--lights", "lamp"}).pixels);
    EXPECT_EQ(picture({"--lights", "sun,lamp"}).pixels, plain.pixels);
    EXPECT_EQ(picture({"--trace", "lanes"}).pixels, plain.pixels);
    EXPECT_EQ(picture({"--integrator", "whitted"}).pixels, plain.pixels);
    EXPECT_EQ(picture({"--exposure", "2"}).pixels, plain.pixels);  // EXR keeps the light as it is
}

TEST_F(Render, CamerasOfEachKindServeBothIntegrators) {
    // A red ball in the middle of the picture, and another behind the camera.
    const std::string balls = R"(
[render]
size = [80, 40]
filter = "box"
[camera]
position = [0, 0, 3]
projection = "PROJECTION"
fov = 90
extent = 8
[material.red]
type = "MATERIAL"
color = "#ff0000"
[background]
color = "#ffffff"
[ambient]
color = "#ffffff"
[[sphere]]
center = [0, 0, 0]
radius = 1
material = "red"
[[sphere]]
center = [0, 0, 6]
radius = 1
material = "red"
)";
    const auto with = [&](const std::string& projection, const std::string& material) {
        std::string text = balls;
        text.replace(text.find("PROJECTION"), 10, projection);
        text.replace(text.find("MATERIAL"), 8, material);
        folder.write("scene.toml", text);
        return picture({"--spp", "4"});
    };
    for (const std::string material : {"whitted", "diffuse"}) {
        const auto is_red = [](const Image& image, int x, int y) {
            const std::size_t i = 3 * static_cast<std::size_t>(y * image.width + x);
            return image.pixels[i + 1] < 0.3f * image.pixels[i];
        };
        const Image straight = with("orthographic", material), round = with("panorama", material);
        for (const Image* image : {&straight, &round}) {
            EXPECT_TRUE(is_red(*image, 40, 20)) << material;
            EXPECT_FALSE(is_red(*image, 20, 20)) << material;
            EXPECT_FALSE(is_red(*image, 40, 2)) << material;
        }
        EXPECT_TRUE(is_red(straight, 40 + 9, 20)) << material;  // 10 pixels a metre
        EXPECT_FALSE(is_red(straight, 40 + 11, 20)) << material;
        EXPECT_TRUE(is_red(round, 1, 20)) << material << ": behind";
        EXPECT_FALSE(is_red(straight, 1, 20)) << material;
    }
}

TEST_F(Render, ExposureIsForTheDisplay) {
    ASSERT_EQ(render({"-o", "dark.png"}).status, 0);
    ASSERT_EQ(render({"-o", "bright.png", "--exposure", "1"}).status, 0);
    const Image dark = read_image(folder.file("dark.png"));
    const Image bright = read_image(folder.file("bright.png"));
    int compared = 0;
    for (std::size_t i = 0; i < dark.pixels.size(); ++i) {
        if (dark.pixels[i] > 0.05f && dark.pixels[i] < 0.45f) {
            ASSERT_NEAR(bright.pixels[i], 2.0f * dark.pixels[i], 0.02f);
            ++compared;
        }
    }
    EXPECT_GT(compared, 100);
}

TEST_F(Render, FilesAreTheSameForAnyThreads) {
    std::set<std::string> files;
    for (const char* antialiasing : {"uniform", "adaptive"}) {
        for (const char* threads : {"1", "2", "3", "16"}) {
            ASSERT_EQ(render({"-o", "a.png", "--size", "90x70", "--aa", antialiasing, "-threads", threads}).status, 0);
            files.insert(folder.read("a.png"));
        }
    }
    EXPECT_EQ(files.size(), 2u);
}

TEST_F(Render, PicturesTellWhereTheyComeFrom) {
    ASSERT_EQ(render({"-o", "a.png", "--bounces", "2", "-threads", "2"}).status, 0);
    const std::string bytes = folder.read("a.png");
    EXPECT_THAT(bytes, HasSubstr("Software"));
    EXPECT_THAT(bytes, HasSubstr("lancer render scene.toml --bounces 2"));
    EXPECT_THAT(bytes, HasSubstr("lancer:hash"));
    EXPECT_THAT(bytes, HasSubstr("lancer:version"));
}

TEST_F(Render, StatisticsAreJson) {
    ASSERT_EQ(render({"-o", "a.png", "--ssaa", "2", "--stats", "stats.json", "-threads", "2"}).status, 0);
    const nlohmann::json stats = nlohmann::json::parse(folder.read("stats.json"));
    EXPECT_EQ(stats["width"], 40);
    EXPECT_EQ(stats["samples"], 40 * 30 * 4);
    EXPECT_EQ(stats["rays"]["camera"], 40 * 30 * 4);
    EXPECT_GT(stats["rays"]["shadow"], 1000);
    EXPECT_GT(stats["rays"]["secondary"], 100);
    EXPECT_EQ(stats["threads"], 2);
    EXPECT_EQ(stats["finished"], true);
    EXPECT_EQ(stats["written"], nlohmann::json({"a.png"}));
    EXPECT_GT(stats["rays_per_second"], 0.0);
}

TEST_F(Render, TheSampleMapIsBrightAtEdges) {
    ASSERT_EQ(render({"-o", "a.png", "--aa", "adaptive", "--sample-map", "map.exr"}).status, 0);
    ASSERT_EQ(render({"-o", "a.png", "--aa", "adaptive", "--sample-map", "map.png"}).status, 0);
    const Image counts = read_image(folder.file("map.exr"));
    const Image shown = read_image(folder.file("map.png"));
    EXPECT_EQ(counts.pixels.front(), 1.0f);  // the background
    EXPECT_GT(*std::max_element(counts.pixels.begin(), counts.pixels.end()), 10.0f);
    EXPECT_NEAR(*std::max_element(shown.pixels.begin(), shown.pixels.end()), 1.0f, 1e-3f);
    EXPECT_LT(shown.pixels.front(), 0.2f);
}

TEST_F(Render, QuietSaysNothing) {
    const Finished finished = render({"-o", "a.png", "--quiet"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_THAT(finished.out, IsEmpty());
    EXPECT_THAT(finished.err, IsEmpty());
}

TEST_F(Render, JsonProgressIsJson) {
    const Finished finished = render({"-o", "a.png", "--progress", "json", "--ssaa", "30"});
    EXPECT_EQ(finished.status, 0);
    std::istringstream lines(finished.err);
    std::string line;
    std::string last_event;
    while (std::getline(lines, line)) {
        last_event = nlohmann::json::parse(line).at("event");
    }
    EXPECT_EQ(last_event, "done");
}

TEST_F(Render, StoppedPicturesAreKept) {
    folder.write("long.toml", std::string(small_scene));
    Running running(folder, {LANCER_PROGRAM, "render", "long.toml", "-o", "a.png", "--size", "4000x3000", "--ssaa", "64", "-threads", "1"});
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    ASSERT_TRUE(running.is_alive());
    running.signal(SIGINT);
    const Finished finished = running.wait();
    EXPECT_EQ(finished.status, 1);
    EXPECT_THAT(finished.out, HasSubstr("Stopped; a.png written as far as it came"));
    EXPECT_EQ(read_image(folder.file("a.png")).width, 4000);
}

TEST_F(Render, AFolderWithoutPermissionIsSeenBefore) {
    if (geteuid() == 0) {
        GTEST_SKIP() << "root may write everywhere";
    }
    mkdir(folder.file("locked").c_str(), 0500);
    const Finished finished = render({"-o", "locked/a.png"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("no permission to write in the folder locked"));
}

TEST_F(Render, AFullDiskIsAFailureOfTheMachine) {
    // A limit on the size of files stands in for the disk: the other file is small enough.
    folder.write("run.sh", std::string("trap '' XFSZ\nulimit -f 8\nexec ") + LANCER_PROGRAM +
                               " render scene.toml --size 400x300 -o big.exr -o small.jpg --sample-map map.png\n");
    folder.write("big.exr", "precious");
    const Finished finished = Running(folder, {"bash", "run.sh"}).wait();
    EXPECT_EQ(finished.status, 3);
    EXPECT_THAT(finished.err, HasSubstr("big.exr"));
    EXPECT_TRUE(folder.read("big.exr") == "precious");
    EXPECT_TRUE(folder.has("map.png"));
    EXPECT_THAT(finished.out, Not(HasSubstr("big.exr")));
    for (const std::string& name : folder.names()) {
        EXPECT_THAT(name, testing::AnyOf("big.exr", "small.jpg", "map.png", "run.sh", "scene.toml"));
    }
}

TEST_F(Render, InfoCounts) {
    const Finished text = run_lancer(folder, {"info", "scene.toml"});
    EXPECT_EQ(text.status, 0);
    EXPECT_THAT(text.out, HasSubstr("1 sphere, 1 box"));
    EXPECT_THAT(text.out, HasSubstr("point sun (0.75), point lamp (0.25)"));
    const Finished json = run_lancer(folder, {"info", "--json", "scene.toml"});
    const nlohmann::json info = nlohmann::json::parse(json.out);
    EXPECT_EQ(info["shapes"]["sphere"], 1);
    EXPECT_EQ(info["lights"].size(), 2u);
    EXPECT_EQ(info["cameras"].size(), 2u);
    EXPECT_EQ(info["hash"].get<std::string>().size(), 32u);
}

TEST_F(Render, BenchTimesThreads) {
    const Finished finished = run_lancer(folder, {"bench", "scene.toml", "--threads", "3", "--tries", "1"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_THAT(finished.out, ContainsRegex("\n +1 +[0-9.]+ +1.00 +[0-9.]+\n +2 .*\n +3 "));
}

TEST(DefaultScene, GoesToAFileWhereThereIsNoDisplay) {
    const Folder folder;
    const Finished finished = run_lancer(folder, {"-threads", "2"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.out,
                HasSubstr("There is no display (neither DISPLAY nor WAYLAND_DISPLAY is set): the picture was written to lancer.png"));
    EXPECT_THAT(folder.names(), ElementsAre("lancer.png"));
    const Image image = read_image(folder.file("lancer.png"));
    EXPECT_EQ(image.width, 1280);
    EXPECT_EQ(image.height, 720);
    EXPECT_GT(mean(image), 0.02);
}

TEST(DefaultScene, GoesToAFileWhereTheDisplayIsGone) {
    const Folder folder;
    folder.write("scene.toml", small_scene);
    const Finished finished = run_lancer(folder, {"view", "scene.toml", "--size", "64x48"}, {{"DISPLAY", ":9998"}});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.out, HasSubstr("There is no display ("));
    EXPECT_EQ(read_image(folder.file("lancer.png")).width, 64);
}

}  // namespace
}  // namespace lancer::test
