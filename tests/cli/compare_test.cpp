// lancer compare: what it prints, what it writes, and its exit status.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <random>

#include "cli/program.h"
#include "lancer/image/layers.h"

namespace lancer::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Compare : public testing::Test {
protected:
    Finished run(std::vector<std::string> words) const {
        words.insert(words.begin(), "compare");
        return run_lancer(folder, words);
    }
    // 24 x 16 pixels of one grey.
    void write_flat(const std::string& name, float value, const Metadata& metadata = {}) const {
        write_image(folder.file(name), Image{24, 16, 3, std::vector<float>(24 * 16 * 3, value)}, metadata);
    }
    // Noise of spread 0.1, with its variances or without.
    void write_noisy(const std::string& name, unsigned seed, float mean, bool with_variances) const {
        std::mt19937 random(seed);
        std::normal_distribution<float> normal(mean, 0.1f);
        LayeredImage image{24, 16, {}, {}};
        for (const char* channel : {"R", "G", "B"}) {
            Channel& made = image.channels.emplace_back(Channel{channel, Stored::float32, {}, {}});
            for (int i = 0; i < 24 * 16; ++i) {
                made.values.push_back(normal(random));
            }
        }
        for (const char* channel : {"variance.R", "variance.G", "variance.B"}) {
            if (with_variances) {
                image.channels.push_back({channel, Stored::float32, std::vector<float>(24 * 16, 0.01f), {}});
            }
        }
        write_layers(folder.file(name), image);
    }

    Folder folder;
};

TEST_F(Compare, TellsTheErrorsInATable) {
    write_flat("a.exr", 0.75f);
    write_flat("b.exr", 0.5f);
    const Finished finished = run({"a.exr", "b.exr"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.err, IsEmpty());
    for (const char* words : {"24 x 16 pixels", "bias", "+50.000 %", "MSE", "0.0625", "relMSE", "MAE", "FLIP", "exposures",
                              "Whether the means differ can't be told"}) {
        EXPECT_THAT(finished.out, HasSubstr(words));
    }
    EXPECT_THAT(finished.out, Not(HasSubstr("PSNR")));
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.exr", "b.exr"}));
}

TEST_F(Compare, ComparesDisplayedPicturesAsTheyAreShown) {
    write_flat("a.png", 1.0f);
    write_flat("b.png", 0.0f);
    const Finished finished = run({"a.png", "b.png"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_THAT(finished.out, HasSubstr("PSNR"));
    EXPECT_THAT(finished.out, HasSubstr("as displays show it"));
}

TEST_F(Compare, SpeaksToPrograms) {
    write_flat("a.exr", 0.75f);
    write_flat("b.exr", 0.5f);
    const Finished finished = run({"a.exr", "b.exr", "--json", "--max-mse", "0.01", "--max-flip", "1"});
    EXPECT_EQ(finished.status, 1);
    const auto json = nlohmann::json::parse(finished.out);
    EXPECT_EQ(json["width"], 24);
    EXPECT_DOUBLE_EQ(json["all"]["mse"], 0.0625);
    EXPECT_DOUBLE_EQ(json["channels"]["G"]["bias"], 0.25);
    EXPECT_EQ(json["flip"]["kind"], "hdr");
    EXPECT_GT(json["flip"]["mean"], 0.0);
    EXPECT_EQ(json["limits"][0]["kept"], false);
    EXPECT_EQ(json["limits"][1]["kept"], true);
}

TEST_F(Compare, KeepsToLimits) {
    write_flat("a.exr", 0.75f);
    write_flat("b.exr", 0.5f);
    EXPECT_EQ(run({"a.exr", "b.exr", "--max-mse", "0.07", "--max-relmse", "0.3", "--max-flip", "0.9"}).status, 0);
    const Finished exceeded = run({"a.exr", "b.exr", "--max-relmse", "0.2"});
    EXPECT_EQ(exceeded.status, 1);
    EXPECT_THAT(exceeded.out, HasSubstr("relMSE is 0.2404, more than the 0.2 that is allowed."));
    EXPECT_EQ(run({"a.exr", "b.exr", "--max-flip", "0.001"}).status, 1);
}

TEST_F(Compare, DoesNotForgiveWhatIsNoNumber) {
    LayeredImage image{2, 1, {{"Y", Stored::float32, {1.0f, std::numeric_limits<float>::quiet_NaN()}, {}}}, {}};
    write_layers(folder.file("a.exr"), image);
    const Finished plain = run({"a.exr", "a.exr"});
    EXPECT_EQ(plain.status, 0);
    EXPECT_THAT(plain.out, HasSubstr("warning: 1 values are infinite or no number"));
    EXPECT_EQ(run({"a.exr", "a.exr", "--max-mse", "1"}).status, 1);
}

TEST_F(Compare, TellsBiasFromNoise) {
    write_noisy("a.exr", 1, 5.0f, true);
    write_noisy("b.exr", 2, 5.0f, true);
    write_noisy("biased.exr", 3, 5.1f, true);
    const Finished same = run({"a.exr", "b.exr", "--min-p", "0.001"});
    EXPECT_EQ(same.status, 0) << same.out;
    EXPECT_THAT(same.out, HasSubstr("The means differ no more than noise does, by "));
    EXPECT_THAT(same.out, HasSubstr("3 more channels are in both"));
    const Finished biased = run({"biased.exr", "b.exr", "--min-p", "0.001"});
    EXPECT_EQ(biased.status, 1) << biased.out;
    EXPECT_THAT(biased.out, HasSubstr("The means differ by +"));
    EXPECT_THAT(biased.out, HasSubstr("p < 1e-12"));
}

TEST_F(Compare, TakesSeveralRuns) {
    for (unsigned i = 1; i <= 3; ++i) {
        write_noisy("a" + std::to_string(i) + ".exr", i, 5.2f, false);
        write_noisy("b" + std::to_string(i) + ".exr", 10 + i, 5.0f, false);
    }
    const Finished finished = run({"a1.exr", "a2.exr", "a3.exr", "--with", "b1.exr", "b2.exr", "b3.exr", "--json"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    const auto json = nlohmann::json::parse(finished.out);
    EXPECT_EQ(json["pictures"].size(), 3u);
    EXPECT_EQ(json["references"].size(), 3u);
    EXPECT_LT(json["p"], 1e-3);
    EXPECT_NEAR(json["bias"]["luminance"]["difference"], 0.2, 0.02);
    EXPECT_LT(json["bias"]["R"]["freedom"], 4.5);
    EXPECT_EQ(json["bias"]["R"]["blocks"]["tested"], 2);
}

TEST_F(Compare, ComparesOtherChannelsWhenAsked) {
    write_noisy("a.exr", 1, 5.0f, true);
    const Finished finished = run({"a.exr", "a.exr", "--channels"});
    EXPECT_THAT(finished.out, HasSubstr("variance.G"));
    EXPECT_THAT(finished.out, Not(HasSubstr("more channels")));
}

TEST_F(Compare, FindsWhetherPixelsAreExactlyTheSame) {
    write_flat("a.exr", 0.5f, {{"lancer:command", "one"}});
    write_flat("b.exr", 0.5f, {{"lancer:command", "another"}});
    write_flat("c.exr", 0.25f);
    const Finished same = run({"a.exr", "b.exr", "--exact"});
    EXPECT_EQ(same.status, 0);
    EXPECT_EQ(same.out, "The pixels are the same: 24 x 16, 3 channels.\n");
    const Finished other = run({"a.exr", "c.exr", "--exact"});
    EXPECT_EQ(other.status, 1);
    EXPECT_EQ(other.out,
              "The pixels are not the same: 384 of 384 pixels differ; the first is channel B at 0,0: 0.5 in a.exr, 0.25 in c.exr.\n");
    const Finished json = run({"a.exr", "c.exr", "--exact", "--json"});
    EXPECT_EQ(json.status, 1);
    EXPECT_EQ(nlohmann::json::parse(json.out)["same"], false);
}

TEST_F(Compare, WritesMaps) {
    write_flat("a.exr", 0.75f);
    write_flat("b.exr", 0.5f);
    const Finished finished = run({"a.exr", "b.exr", "--flip-image", "flip.png", "--error-image", "error.exr"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    const Image flip = read_image(folder.file("flip.png"));
    EXPECT_EQ(flip.width, 24);
    EXPECT_GT(flip.pixels[0], flip.pixels[1]);  // magma is purple there
    EXPECT_FLOAT_EQ(read_image(folder.file("error.exr")).pixels[0], 0.25f);
    EXPECT_EQ(run({"a.exr", "b.exr", "--flip-image", "flip.exr", "--error-image", "error.png"}).status, 0);
    EXPECT_EQ(read_image(folder.file("flip.exr")).channels, 1);
    EXPECT_EQ(read_image(folder.file("error.png")).channels, 3);
}

TEST_F(Compare, RefusesWhatItCantCompare) {
    write_flat("a.exr", 0.75f);
    write_image(folder.file("small.exr"), Image{2, 1, 3, std::vector<float>(6, 0.5f)}, {});
    folder.write("text.exr", "not a picture");
    const std::vector<std::pair<std::vector<std::string>, std::string>> mistakes = {
        {{}, "which two pictures?"},
        {{"a.exr"}, "which two pictures?"},
        {{"a.exr", "a.exr", "a.exr"}, "then --with"},
        {{"--with", "a.exr"}, "which two pictures?"},
        {{"a.exr", "none.exr"}, "cannot read the image none.exr: there is no such file"},
        {{"text.exr", "a.exr"}, "cannot read the image text.exr: its first bytes are those of no image format"},
        {{"a.exr", "small.exr"}, "a.exr has 24 x 16 pixels, small.exr has 2 x 1"},
        {{"a.exr", "small.exr", "--exact"}, "a.exr has 24 x 16 pixels, small.exr has 2 x 1"},
        {{"a.exr", "a.exr", "--min-p", "0.01"}, "nothing is known of the noise"},
        {{"a.exr", "a.exr", "--exact", "--max-mse", "1"}, "it takes no limits"},
        {{"a.exr", "a.exr", "--max-mse", "much"}, "--max-mse: expected a number"},
        {{"a.exr", "a.exr", "--flip-image", "nowhere/flip.png"}, "there is no folder nowhere"},
        {{"a.exr", "a.exr", "--flip-image", "flip.gif"}, ".gif is not a format that can be written"},
        {{"a.exr", "a.exr", "--flip"}, "there is no option --flip"},
    };
    for (const auto& [words, said] : mistakes) {
        const Finished finished = run(words);
        EXPECT_EQ(finished.status, 2) << said;
        EXPECT_THAT(finished.err, HasSubstr(said));
        EXPECT_THAT(finished.out, IsEmpty());
    }
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.exr", "small.exr", "text.exr"}));
}

}  // namespace
}  // namespace lancer::test
