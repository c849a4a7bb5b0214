// What is said to those who ask for help, and to those who misspell.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"

namespace lancer::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

using Words = std::vector<std::string>;

TEST(Help, IsSpeltInManyWays) {
    const Folder folder;
    const Finished plain = run_lancer(folder, {"--help"});
    EXPECT_EQ(plain.status, 0);
    for (const char* word : {"view", "render", "info", "import", "compare", "movie", "farm", "figures", "schema", "bench", "--threads",
                             "--render-all", "Example:", "Exit status"}) {
        EXPECT_THAT(plain.out, HasSubstr(word));
    }
    for (const char* spelling : {"-help", "-h"}) {
        const Finished other = run_lancer(folder, {spelling});
        EXPECT_EQ(other.status, 0);
        EXPECT_EQ(other.out, plain.out) << spelling;
    }
}

TEST(Help, ShowsAnExampleForEachSubcommand) {
    const Folder folder;
    for (const char* name : {"view", "render", "info", "import", "compare", "figures", "schema", "bench"}) {
        const Finished help = run_lancer(folder, {name, "--help"});
        EXPECT_EQ(help.status, 0) << name;
        EXPECT_THAT(help.out, HasSubstr(std::string("Example:\n  lancer ") + name));
        EXPECT_EQ(run_lancer(folder, {name, "-help"}).out, help.out);
    }
}

TEST(Version, IsPrinted) {
    const Folder folder;
    const Finished version = run_lancer(folder, {"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_THAT(version.out, testing::MatchesRegex("lancer [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(Schema, IsJson) {
    const Folder folder;
    const Finished schema = run_lancer(folder, {"schema"});
    EXPECT_EQ(schema.status, 0);
    EXPECT_THAT(schema.out, StartsWith("{"));
    EXPECT_THAT(schema.out, HasSubstr("\"$schema\""));
    EXPECT_THAT(schema.out, HasSubstr("look_at"));
}

struct Mistake {
    Words words;
    std::string said;
};

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreExplainedAndNothingIsWritten) {
    const Folder folder;
    folder.write("scene.toml", small_scene);
    folder.write("old.png", "precious");
    const Finished finished = run_lancer(folder, GetParam().words);
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr(GetParam().said));
    EXPECT_THAT(finished.out, IsEmpty());
    EXPECT_THAT(folder.names(), ElementsAre("old.png", "scene.toml"));
    EXPECT_TRUE(folder.read("old.png") == "precious");
}

const std::string number_of_threads = "--threads: expected a whole number from 1 to 1024, not ";

INSTANTIATE_TEST_SUITE_P(
    Threads, Mistakes,
    testing::Values(Mistake{{"-threads", "0"}, number_of_threads + "\"0\""}, Mistake{{"-threads", "abc"}, number_of_threads + "\"abc\""},
                    Mistake{{"--threads", "-3"}, number_of_threads + "\"-3\""}, Mistake{{"-thread", "2.5"}, number_of_threads + "\"2.5\""},
                    Mistake{{"--threads=99999999999"}, number_of_threads + "\"99999999999\""},
                    Mistake{{"-threads", ""}, number_of_threads + "\"\""}, Mistake{{"-threads"}, "--threads needs a value"},
                    Mistake{{"render", "scene.toml", "-o", "old.png", "-threads", "0"}, number_of_threads + "\"0\""},
                    Mistake{{"view", "scene.toml", "--threads", "x"}, number_of_threads + "\"x\""},
                    Mistake{{"-render-all", "-threads", "0"}, number_of_threads + "\"0\""},
                    Mistake{{"figures", "-threads", "0"}, number_of_threads + "\"0\""}));

INSTANTIATE_TEST_SUITE_P(
    Names, Mistakes,
    testing::Values(
        Mistake{{"rendr", "scene.toml"}, "there is no subcommand rendr; did you mean \"render\"?"},
        Mistake{{"scene.toml"}, "\"lancer view scene.toml\" shows it"}, Mistake{{"qqqq"}, "there is no subcommand qqqq\n"},
        Mistake{{"--thraeds", "2"}, "there is no option --thraeds; did you mean \"--threads\"?"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--ssa", "2"}, "there is no option --ssa; did you mean \"--ssaa\"?"},
        Mistake{{"render", "--bouncs=2", "scene.toml", "-o", "old.png"}, "there is no option --bouncs; did you mean \"--bounces\"?"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--sps", "16"}, "there is no option --sps"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--camera", "abov"},
                "has no camera \"abov\" (it has above); did you mean \"above\"?"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--lights", "sun,lmp"},
                "has no light \"lmp\" (it has 2 lights: sun, lamp); did you mean \"lamp\"?"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--aa", "adaptve"},
                "--aa: expected uniform or adaptive, not \"adaptve\"; did you mean \"adaptive\"?"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--integrator", "pats"},
                "--integrator: expected auto or whitted or path or direct or light or bdpt or vcm, not"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--trace", "fast"}, "--trace: expected auto or lanes or bvh, not \"fast\""},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--progress", "loud"}, "--progress: expected bar or plain or json"}));

INSTANTIATE_TEST_SUITE_P(
    Values, Mistakes,
    testing::Values(
        Mistake{{"render", "scene.toml", "-o", "old.png", "--size", "0x100"}, "--size: expected width x height in pixels"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--size", "100"}, "--size: expected width x height in pixels"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--size", "x"}, "--size: expected width x height in pixels"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--size", "70000x2"}, "each from 1 to 65536"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--size", "65536x65536"}, "--size: expected at most 268 million pixels"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--bounces", "-1"}, "--bounces: expected a whole number from 0 to"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--bounces", "100000"}, "--bounces: expected a whole number from 0 to"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--ssaa", "0"}, "--ssaa: expected a whole number from 1 to 64"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--exposure", "nan"}, "--exposure: expected a number from -100 to 100"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--adaptive-threshold", "2"},
                "--adaptive-threshold: expected a number from 0 to 1"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--adaptive-depth", "9"},
                "--adaptive-depth: expected a whole number from 0 to 8"},
        Mistake{{"render", "scene.toml", "-o", "old.png", "--ssaa", "2", "--adaptive-depth", "2"}, "say which with --aa"},
        Mistake{{"bench", "--tries", "0"}, "--tries: expected a whole number from 1"}));

INSTANTIATE_TEST_SUITE_P(
    Files, Mistakes,
    testing::Values(Mistake{{"render"}, "which scene?"}, Mistake{{"view"}, "which scene?"}, Mistake{{"info"}, "which file?"},
                    Mistake{{"import"}, "which scene?"}, Mistake{{"render", "scene.toml"}, "where shall the picture go?"},
                    Mistake{{"render", "scene.toml", "-o"}, "--output needs a value"},
                    Mistake{{"render", "scene.toml", "other.toml", "-o", "old.png"}, "one scene at a time"},
                    Mistake{{"render", "missing.toml", "-o", "old.png"}, "missing.toml"}, Mistake{{"view", "missing.toml"}, "missing.toml"},
                    Mistake{{"info", "missing.toml"}, "missing.toml"},
                    Mistake{{"render", "scene.toml", "-o", "none/new.png"}, "-o none/new.png: there is no folder none"},
                    Mistake{{"render", "scene.toml", "-o", "old.png", "-o", "none/new.png"}, "-o none/new.png: there is no folder none"},
                    Mistake{{"render", "scene.toml", "-o", "old.png/new.png"}, "old.png is not a folder"},
                    Mistake{{"render", "scene.toml", "-o", "."}, "this is a folder"},
                    Mistake{{"render", "scene.toml", "-o", ""}, "the file needs a name"},
                    Mistake{{"render", "scene.toml", "-o", "new"}, "-o new: the ending that tells the format is missing"},
                    Mistake{{"render", "scene.toml", "-o", "new.jgp"}, "-o new.jgp: .jgp is not a format that can be written"},
                    Mistake{{"render", "scene.toml", "-o", "new.jgp"}, "did you mean \".jpg\"?"},
                    Mistake{{"render", "scene.toml", "-o", "scene.toml"}, ".toml is not a format that can be written"},
                    Mistake{{"render", "scene.toml", "-o", "new.png", "-o", "./new.png"}, "-o ./new.png: this file is named twice"},
                    Mistake{{"render", "scene.toml", "-o", "old.png", "--sample-map", "none/map.png"},
                            "--sample-map none/map.png: there is no folder none"},
                    Mistake{{"render", "scene.toml", "-o", "old.png", "--stats", "none/stats.json"},
                            "--stats none/stats.json: there is no folder none"},
                    Mistake{{"figures", "none/figures"}, "there is no folder none"},
                    Mistake{{"figures", "scene.toml"}, "scene.toml is not a folder"},
                    Mistake{{"figures", "one", "two"}, "nothing is known to do with \"two\""},
                    Mistake{{"schema", "extra"}, "nothing is known to do with \"extra\""}));

}  // namespace
}  // namespace lancer::test
