// lancer farm without a cluster: by hand, and with programs that stand in for Slurm's. tests/farm runs it on a real Slurm.
#include <sys/stat.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace lancer::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Words = std::vector<std::string>;

class Farm : public testing::Test {
protected:
    Farm() {
        folder.write("scene.toml", small_scene);
        std::filesystem::copy_file(scene_file("gltf/carousel.gltf"), folder.path() / "film.gltf");
    }

    Finished lancer(Words words, const Words& more = {}, const Environment& environment = {}) {
        words.insert(words.end(), more.begin(), more.end());
        return run_lancer(folder, words, environment);
    }
    Words submit(const Words& more) {
        Words words = {"farm", "submit"};
        words.insert(words.end(), picture.begin(), picture.end());
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    nlohmann::json status(const std::string& job) { return nlohmann::json::parse(lancer({"farm", "status", job, "--json"}).out); }
    Words names_in(const std::string& place) {
        Words names;
        for (const auto& entry : std::filesystem::directory_iterator(folder.path() / place)) {
            names.push_back(entry.path().filename().string());
        }
        return names;
    }

    Folder folder;
    const Words picture = {"scene.toml", "--size", "200x150", "--ssaa", "2"};
    const Words film = {"film.gltf", "--size", "100x60", "--spp", "2", "--frames", "4:12:4", "--fps", "8"};
};

TEST_F(Farm, PartsMakeTheBytesOfOneMachine) {
    Words single = {"render"};
    single.insert(single.end(), picture.begin(), picture.end());
    ASSERT_EQ(lancer(single, {"-o", "single.exr", "-o", "single.png"}).status, 0);
    const Finished submitted = lancer(submit({"-o", "out.exr", "-o", "out.png", "--shards", "5", "--tasks", "2"}));
    EXPECT_EQ(submitted.status, 0) << submitted.err;
    EXPECT_THAT(submitted.out, AllOf(HasSubstr("out.farm: 5 shards in 2 tasks"), HasSubstr("lancer farm work out.farm TASK")));
    EXPECT_FALSE(folder.has("out.exr"));
    EXPECT_EQ(lancer({"farm", "status", "out.farm"}).status, 1);

    const Finished worked = lancer({"farm", "work", "out.farm", "2"});
    EXPECT_EQ(worked.status, 0) << worked.err;
    EXPECT_THAT(worked.out, AllOf(HasSubstr("shard 2 of 5: done in"), HasSubstr("shard 4 of 5: done in"), Not(HasSubstr("shard 3"))));
    EXPECT_THAT(lancer({"farm", "status", "out.farm"}).out, HasSubstr("]  40 %  2 of 5 shards; no scheduler was asked"));
    const Finished early = lancer({"farm", "merge", "out.farm"});
    EXPECT_EQ(early.status, 1);
    EXPECT_THAT(early.err, HasSubstr("3 of 5 parts are missing: shard 1 of 5; shard 3 of 5; shard 5 of 5"));
    EXPECT_FALSE(folder.has("out.exr"));

    EXPECT_THAT(lancer({"farm", "work", "out.farm"}).out, AllOf(HasSubstr("shard 5 of 5: done"), Not(HasSubstr("shard 2"))));
    EXPECT_EQ(lancer({"farm", "merge", "out.farm"}).status, 0);
    EXPECT_TRUE(folder.read("out.exr") == folder.read("single.exr"));
    EXPECT_TRUE(folder.read("out.png") == folder.read("single.png"));
    EXPECT_THAT(names_in("out.farm/shards"), IsEmpty());
    EXPECT_EQ(lancer({"farm", "status", "out.farm"}).status, 0);
    EXPECT_EQ(status("out.farm").at("share"), 1.0);
    EXPECT_THAT(lancer({"farm", "merge", "out.farm"}).status, 0) << "merging twice";
    std::filesystem::remove(folder.path() / "out.png");
    EXPECT_EQ(lancer({"farm", "merge", "out.farm"}).status, 1) << "a picture that was taken away is missing";
}

TEST_F(Farm, WhatIsThereCanBeMerged) {
    ASSERT_EQ(lancer(submit({"-o", "out.png", "--shards", "3", "--keep-shards"})).status, 0);
    ASSERT_EQ(lancer({"farm", "work", "out.farm", "1", "3"}).status, 0);
    const Finished partial = lancer({"farm", "merge", "out.farm", "--partial"});
    EXPECT_EQ(partial.status, 1);
    EXPECT_THAT(partial.err, HasSubstr("shard 2 of 3"));
    const std::string before = folder.read("out.png");
    EXPECT_FALSE(before.empty());
    ASSERT_EQ(lancer({"farm", "work", "out.farm"}).status, 0);
    ASSERT_EQ(lancer({"farm", "merge", "out.farm"}).status, 0);
    EXPECT_FALSE(folder.read("out.png") == before);
    EXPECT_EQ(names_in("out.farm/shards").size(), 3u);
}

TEST_F(Farm, FramesAreJoinedByWhoeverBringsTheLastPart) {
    Words words = {"render"};
    words.insert(words.end(), film.begin(), film.end());
    ASSERT_EQ(lancer(words, {"-o", "one.##.exr"}).status, 0);
    words.insert(words.begin(), "farm");
    words[1] = "submit";
    for (const char* shards : {"1", "3"}) {
        const std::string name = std::string("many") + shards;
        const Finished submitted = lancer(words, {"-o", name + ".##.exr", "-o", name + ".##.png", "--shards", shards});
        ASSERT_EQ(submitted.status, 0) << submitted.err;
        EXPECT_THAT(submitted.out, HasSubstr("3 frames"));
        const std::string job = name + ".farm";
        ASSERT_EQ(lancer({"farm", "work", job}).status, 0);
        EXPECT_THAT(lancer({"farm", "status", job}).out, HasSubstr("all written"));
        for (const char* frame : {".04", ".08", ".12"}) {
            EXPECT_TRUE(folder.read(name + frame + ".exr") == folder.read(std::string("one") + frame + ".exr")) << name << frame;
        }
        EXPECT_EQ(lancer({"farm", "merge", job}).status, 0);
    }
    // Frames that an earlier job or a person has made are not made again.
    ASSERT_EQ(lancer(words, {"-o", "one.##.exr"}).status, 0);
    const auto before = std::filesystem::last_write_time(folder.path() / "one.08.exr");
    ASSERT_EQ(lancer({"farm", "work", "one.farm"}).status, 0);
    EXPECT_EQ(std::filesystem::last_write_time(folder.path() / "one.08.exr"), before);
}

TEST_F(Farm, TwoMachinesMayDoTheSame) {
    ASSERT_EQ(lancer(submit({"-o", "out.exr", "--shards", "4", "--keep-shards"})).status, 0);
    {
        std::vector<std::unique_ptr<Running>> machines;
        for (int i = 0; i < 4; ++i) {
            machines.push_back(std::make_unique<Running>(folder, Words{LANCER_PROGRAM, "farm", "work", "out.farm"}));
        }
        for (auto& machine : machines) {
            EXPECT_EQ(machine->wait().status, 0);
        }
    }
    EXPECT_EQ(names_in("out.farm/shards").size(), 4u);
    ASSERT_EQ(lancer({"farm", "merge", "out.farm"}).status, 0);
    ASSERT_EQ(lancer({"render"}, picture).status, 2);
    Words single = {"render"};
    single.insert(single.end(), picture.begin(), picture.end());
    ASSERT_EQ(lancer(single, {"-o", "single.exr"}).status, 0);
    EXPECT_TRUE(folder.read("out.exr") == folder.read("single.exr"));
}

TEST_F(Farm, KilledWorkersLeaveNothingHalf) {
    const Words large = {"--size", "900x700", "--ssaa", "4", "-o", "out.exr", "--shards", "6"};
    ASSERT_EQ(lancer(submit(large)).status, 0);
    for (int i = 0; i < 5; ++i) {
        Running worker(folder, {LANCER_PROGRAM, "farm", "work", "out.farm"});
        std::this_thread::sleep_for(std::chrono::milliseconds(60 + 90 * i));
        worker.signal(SIGKILL);
        worker.wait();
    }
    ASSERT_EQ(lancer({"farm", "work", "out.farm"}).status, 0);
    ASSERT_EQ(lancer({"farm", "merge", "out.farm"}).status, 0);
    ASSERT_EQ(lancer({"render", "scene.toml", "--size", "900x700", "--ssaa", "4", "-o", "single.exr"}).status, 0);
    EXPECT_TRUE(folder.read("out.exr") == folder.read("single.exr"));
    EXPECT_THAT(names_in("out.farm/shards"), IsEmpty()) << "what killed workers left is swept up";
}

TEST_F(Farm, PartsInTheMakingCount) {
    ASSERT_EQ(lancer(submit({"--size", "1600x1200", "--ssaa", "8", "-o", "out.exr", "--shards", "2"})).status, 0);
    EXPECT_EQ(status("out.farm").at("share"), 0.0);
    Running worker(folder, {LANCER_PROGRAM, "farm", "work", "out.farm"});
    double share = 0.0;
    while (share == 0.0 && worker.is_alive()) {
        const nlohmann::json now = status("out.farm");
        share = now.at("units_done") == 0 ? now.at("share").get<double>() : 0.0;
    }
    EXPECT_GT(share, 0.0);
    EXPECT_LT(share, 0.5);
    worker.signal(SIGINT);
    EXPECT_EQ(worker.wait().status, 1);
    EXPECT_THAT(names_in("out.farm/running"), IsEmpty());
}

TEST_F(Farm, AChangedSceneIsNoticed) {
    ASSERT_EQ(lancer(submit({"-o", "out.exr", "--shards", "2"})).status, 0);
    ASSERT_EQ(lancer({"farm", "work", "out.farm", "1"}).status, 0);
    folder.write("scene.toml", std::string(small_scene) + "\n[[sphere]]\ncenter = [1, 3, 0]\nradius = 0.5\nmaterial = \"red\"\n");
    const Finished worked = lancer({"farm", "work", "out.farm", "2"});
    EXPECT_EQ(worked.status, 2);
    EXPECT_THAT(worked.err, HasSubstr("scene.toml, or a file that it reads, is not what it was"));
    EXPECT_THAT(lancer({"farm", "status", "out.farm"}).out, HasSubstr("shard 2 of 2 failed with status 2: see out.farm/log/2.log"));
    EXPECT_EQ(status("out.farm").at("failed")[0].at("task"), 2);
    const Finished again = lancer(submit({"-o", "out.exr", "--shards", "2"}));
    EXPECT_EQ(again.status, 2);
    EXPECT_THAT(again.err, HasSubstr("a scene, or files that it reads, that have changed"));
    folder.write("scene.toml", small_scene);
    EXPECT_EQ(lancer(submit({"-o", "out.exr", "--shards", "2"})).status, 0);
    EXPECT_THAT(status("out.farm").at("failed"), IsEmpty());
    EXPECT_EQ(lancer({"farm", "work", "out.farm"}).status, 0);
    EXPECT_EQ(lancer({"farm", "merge", "out.farm"}).status, 0);
    EXPECT_THAT(lancer(submit({"-o", "out.exr", "--shards", "2"})).out, HasSubstr("out.farm is done already"));
}

// ---- Programs in Slurm's place ------------------------------------------------------------------------------------------------------

class Slurm : public Farm {
protected:
    Slurm() {
        std::filesystem::create_directory(folder.path() / "bin");
        program("scontrol", "echo 'MaxArraySize            = 7'");
        program("sbatch", "echo \"sbatch $*\" >> calls; echo $(wc -l < calls)';cluster'");
        program("squeue", "cat queue 2>/dev/null");
        program("scancel", "echo \"scancel $*\" >> calls");
    }

    void program(const std::string& name, const std::string& text) {
        folder.write("bin/" + name, "#!/bin/sh\ncd " + folder.path().string() + "\n" + text + "\n");
        ::chmod(folder.file("bin/" + name).c_str(), 0755);
    }
    Finished with_slurm(const Words& words, const Words& more = {}) {
        return lancer(words, more, {{"PATH", folder.file("bin") + ":/usr/bin:/bin"}});
    }
    Words calls() {
        Words lines;
        std::istringstream text(folder.read("calls"));
        for (std::string line; std::getline(text, line);) {
            lines.push_back(line);
        }
        return lines;
    }
};

TEST_F(Slurm, IsToldWhatToRun) {
    const Finished submitted =
        with_slurm(submit({"-o", "out.exr", "--shards", "20", "--slurm", "--sbatch", "--partition=night --time=1:00", "--cpus", "3"}));
    EXPECT_EQ(submitted.status, 0) << submitted.err;
    EXPECT_THAT(submitted.out, HasSubstr("20 shards in 6 tasks, given to Slurm: array 1, merge 2"));
    const std::string folder_name = std::filesystem::canonical(folder.path()).string();
    ASSERT_EQ(calls().size(), 2u);
    EXPECT_THAT(calls()[0], AllOf(HasSubstr("--parsable --requeue"), HasSubstr(" --array=1-6 "), HasSubstr("--chdir=" + folder_name + " "),
                                  HasSubstr("--output=" + folder_name + "/out.farm/log/%a.log"), HasSubstr("--partition=night --time=1:00"),
                                  HasSubstr("--cpus-per-task=3 "), testing::EndsWith(folder_name + "/out.farm/task.sh")));
    EXPECT_THAT(calls()[1], AllOf(HasSubstr("--dependency=afterany:1 "), testing::EndsWith("/out.farm/merge.sh")));
    EXPECT_THAT(folder.read("out.farm/task.sh"), HasSubstr("farm work " + folder_name + "/out.farm \"$SLURM_ARRAY_TASK_ID\""));

    folder.write("queue", "RUNNING\nPENDING\nPENDING\n");
    EXPECT_THAT(with_slurm({"farm", "status", "out.farm"}).out, HasSubstr("0 of 20 shards; 2 tasks running, 4 waiting"));
    EXPECT_THAT(with_slurm(submit({"-o", "out.exr", "--shards", "20", "--slurm"})).out, HasSubstr("out.farm is at work"));
    EXPECT_EQ(calls().size(), 2u);

    EXPECT_EQ(with_slurm({"farm", "cancel", "out.farm"}).status, 0);
    EXPECT_THAT(calls(), AllOf(Contains(HasSubstr("scancel --quiet 1")), Contains(HasSubstr("scancel --quiet 2"))));
    folder.write("queue", "");
    EXPECT_THAT(with_slurm({"farm", "status", "out.farm"}).out, HasSubstr("; cancelled"));
}

TEST_F(Slurm, IsGivenAgainWhatIsMissing) {
    ASSERT_EQ(with_slurm(submit({"-o", "out.exr", "--shards", "5", "--slurm"})).status, 0);
    ASSERT_EQ(with_slurm({"farm", "work", "out.farm", "1", "4"}).status, 0);
    for (int tries = 0; tries < 3; ++tries) {
        const Finished merged = with_slurm({"farm", "merge", "out.farm", "--again"});
        EXPECT_EQ(merged.status, 1);
        EXPECT_THAT(merged.out, HasSubstr("Submitted again"));
        EXPECT_THAT(calls()[2 + 2 * static_cast<std::size_t>(tries)], HasSubstr("--array=2-3,5 "));
    }
    EXPECT_THAT(with_slurm({"farm", "merge", "out.farm", "--again"}).out, IsEmpty()) << "not for ever";
    EXPECT_EQ(calls().size(), 8u);
    EXPECT_EQ(with_slurm(submit({"-o", "out.exr", "--shards", "5", "--slurm"})).status, 0) << "but a person may say so";
    EXPECT_THAT(calls()[8], HasSubstr("--array=2-3,5 "));
    ASSERT_EQ(with_slurm({"farm", "work", "out.farm"}).status, 0);
    EXPECT_EQ(with_slurm({"farm", "merge", "out.farm", "--again"}).status, 0);
    EXPECT_EQ(calls().size(), 10u);
}

TEST_F(Slurm, IsNotAskedAgainForWhatCannotBe) {
    ASSERT_EQ(with_slurm(submit({"-o", "out.exr", "--shards", "2", "--slurm"})).status, 0);
    folder.write("scene.toml", "nonsense");
    ASSERT_EQ(with_slurm({"farm", "work", "out.farm"}).status, 2);
    EXPECT_THAT(with_slurm({"farm", "merge", "out.farm", "--again"}).out, IsEmpty());
    folder.write("scene.toml", small_scene);
    ASSERT_EQ(with_slurm({"farm", "cancel", "out.farm"}).status, 0);
    const std::size_t before = calls().size();
    EXPECT_EQ(with_slurm({"farm", "merge", "out.farm", "--again"}).status, 1);
    EXPECT_EQ(calls().size(), before);
}

TEST_F(Slurm, RefusalsAreTold) {
    program("sbatch", "echo 'sbatch: error: invalid partition specified: night' >&2; exit 1");
    const Finished refused = with_slurm(submit({"-o", "out.exr", "--slurm"}));
    EXPECT_EQ(refused.status, 3);
    EXPECT_THAT(refused.err, HasSubstr("sbatch ended with 1: sbatch: error: invalid partition specified: night"));
    const Finished absent = lancer(submit({"-o", "other.exr", "--slurm"}), {}, {{"PATH", "/nowhere"}});
    EXPECT_EQ(absent.status, 3);
    EXPECT_THAT(absent.err, HasSubstr("scontrol is not on this machine: this goes on where the programs of Slurm are"));
    EXPECT_FALSE(folder.has("other.farm"));
}

// ---- Mistakes -----------------------------------------------------------------------------------------------------------------------

TEST_F(Farm, MistakesAreExplained) {
    std::filesystem::create_directory(folder.path() / "taken");
    folder.write("taken/file", "");
    ASSERT_EQ(lancer(submit({"-o", "out.exr", "--shards", "2"})).status, 0);
    folder.write("bad.toml", "[camera]\nfov = \"wide\"\n");
    std::filesystem::create_directory(folder.path() / "broken");
    folder.write("broken/manifest.json", "{\"format\": 1, \"lancer\": 3}");
    const std::pair<Words, const char*> mistakes[] = {
        {{"farm"}, "lancer farm: error: submit, status or cancel?"},
        {{"farm", "submti"}, "there is no subcommand submti; did you mean \"submit\"?"},
        {{"farm", "submit"}, "which scene?"},
        {{"farm", "submit", "scene.toml"}, "where shall the picture go?"},
        {{"farm", "submit", "bad.toml", "-o", "a.exr"}, "bad.toml:2"},
        {{"farm", "submit", "scene.toml", "-o", "a.exr", "--camera", "none"}, "has no camera \"none\""},
        {{"farm", "submit", "scene.toml", "-o", "a.xyz"}, ".xyz is not a format"},
        {{"farm", "submit", "scene.toml", "-o", "a.exr", "--shards", "0"}, "--shards: expected a whole number from 1"},
        {{"farm", "submit", "scene.toml", "-o", "a.exr", "--shard", "1/2"}, "--shards N says how many there are"},
        {{"farm", "submit", "scene.toml", "-o", "a.exr", "--stats", "s.json"}, "--stats goes with \"lancer render\""},
        {{"farm", "submit", "scene.toml", "-o", "a.exr", "--sbatch", "--time=1"}, "--sbatch goes with --slurm"},
        {{"farm", "submit", "film.gltf", "-o", "a.exr", "--frames", "1:2"}, "each frame needs a file of its own"},
        {{"farm", "submit", "scene.toml", "-o", "a.exr", "--folder", "taken"},
         "there is no manifest.json in it; name another with --folder"},
        {{"farm", "submit", "scene.toml", "-o", "out.exr", "--shards", "2", "--ssaa", "3"}, "is a job with other options"},
        {{"farm", "submit", "scene.toml", "-o", "out.exr", "--slurp"}, "there is no option --slurp; did you mean \"--slurm\"?"},
        {{"farm", "status"}, "JOB is required"},
        {{"farm", "status", "none"}, "there is no folder none"},
        {{"farm", "status", "taken"}, "taken is no job of a farm"},
        {{"farm", "status", "broken"}, "manifest.json can't be understood"},
        {{"farm", "cancel", "none"}, "there is no folder none"},
        {{"farm", "merge", "none"}, "there is no folder none"},
        {{"farm", "work", "out.farm", "17"}, "task 17: out.farm has the tasks 1 to 2"},
        {{"farm", "work", "out.farm", "0"}, "task 0"},
        {{"render", "scene.toml", "-o", "a.exr", "--only-if", "0123"}, "is not what it was"},
    };
    const std::vector<std::string> before = folder.names();
    for (const auto& [words, said] : mistakes) {
        const Finished finished = lancer(words);
        EXPECT_EQ(finished.status, 2) << said << finished.out;
        EXPECT_THAT(finished.err, HasSubstr(said));
        EXPECT_EQ(folder.names(), before);
    }
}

TEST_F(Farm, HelpShowsExamples) {
    for (const Words& words : {Words{"movie"}, Words{"farm"}, Words{"farm", "submit"}, Words{"farm", "status"}, Words{"farm", "cancel"},
                               Words{"farm", "work"}, Words{"farm", "merge"}}) {
        const Finished help = lancer(words, {"--help"});
        EXPECT_EQ(help.status, 0);
        std::string example = "Example:\n  lancer";
        for (const std::string& word : words) {
            example += word == "movie" ? "" : " " + word;
        }
        EXPECT_THAT(help.out, HasSubstr(example));
    }
}

}  // namespace
}  // namespace lancer::test
