// The window, on a display of its own.
#include <chrono>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"
#include "lancer/image/image.h"

namespace lancer::test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

using Words = std::vector<std::string>;

bool is_installed(const std::string& program) { return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0; }

// True as soon as `condition` is; false after 20 seconds.
template <typename Condition>
bool eventually(Condition condition) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > give_up) {
            return false;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
}

std::string whole(Running&& running) { return running.wait().out; }

class Window : public testing::Test {
protected:
    void SetUp() override {
        if (!is_installed("Xvfb") || !is_installed("xdotool")) {
            GTEST_SKIP() << "needs Xvfb and xdotool";
        }
        // Tests may run beside one another: numbers that are taken are tried in vain.
        const int first = 100 + static_cast<int>(getpid() % 400);
        for (int number = first; number < first + 20 && !display_.has_value(); ++number) {
            start_display(":" + std::to_string(number));
        }
        ASSERT_TRUE(display_.has_value());
        folder_.write("scene.toml", small_scene);
    }

    Environment environment() const {
        return {{"DISPLAY", *display_}, {"WAYLAND_DISPLAY", ""}, {"SDL_VIDEODRIVER", ""}, {"XDG_RUNTIME_DIR", "/tmp"}};
    }

    void start(Words words) {
        words.insert(words.begin(), LANCER_PROGRAM);
        program_ = std::make_unique<Running>(folder_, words, environment());
        ASSERT_TRUE(eventually([&] { return !program_->is_alive() || !(window_ = ask({"search", "--name", "^lancer, "})).empty(); }));
        if (!program_->is_alive()) {
            const Finished finished = program_->wait();
            FAIL() << "ended with " << finished.status << ": " << finished.out << finished.err;
        }
    }

    // What xdotool says, without the line's end.
    std::string ask(Words words) const {
        words.insert(words.begin(), "xdotool");
        std::string text = Running(folder_, words, environment()).wait().out;
        return text.substr(0, text.find('\n'));
    }
    std::string title() const { return ask({"getwindowname", window_}); }
    bool is_done() const {
        const std::string text = title();
        return text.ends_with(" s, S saves") && text.find('%') == std::string::npos;
    }
    void press(const std::string& key) const { ask({"key", "--window", window_, key}); }

    Folder folder_;
    std::optional<std::string> display_;
    std::unique_ptr<Running> server_;
    std::unique_ptr<Running> program_;
    std::string window_;

private:
    void start_display(const std::string& name) {
        auto server =
            std::make_unique<Running>(folder_, Words{"Xvfb", name, "-screen", "0", "1600x1000x24", "-nolisten", "tcp", "-noreset"});
        display_ = name;
        if (eventually([&] { return !server->is_alive() || !ask({"getdisplaygeometry"}).empty(); }) && server->is_alive()) {
            server_ = std::move(server);
        } else {
            display_.reset();
        }
    }
};

TEST_F(Window, ShowsTheDefaultSceneAndSavesIt) {
    start({"-threads", "2"});
    EXPECT_THAT(ask({"getwindowgeometry", window_}), HasSubstr("Window"));
    EXPECT_TRUE(eventually([&] { return is_done(); })) << title();
    EXPECT_THAT(title(), MatchesRegex("lancer, figure-1.toml: [0-9.]+ s, S saves"));
    press("s");
    ASSERT_TRUE(eventually([&] { return folder_.has("lancer.png"); }));
    EXPECT_TRUE(eventually([&] { return title().ends_with(" s, saved as lancer.png"); })) << title();
    const Image image = read_image(folder_.file("lancer.png"));
    EXPECT_EQ(image.width, 1280);
    EXPECT_EQ(image.height, 720);

    press("Escape");
    const Finished finished = program_->wait();
    EXPECT_EQ(finished.status, 0);
    EXPECT_THAT(finished.out, HasSubstr("Saved as lancer.png"));

    // The very picture that is written without a window.
    const std::string seen = folder_.read("lancer.png");
    ASSERT_EQ(run_lancer(folder_, {}).status, 0);
    EXPECT_TRUE(folder_.read("lancer.png") == seen);
}

TEST_F(Window, AppearsAtOnceAndRefines) {
    // Minutes of work: the window must be there long before, tell how far it is, and close when asked.
    start({"view", "scene.toml", "--size", "4000x3000", "--ssaa", "32", "-threads", "1"});
    EXPECT_TRUE(eventually([&] { return title().find(" s left") != std::string::npos; })) << title();
    EXPECT_THAT(title(), MatchesRegex("lancer, scene.toml: [0-9]+ %, [0-9]+ s left, S saves"));
    press("s");
    ASSERT_TRUE(eventually([&] { return folder_.has("lancer.png"); }));
    const Image image = read_image(folder_.file("lancer.png"));
    EXPECT_EQ(image.width, 4000);
    // What is not yet rendered is seen coarsely.
    EXPECT_GT(image.pixels[image.pixels.size() - 1000] + image.pixels[image.pixels.size() / 2], 0.0f);
    press("Escape");
    EXPECT_EQ(program_->wait().status, 0);
}

TEST_F(Window, FitsTheScreenAndCanBeResized) {
    start({"view", "scene.toml", "--size", "3000x1000"});
    EXPECT_THAT(whole(Running(folder_, {"xdotool", "getwindowgeometry", window_}, environment())), HasSubstr("Geometry: 1520x507"));
    EXPECT_TRUE(eventually([&] { return is_done(); })) << title();
    ask({"windowsize", window_, "500", "700"});
    EXPECT_TRUE(eventually([&] {
        return whole(Running(folder_, {"xdotool", "getwindowgeometry", window_}, environment())).find("Geometry: 500x700") !=
               std::string::npos;
    }));
    press("Escape");
    EXPECT_EQ(program_->wait().status, 0);
}

TEST_F(Window, ClosesWhenTheSystemAsks) {
    start({"view", "scene.toml"});
    program_->signal(SIGTERM);
    EXPECT_EQ(program_->wait().status, 0);
}

TEST_F(Window, SaysWhenItCanNotSave) {
    folder_.write("lancer.png.keep", "");
    ASSERT_TRUE(std::filesystem::create_directory(folder_.file("lancer.png")));
    start({"view", "scene.toml"});
    press("s");
    EXPECT_TRUE(eventually([&] { return title().ends_with(" s, could not be saved"); })) << title();
    press("Escape");
    const Finished finished = program_->wait();
    EXPECT_EQ(finished.status, 0);
    EXPECT_THAT(finished.err, HasSubstr("lancer.png"));
}

TEST_F(Window, BadInputOpensNone) {
    folder_.write("scene.toml", "[camera]\n[[sphere]]\nradius = 0\n");
    const Finished finished = run_lancer(folder_, {"view", "scene.toml"}, environment());
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("scene.toml:3:"));
}

}  // namespace
}  // namespace lancer::test
