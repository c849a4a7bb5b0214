// Shards, checkpoints, resuming: from outside.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <csignal>

#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"

namespace lancer::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const char* const path_scene = R"(
[render]
size = [75, 60]
spp = 64
seed = 3
[camera]
position = [0, 1, 4]
look_at = [0, 0.5, 0]
[[sphere]]
center = [1, 3, 1]
radius = 0.4
material = { type = "diffuse", emission = [1, 1, 1], emission_strength = 20 }
[[sphere]]
center = [0, 0.5, 0]
radius = 0.5
material = { type = "diffuse", color = "#c08040" }
[[box]]
min = [-3, -0.1, -3]
max = [3, 0, 3]
material = { type = "diffuse", color = "#808080" }
)";

class Resume : public testing::Test {
protected:
    void SetUp() override { folder_.write("scene.toml", path_scene); }

    Finished lancer(const std::vector<std::string>& words) const { return run_lancer(folder_, words); }
    // The same picture without anything in between.
    std::string whole(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words = {"render", "scene.toml", "-o", "whole.exr", "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(lancer(words).status, 0);
        return folder_.read("whole.exr");
    }
    // Kills a render with a checkpoint every few milliseconds once it has written two.
    void kill_render(const std::string& output, int signal_number) const {
        std::filesystem::remove(folder_.file(output + ".checkpoint"));
        std::filesystem::remove(folder_.file(output + ".checkpoint-before"));
        Running running(
            folder_, {LANCER_PROGRAM, "render", "scene.toml", "--spp", "100000", "--checkpoint", "20ms", "-o", output, "--threads", "2"});
        while (running.is_alive() && !folder_.has(output + ".checkpoint-before")) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        running.signal(signal_number);
        status_ = running.wait();
    }

    Folder folder_;
    mutable Finished status_;
};

TEST_F(Resume, ShardsMergedAreTheWholePicture) {
    const std::string picture = whole();
    for (const char* shard : {"1/3", "2/3", "3/3"}) {
        const Finished finished = lancer({"render", "scene.toml", "--shard", shard, "-o", "out.exr"});
        EXPECT_EQ(finished.status, 0) << finished.err;
    }
    EXPECT_THAT(folder_.names(), Contains("out.2-of-3.film"));

    const Finished missing = lancer({"merge", "out.1-of-3.film", "out.3-of-3.film", "-o", "out.exr"});
    EXPECT_EQ(missing.status, 2);
    EXPECT_THAT(missing.err, HasSubstr("shard 2 of 3 is missing"));
    EXPECT_FALSE(folder_.has("out.exr"));
    const Finished partial = lancer({"merge", "out.1-of-3.film", "out.3-of-3.film", "-o", "part.exr", "--partial"});
    EXPECT_EQ(partial.status, 1);
    EXPECT_TRUE(folder_.has("part.exr"));

    const Finished merged = lancer({"merge", "out.3-of-3.film", "out.1-of-3.film", "out.2-of-3.film", "-o", "out.exr", "-o", "out.film"});
    EXPECT_EQ(merged.status, 0) << merged.err;
    EXPECT_TRUE(folder_.read("out.exr") == picture);

    // The merged film may be gone on with.
    const Finished more = lancer({"resume", "out.film", "--spp", "80"});
    EXPECT_EQ(more.status, 0) << more.err;
    EXPECT_EQ(lancer({"merge", "out.film", "-o", "more.exr"}).status, 0);
    EXPECT_TRUE(folder_.read("more.exr") == whole({"--spp", "80"}));
}

TEST_F(Resume, ForeignShardsAreNamed) {
    EXPECT_EQ(lancer({"render", "scene.toml", "--shard", "1/2", "-o", "a.exr"}).status, 0);
    EXPECT_EQ(lancer({"render", "scene.toml", "--shard", "2/2", "--seed", "4", "-o", "b.exr"}).status, 0);
    const Finished merged = lancer({"merge", "a.1-of-2.film", "b.2-of-2.film", "-o", "out.exr"});
    EXPECT_EQ(merged.status, 2);
    EXPECT_THAT(merged.err, HasSubstr("b.2-of-2.film is no part of the same picture"));
    EXPECT_THAT(merged.err, HasSubstr("seed"));
    EXPECT_FALSE(folder_.has("out.exr"));
}

TEST_F(Resume, AfterAKillIsTheWholePicture) {
    kill_render("out.exr", SIGKILL);
    ASSERT_EQ(status_.status, -SIGKILL);
    EXPECT_FALSE(folder_.has("out.exr"));
    const Finished resumed = lancer({"resume", "out.exr", "--spp", "300"});
    EXPECT_EQ(resumed.status, 0) << resumed.err;
    EXPECT_TRUE(folder_.read("out.exr") == whole({"--spp", "300"}));
}

TEST_F(Resume, SignalsEndCleanly) {
    for (const int signal_number : {SIGINT, SIGTERM}) {
        kill_render("out.exr", signal_number);
        EXPECT_EQ(status_.status, 1) << status_.err;
        EXPECT_TRUE(folder_.has("out.exr"));
        EXPECT_TRUE(folder_.has("out.exr.checkpoint"));
    }
}

TEST_F(Resume, RefusesByNameWhatHasChanged) {
    kill_render("out.exr", SIGKILL);
    std::string changed = path_scene;
    changed.replace(changed.find("seed = 3"), 8, "seed = 5");
    folder_.write("scene.toml", changed);
    const Finished resumed = lancer({"resume", "out.exr"});
    EXPECT_EQ(resumed.status, 2);
    EXPECT_THAT(resumed.err, HasSubstr("scene.toml has changed"));
    EXPECT_THAT(resumed.err, HasSubstr("the seed was \"3\" and is \"5\" now"));
    EXPECT_FALSE(folder_.has("out.exr"));
}

TEST_F(Resume, ADamagedCheckpointGivesWayToTheOneBefore) {
    const std::string picture = whole({"--spp", "300"});
    for (const bool cut : {true, false}) {
        kill_render("out.exr", SIGKILL);
        std::string bytes = folder_.read("out.exr.checkpoint");
        ASSERT_GT(bytes.size(), 1000u);
        if (cut) {
            bytes.resize(bytes.size() / 2);
        } else {
            bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
        }
        folder_.write("out.exr.checkpoint", bytes);
        const Finished resumed = lancer({"resume", "out.exr", "--spp", "300"});
        EXPECT_EQ(resumed.status, 0) << resumed.err;
        EXPECT_THAT(resumed.err, HasSubstr("out.exr.checkpoint is damaged"));
        EXPECT_TRUE(folder_.read("out.exr") == picture);
        std::filesystem::remove(folder_.file("out.exr"));
        std::filesystem::remove(folder_.file("out.exr.checkpoint"));
    }
}

TEST_F(Resume, AFinishedPictureGetsMoreSamples) {
    EXPECT_EQ(lancer({"render", "scene.toml", "--checkpoint", "1h", "-o", "out.exr", "--quiet"}).status, 0);
    EXPECT_THAT(folder_.names(), ElementsAre("out.exr", "out.exr.checkpoint", "scene.toml"));
    const Finished kept = lancer({"resume", "out.exr", "--spp", "100"});
    EXPECT_EQ(kept.status, 0) << kept.err;
    EXPECT_TRUE(folder_.read("out.exr") == whole({"--spp", "100"}));
    // Without a film it takes longer, that is all.
    std::filesystem::remove(folder_.file("out.exr.checkpoint"));
    const Finished again = lancer({"resume", "out.exr", "--spp", "150"});
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_THAT(again.err, HasSubstr("from the beginning"));
    EXPECT_TRUE(folder_.read("out.exr") == whole({"--spp", "150"}));
}

TEST_F(Resume, ReproducesAPicture) {
    EXPECT_EQ(lancer({"render", "scene.toml", "-o", "out.exr", "--aov", "normal,interval", "--threads", "1"}).status, 0);
    const Finished same = lancer({"reproduce", "out.exr", "--threads", "3"});
    EXPECT_EQ(same.status, 0) << same.err;
    EXPECT_THAT(same.out, HasSubstr("out.exr is reproduced"));
    std::string changed = path_scene;
    changed.replace(changed.find("#c08040"), 7, "#c08041");
    folder_.write("scene.toml", changed);
    const Finished refused = lancer({"reproduce", "out.exr"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("scene.toml has changed"));
}

TEST_F(Resume, AStatedErrorEndsTheRender) {
    const Finished finished = lancer(
        {"render", "scene.toml", "--error", "20%", "-o", "out.exr", "--aov", "interval", "--progress", "json", "--preview", "p.png"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.err, HasSubstr("\"ended_by\":\"error\""));
    const Finished few = lancer({"render", "scene.toml", "--error", "0.1%", "--spp", "64", "-o", "few.exr"});
    EXPECT_EQ(few.status, 0);
    EXPECT_THAT(few.out, HasSubstr("Ended by the number of samples."));
    EXPECT_THAT(few.out, HasSubstr("Error: "));
    const Finished timed = lancer({"render", "scene.toml", "--time", "200ms", "-o", "timed.exr"});
    EXPECT_EQ(timed.status, 0);
    EXPECT_THAT(timed.out, HasSubstr("Ended by the time."));
    EXPECT_EQ(lancer({"reproduce", "timed.exr"}).status, 2);
    // Shards keep to the goal by themselves.
    for (const char* shard : {"1/2", "2/2"}) {
        EXPECT_EQ(lancer({"render", "scene.toml", "--error", "20%", "-o", "part.exr", "--aov", "interval", "--shard", shard}).status, 0);
    }
    EXPECT_EQ(lancer({"merge", "part.1-of-2.film", "part.2-of-2.film", "-o", "merged.exr"}).status, 0);
    EXPECT_TRUE(folder_.read("merged.exr") == folder_.read("out.exr"));
    EXPECT_THAT(lancer({"render", "scene.toml", "--error", "0", "-o", "a.exr"}).err, HasSubstr("expected a share"));
    EXPECT_THAT(lancer({"render", "scene.toml", "--clamp", "0.05", "-o", "a.exr"}).out, HasSubstr("Clamping removed"));
}

// A disk with room for the picture but not for its films: what is there stays, and it is said.
TEST_F(Resume, AFullDiskKeepsWhatIsThere) {
    std::filesystem::create_directory(folder_.file("full"));
    folder_.write("mount.sh", "mount -t tmpfs -o size=200k tmpfs full");
    if (Running(folder_, {"sh", "mount.sh"}).wait().status != 0) {
        GTEST_SKIP() << "no file system of our own can be mounted here";
    }
    folder_.write("full/out.exr.checkpoint", "older");
    const Finished finished =
        lancer({"render", "scene.toml", "--checkpoint", "30ms", "--size", "150x120", "-o", "full/out.exr", "--spp", "40"});
    EXPECT_EQ(folder_.read("full/out.exr.checkpoint"), "older");
    const bool has_picture = folder_.has("full/out.exr");
    folder_.write("umount.sh", "umount full");
    EXPECT_EQ(Running(folder_, {"sh", "umount.sh"}).wait().status, 0);
    EXPECT_TRUE(has_picture);
    EXPECT_EQ(finished.status, 0);
    EXPECT_THAT(finished.err, HasSubstr("no checkpoint"));
    EXPECT_THAT(finished.err, HasSubstr("No space left on device"));
}

// Read-only from the start, and from the middle of a render on. (Permissions alone would not stop a test that runs as root.)
TEST_F(Resume, AReadOnlyFolderKeepsWhatIsThere) {
    const auto shell = [&](const std::string& line) {
        folder_.write("line.sh", line);
        return Running(folder_, {"sh", "line.sh"}).wait().status == 0;
    };
    std::filesystem::create_directory(folder_.file("locked"));
    if (!shell("mount -t tmpfs tmpfs locked && echo older > locked/out.exr && mount -o remount,ro locked")) {
        GTEST_SKIP() << "no file system of our own can be mounted here";
    }
    const Finished refused = lancer({"render", "scene.toml", "-o", "locked/out.exr"});
    EXPECT_TRUE(shell("mount -o remount,rw locked"));
    Running running(folder_, {LANCER_PROGRAM, "render", "scene.toml", "--spp", "100000", "--checkpoint", "50ms", "-o", "locked/out.exr"});
    bool locked = false;
    for (int i = 0; i < 1000 && running.is_alive() && !locked; ++i) {  // not while a file is being written
        std::this_thread::sleep_for(std::chrono::milliseconds(7));
        locked = folder_.has("locked/out.exr.checkpoint") && shell("mount -o remount,ro locked");
    }
    const std::string checkpoint = folder_.read("locked/out.exr.checkpoint");
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    running.signal(SIGINT);
    const Finished stopped = running.wait();
    const std::string picture = folder_.read("locked/out.exr");
    const bool kept = folder_.read("locked/out.exr.checkpoint") == checkpoint;
    EXPECT_TRUE(shell("umount locked"));

    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("-o locked/out.exr: no permission to write in the folder locked"));
    EXPECT_TRUE(locked);
    EXPECT_EQ(stopped.status, 3);
    EXPECT_THAT(stopped.err, HasSubstr("no checkpoint: cannot write locked/out.exr.checkpoint: Read-only file system"));
    EXPECT_THAT(stopped.err, HasSubstr("cannot write locked/out.exr: Read-only file system"));
    EXPECT_EQ(picture, "older\n");
    EXPECT_TRUE(kept);
    EXPECT_GT(checkpoint.size(), 1000u);
}

// What a killed render leaves half written is removed by the next one in that folder; what another writes at this moment, or another machine, is not.
TEST_F(Resume, WhatAKillLeavesBehindIsCleanedUp) {
    char host[256] = {};
    ASSERT_EQ(::gethostname(host, sizeof(host) - 1), 0);
    const std::string dead = ".lancer-" + std::string(host) + "-999999-0.part", alive = ".lancer-" + std::string(host) + "-999999-1.part";
    const std::string elsewhere = ".lancer-elsewhere-1-0.part";
    for (const std::string& name : {dead, alive, elsewhere}) {
        folder_.write(name, "half a pict");
    }
    const int descriptor = ::open(folder_.file(alive).c_str(), O_RDONLY);
    ASSERT_EQ(::flock(descriptor, LOCK_EX), 0);
    EXPECT_EQ(lancer({"render", "scene.toml", "-o", "out.exr", "--spp", "1"}).status, 0);
    EXPECT_FALSE(folder_.has(dead));
    EXPECT_TRUE(folder_.has(alive));
    EXPECT_TRUE(folder_.has(elsewhere));
    ::close(descriptor);
    EXPECT_EQ(lancer({"resume", "out.exr"}).status, 0);
    EXPECT_FALSE(folder_.has(alive));
}

TEST_F(Resume, BadUseIsExplained) {
    EXPECT_THAT(lancer({"resume"}).err, HasSubstr("which picture?"));
    EXPECT_EQ(lancer({"resume", "nothing.exr"}).status, 2);
    EXPECT_THAT(lancer({"merge", "-o", "a.exr"}).err, HasSubstr("which films?"));
    EXPECT_THAT(lancer({"merge", "scene.toml", "-o", "a.exr"}).err, HasSubstr("scene.toml is not a film of lancer"));
    for (const char* wrong : {"0/2", "3/2", "1", "1/", "a/b", "-1/2"}) {
        EXPECT_THAT(lancer({"render", "scene.toml", "-o", "a.exr", "--shard", wrong}).err, HasSubstr("expected I/N")) << wrong;
    }
    EXPECT_THAT(lancer({"render", "scene.toml", "-o", "a.exr", "--checkpoint", "soon"}).err, HasSubstr("expected a time"));
}

}  // namespace
}  // namespace lancer::test
