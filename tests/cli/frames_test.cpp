// lancer render --frames: animations, and what of them is done already.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace lancer::test {
namespace {

using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Words = std::vector<std::string>;

class Frames : public testing::Test {
protected:
    Frames() { std::filesystem::copy_file(scene_file("gltf/carousel.gltf"), folder.path() / "scene.gltf"); }

    Finished render(const Words& options) {
        Words words = {"render", "scene.gltf", "--size", "24x16", "--spp", "2"};
        words.insert(words.end(), options.begin(), options.end());
        return run_lancer(folder, words);
    }

    // When it was written, or rather by which inode.
    auto time_of(const std::string& name) { return std::filesystem::last_write_time(folder.path() / name); }

    Folder folder;
};

TEST_F(Frames, AreThePicturesOfTheirMoments) {
    const Finished finished = render({"--frames", "8:20:6", "--fps", "8", "-o", "f.###.exr", "-o", "f#.png", "--stats", "s##.json"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.out, HasSubstr("3 frames in "));
    EXPECT_THAT(folder.names(), ElementsAre("f.008.exr", "f.014.exr", "f.020.exr", "f14.png", "f20.png", "f8.png", "s08.json", "s14.json",
                                            "s20.json", "scene.gltf"));
    ASSERT_EQ(render({"--frame", "1.75", "-o", "one.exr", "-o", "one.png"}).status, 0);
    EXPECT_TRUE(folder.read("one.exr") == folder.read("f.014.exr"));
    EXPECT_TRUE(folder.read("one.png") == folder.read("f14.png"));
    EXPECT_FALSE(folder.read("f.008.exr") == folder.read("f.014.exr"));
}

// The water of a scene in TOML comes from a glTF file, and begins again after four seconds.
TEST_F(Frames, MoveWhatIsIncluded) {
    const std::string pool = scene_file("gallery/pool.toml");
    const Finished finished = run_lancer(folder, {"render", pool, "--size", "48x27", "--spp", "1", "--integrator", "path", "--frames",
                                                  "0:8:4", "--fps", "2", "-o", "f.#.exr"});
    ASSERT_EQ(finished.status, 0) << finished.err;
    EXPECT_EQ(run_lancer(folder, {"compare", "--exact", "f.0.exr", "f.8.exr"}).status, 0);
    EXPECT_EQ(run_lancer(folder, {"compare", "--exact", "f.0.exr", "f.4.exr"}).status, 1);
}

TEST_F(Frames, ThatAreDoneAreLeftAlone) {
    const Words words = {"--frames", "0:3", "-o", "f.#.exr", "-o", "f.#.png", "-o", "f.#.jpg", "-o", "f.#.hdr", "-o", "f.#.tif"};
    ASSERT_EQ(render(words).status, 0);
    for (const char* ending : {"exr", "png", "jpg", "hdr", "tif"}) {
        std::filesystem::remove(folder.path() / ("f.2." + std::string(ending)));
        const auto before = time_of("f.1.exr");
        const Finished finished = render(words);
        EXPECT_EQ(finished.status, 0) << finished.err;
        EXPECT_THAT(finished.out, HasSubstr("3 of 4 frames are done already")) << ending;
        EXPECT_EQ(time_of("f.1.exr"), before);
    }
    EXPECT_THAT(render(words).out, HasSubstr("4 of 4 frames are done already"));
}

TEST_F(Frames, OfOtherInputsAreMadeAnew) {
    const Words words = {"--frames", "0:1", "-o", "f.#.png"};
    ASSERT_EQ(render(words).status, 0);
    Words other = words;
    other.insert(other.end(), {"--seed", "3"});
    EXPECT_THAT(render(other).out, Not(HasSubstr("already")));
    EXPECT_THAT(render(other).out, HasSubstr("2 of 2 frames are done already"));
    EXPECT_THAT(render(words).out, Not(HasSubstr("already")));
    folder.write("scene.gltf", folder.read("scene.gltf") + "\n");
    EXPECT_THAT(render(words).out, Not(HasSubstr("already"))) << "the scene has changed";
    EXPECT_THAT(render(words).out, HasSubstr("already"));
    // Another moment with a name that begins alike.
    Words slow = words;
    slow.insert(slow.end(), {"--fps", "2"});
    ASSERT_EQ(render(slow).status, 0);
    slow.back() = "1.9";
    EXPECT_THAT(render(slow).out, HasSubstr("1 of 2 frames is done already"));
}

TEST_F(Frames, ThatAreBrokenAreMadeAnew) {
    for (const std::string ending : {"exr", "png", "jpg", "tif"}) {
        const Words words = {"--frames", "0:1", "-o", "f.#." + ending};
        ASSERT_EQ(render(words).status, 0);
        const std::string whole = folder.read("f.1." + ending);
        folder.write("f.1." + ending, whole.substr(0, whole.size() * 2 / 3));
        EXPECT_THAT(render(words).out, HasSubstr("1 of 2 frames is done already")) << ending;
        EXPECT_TRUE(folder.read("f.1." + ending) == whole) << ending;
    }
}

TEST_F(Frames, ThatWereStoppedAreMadeAnew) {
    const Words words = {"render", "scene.gltf", "--size", "400x300", "--spp", "64", "--frames", "0:3", "-o", "f.#.exr", "--threads", "1"};
    Words command = {LANCER_PROGRAM};
    command.insert(command.end(), words.begin(), words.end());
    Running running(folder, command);
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    ASSERT_TRUE(running.is_alive());
    running.signal(SIGTERM);
    const Finished stopped = running.wait();
    EXPECT_EQ(stopped.status, 1);
    EXPECT_TRUE(folder.has("f.0.exr"));
    EXPECT_FALSE(folder.has("f.1.exr"));
    // Smaller, but for the words that say so the same: a file that was stopped tells that it was.
    EXPECT_THAT(folder.read("f.0.exr"), HasSubstr("lancer:unfinished"));
}

TEST_F(Frames, ProgressIsOverAllOfThem) {
    const Finished finished =
        render({"--size", "200x150", "--spp", "4", "--frames", "1:4", "-o", "f.#.png", "--progress", "json", "--quiet"});
    EXPECT_EQ(finished.status, 0);
    std::istringstream lines(finished.err);
    std::vector<double> shares;
    int done = 0;
    for (std::string line; std::getline(lines, line);) {
        const nlohmann::json json = nlohmann::json::parse(line);
        if (json.at("event") == "progress") {
            EXPECT_LE(json.at("share").get<double>(), 0.25 * (done + 1) + 1e-3);
            EXPECT_GE(json.at("share").get<double>(), 0.25 * done - 1e-3);
            shares.push_back(json.at("share"));
        }
        done += json.at("event") == "done" ? 1 : 0;
    }
    EXPECT_EQ(done, 4);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
}

TEST_F(Frames, MistakesAreExplained) {
    const std::pair<Words, const char*> mistakes[] = {
        {{"--frames", "3:1", "-o", "f.#.exr"}, "--frames: expected FIRST:LAST or FIRST:LAST:STEP with whole numbers"},
        {{"--frames", "1", "-o", "f.#.exr"}, "not \"1\""},
        {{"--frames", "1:2:0", "-o", "f.#.exr"}, "not \"1:2:0\""},
        {{"--frames", "-1:2", "-o", "f.#.exr"}, "not \"-1:2\""},
        {{"--frames", "1:2:3:4", "-o", "f.#.exr"}, "expected FIRST:LAST"},
        {{"--frames", "1:99999999999", "-o", "f.#.exr"}, "expected FIRST:LAST"},
        {{"--frames", "1:2", "-o", "f.exr"}, "-o f.exr: each frame needs a file of its own; # stands for its number"},
        {{"--frames", "1:2", "-o", "a#/f.exr"}, "each frame needs a file of its own"},
        {{"--frames", "1:2", "-o", "f.#.exr", "--stats", "s.json"}, "--stats s.json: each frame needs a file of its own"},
        {{"--frames", "1:2", "-o", "f.#.xyz"}, ".xyz is not a format"},
        {{"--frames", "1:2", "--frame", "2", "-o", "f.#.exr"}, "one of them at a time"},
        {{"--fps", "25", "-o", "f.exr"}, "--fps goes with --frames"},
        {{"--fps", "0", "--frames", "1:2", "-o", "f.#.exr"}, "--fps: expected a number from"},
    };
    for (const auto& [words, said] : mistakes) {
        const Finished finished = render(words);
        EXPECT_EQ(finished.status, 2) << words[1];
        EXPECT_THAT(finished.err, HasSubstr(said));
        EXPECT_THAT(folder.names(), ElementsAre("scene.gltf"));
    }
}

// ---- lancer movie -------------------------------------------------------------------------------------------------------------------

class Movie : public Frames {
protected:
    void SetUp() override {
        if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) {
            GTEST_SKIP() << "ffmpeg is not here: films are not made";
        }
    }
};

TEST_F(Movie, HasAllFramesInTheirTime) {
    ASSERT_EQ(render({"--size", "49x33", "--frames", "5:14", "-o", "f.##.exr", "-o", "f.##.png", "--quiet"}).status, 0);
    for (const char* name : {"film.mp4", "film.mkv", "film.webm", "film.gif"}) {
        const Finished finished =
            run_lancer(folder, {"movie", std::string("f.##.") + (name[5] == 'm' ? "exr" : "png"), "-o", name, "--fps", "5"});
        EXPECT_EQ(finished.status, 0) << finished.err;
        EXPECT_THAT(finished.out, HasSubstr("written: 10 frames, 2 s at 5 a second"));
        const Finished probe = Running(folder, {"ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
                                                "stream=nb_read_frames,r_frame_rate,width,height", "-of", "csv=p=0", name})
                                   .wait();
        const std::string size = std::string(name) == "film.gif" ? "49,33" : "50,34";  // others want an even number of pixels
        EXPECT_THAT(probe.out, HasSubstr(size + ",5/1,10")) << name << probe.err;
    }
    EXPECT_EQ(run_lancer(folder, {"movie", "f.##.exr", "-o", "part.mp4", "--frames", "6:12:2", "--view", "agx", "--quiet"}).out, "");
    EXPECT_EQ(run_lancer(folder, {"movie", "f.05.png", "f.07.png", "-o", "two.mp4"}).status, 0);
    for (const std::string& name : folder.names()) {
        EXPECT_THAT(name, Not(HasSubstr(".part")));
    }
}

TEST_F(Movie, ShowsWhatThePicturesShow) {
    ASSERT_EQ(render({"--size", "48x32", "--spp", "16", "--view", "agx", "--frames", "0:1", "-o", "f.#.exr", "-o", "f.#.png"}).status, 0);
    ASSERT_EQ(run_lancer(folder, {"movie", "f.#.exr", "-o", "film.mp4"}).status, 0);
    ASSERT_EQ(Running(folder, {"ffmpeg", "-v", "error", "-i", "film.mp4", "-frames:v", "1", "back.png"}).wait().status, 0);
    const Finished compared = run_lancer(folder, {"compare", "back.png", "f.0.png", "--max-flip", "0.06"});
    EXPECT_EQ(compared.status, 0) << compared.out << compared.err;
}

TEST_F(Movie, MistakesAreExplained) {
    ASSERT_EQ(render({"--frames", "1:3", "-o", "f.#.png", "--quiet"}).status, 0);
    ASSERT_EQ(render({"--size", "20x20", "-o", "other.png", "--quiet"}).status, 0);
    std::filesystem::remove(folder.path() / "f.2.png");
    folder.write("broken.png", "no picture");
    const std::vector<std::string> before = folder.names();
    const std::pair<Words, const char*> mistakes[] = {
        {{}, "which frames?"},
        {{"f.#.png"}, "where shall the film go?"},
        {{"f.#.png", "-o", "film.txt"}, "films end in .mp4, .mkv, .mov, .webm, .gif"},
        {{"f.#.png", "-o", "none/film.mp4"}, "there is no folder none"},
        {{"g.#.png", "-o", "film.mp4"}, "there are no frames g.#.png"},
        {{"f.#.png", "-o", "film.mp4", "--frames", "1:3"}, "1 is missing: 2"},
        {{"f.#.png", "-o", "film.mp4", "--frames", "1:40:3"}, "13 are missing: 4, 7, 10, 13, 16, 19, 22, 25, 28, 31 and 3 more"},
        {{"f.1.png", "-o", "film.mp4", "--frames", "1:3"}, "--frames goes with one name that has #"},
        {{"f.1.png", "other.png", "-o", "film.mp4"}, "other.png is 20x20, and the frames before it are 24x16"},
        {{"f.1.png", "none.png", "-o", "film.mp4"}, "none.png"},
        {{"broken.png", "-o", "film.mp4"}, "broken.png"},
    };
    for (const auto& [words, said] : mistakes) {
        Words all = {"movie"};
        all.insert(all.end(), words.begin(), words.end());
        const Finished finished = run_lancer(folder, all);
        EXPECT_EQ(finished.status, 2) << said << finished.out;
        EXPECT_THAT(finished.err, HasSubstr(said));
        EXPECT_EQ(folder.names(), before);
    }
    EXPECT_EQ(run_lancer(folder, {"movie", "f.#.png", "-o", "film.mp4"}).status, 0) << "every second frame is a film, too";
}

TEST_F(Frames, AFilmNeedsFfmpeg) {
    ASSERT_EQ(render({"--frames", "1:2", "-o", "f.#.png", "--quiet"}).status, 0);
    const Finished finished = run_lancer(folder, {"movie", "f.#.png", "-o", "film.mp4"}, {{"PATH", "/nowhere"}});
    EXPECT_EQ(finished.status, 3);
    EXPECT_THAT(finished.err, HasSubstr("ffmpeg, which makes films of pictures, is not on this machine"));
}

}  // namespace
}  // namespace lancer::test
