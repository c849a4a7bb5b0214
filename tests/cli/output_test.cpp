// What lancer render writes beside the picture, how it shows light, and how it tells of samples that went wrong.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "lancer/image/cryptomatte.h"
#include "lancer/image/layers.h"

namespace lancer::test {
namespace {

using testing::HasSubstr;
using testing::Not;

using Words = std::vector<std::string>;

const char* const physical_scene = R"([render]
size = [48, 32]
spp = 16

[camera]
position = [0, 1, 5]
look_at = [0, 0.8, 0]

[material.lamp]
type = "diffuse"
color = "black"
emission = [4, 4, 4]

[material.red]
type = "diffuse"
color = [0.6, 0.1, 0.05]

[material.floor]
type = "diffuse"

[[sphere]]
name = "ball"
center = [0, 1, 0]
radius = 1
material = "red"

[[sphere]]
center = [2, 4, 2]
radius = 1
material = "lamp"

[[plane]]
point = [0, 0, 0]
normal = [0, 1, 0]
material = "floor"
)";

class Output : public testing::Test {
protected:
    Output() { folder.write("scene.toml", physical_scene); }

    Finished render(const Words& options) {
        Words words = {"render", "scene.toml"};
        words.insert(words.end(), options.begin(), options.end());
        return run_lancer(folder, words);
    }
    LayeredImage layers(const Words& options) {
        Words words = options;
        words.insert(words.end(), {"-o", "layers.exr", "--quiet"});
        const Finished finished = render(words);
        EXPECT_EQ(finished.status, 0) << finished.err;
        return read_layers(folder.file("layers.exr"));
    }

    Folder folder;
};

const std::vector<float>& plane(const LayeredImage& image, const std::string& name) {
    static const std::vector<float> none;
    const Channel* channel = find_channel(image, name);
    EXPECT_NE(channel, nullptr) << name;
    return channel != nullptr ? channel->values : none;
}

constexpr const char* every_aov = "albedo,normal,depth,position,uv,object_id,material_id,direct,indirect,samples,variance";

TEST_F(Output, EveryAovIsAChannelOfTheExr) {
    const LayeredImage image = layers({"--aov", every_aov, "--float", "-o", "picture.png"});
    EXPECT_TRUE(folder.has("picture.png"));
    const std::vector<float>&all = plane(image, "G"), &direct = plane(image, "direct.G"), &indirect = plane(image, "indirect.G");
    for (std::size_t i = 0; i < all.size(); ++i) {
        ASSERT_NEAR(direct[i] + indirect[i], all[i], 1e-5f * (1.0f + all[i]));
        ASSERT_EQ(plane(image, "samples")[i], 16.0f);
        ASSERT_GE(plane(image, "variance.R")[i], 0.0f);
    }
    // The ball is in the middle of the picture.
    const std::size_t middle = static_cast<std::size_t>(image.width * image.height / 2 + image.width / 2);
    EXPECT_NEAR(plane(image, "albedo.R")[middle], 0.6f, 1e-4f);
    EXPECT_NEAR(plane(image, "albedo.G")[middle], 0.1f, 1e-4f);
    EXPECT_NEAR(plane(image, "normal.Z")[middle], 1.0f, 0.05f);
    EXPECT_NEAR(plane(image, "depth.Z")[middle], 4.0f, 0.05f);
    EXPECT_NEAR(plane(image, "position.Z")[middle], 1.0f, 0.05f);
    EXPECT_EQ(plane(image, "CryptoObject00.R")[middle], cryptomatte_id("ball"));
    EXPECT_EQ(plane(image, "CryptoObject00.G")[middle], 1.0f);
    EXPECT_EQ(plane(image, "CryptoMaterial00.R")[middle], cryptomatte_id("red"));
    std::string manifest;
    for (const auto& [key, value] : image.metadata) {
        manifest += key.ends_with("/manifest") ? value : "";
    }
    EXPECT_THAT(manifest, HasSubstr("\"ball\""));
    EXPECT_THAT(manifest, HasSubstr("\"plane 1\""));
    EXPECT_TRUE(std::isinf(plane(image, "depth.Z")[0]));
    EXPECT_THAT(image.metadata.at("lancer:command"), HasSubstr("--aov albedo,normal"));
}

TEST_F(Output, ThePictureIsTheSameWithAndWithoutAovsAndForAnyThreads) {
    const LayeredImage plain = layers({}), more = layers({"--aov", every_aov, "--threads", "1"});
    EXPECT_EQ(plane(plain, "R"), plane(more, "R"));
    const LayeredImage threads = layers({"--aov", every_aov, "--threads", "3"});
    for (const Channel& channel : more.channels) {
        EXPECT_EQ(plane(threads, channel.name), channel.values) << channel.name;
    }
    EXPECT_EQ(find_channel(plain, "R")->stored, Stored::half);
    EXPECT_EQ(find_channel(layers({"--float"}), "R")->stored, Stored::float32);
}

TEST_F(Output, TheSceneMayAskForThem) {
    std::string text = physical_scene;
    text.insert(text.find("spp = 16"), "aovs = [\"depth\", \"albedo\"]\nspectral_bins = 4\nfloat = true\n");
    folder.write("scene.toml", text);
    const LayeredImage image = layers({});
    EXPECT_EQ(image.channels.size(), 3u + 1u + 3u + 4u);
    EXPECT_EQ(find_channel(image, "B")->stored, Stored::float32);
    EXPECT_NE(find_channel(image, "S0.418,750000nm"), nullptr);
    EXPECT_EQ(image.metadata.at("spectralLayoutVersion"), "1.0");
    const Finished png = render({"-o", "picture.png"});
    EXPECT_EQ(png.status, 0);
    EXPECT_THAT(png.err, HasSubstr("EXR"));
    text.replace(text.find("\"depth\""), 7, "\"dept\"");
    folder.write("scene.toml", text);
    const Finished typo = render({"-o", "picture.exr"});
    EXPECT_EQ(typo.status, 2);
    EXPECT_THAT(typo.err, HasSubstr("did you mean \"depth\""));
}

TEST_F(Output, MistakesAreSaidBeforeAnythingIsRendered) {
    const auto refused = [&](const Words& options, const std::string& sentence) {
        const Finished finished = render(options);
        EXPECT_EQ(finished.status, 2) << finished.err;
        EXPECT_THAT(finished.err, HasSubstr(sentence));
        EXPECT_FALSE(folder.has("a.exr") || folder.has("a.png"));
    };
    refused({"--aov", "albedo", "-o", "a.png"}, "EXR");
    refused({"--spectral-bins", "8", "-o", "a.png"}, "EXR");
    refused({"--aov", "albdo", "-o", "a.exr"}, "did you mean \"albedo\"");
    refused({"--aov", "beauty", "-o", "a.exr"}, "albedo, normal, depth");
    refused({"--spectral-bins", "8", "--rgb", "-o", "a.exr"}, "wavelengths");
    refused({"--view", "filmic", "-o", "a.png"}, "pbr-neutral");
    folder.write("scene.toml", small_scene);
    refused({"--aov", "albedo", "-o", "a.exr"}, "path integrator");
    const Finished list = run_lancer(folder, {"render", "--aov", "list"});
    EXPECT_EQ(list.status, 0);
    EXPECT_THAT(list.out, HasSubstr("material_id"));
    EXPECT_THAT(list.out, HasSubstr("variance"));
}

TEST_F(Output, ViewsChangeWhatIsShownAndNotTheLight) {
    const LayeredImage light = layers({});
    std::vector<std::vector<float>> shown;
    for (const std::string view : {"srgb", "pbr-neutral", "agx", "aces"}) {
        const Finished finished = render({"--view", view, "-o", "a.png", "-o", "a.exr"});
        if (view == "aces" && finished.status == 3) {
            EXPECT_THAT(finished.err, HasSubstr("libopencolorio"));
            continue;
        }
        EXPECT_EQ(finished.status, 0) << finished.err;
        EXPECT_EQ(plane(read_layers(folder.file("a.exr")), "G"), plane(light, "G")) << view;
        shown.push_back(read_image(folder.file("a.png")).pixels);
        for (std::size_t i = 0; i + 1 < shown.size(); ++i) {
            EXPECT_NE(shown[i], shown.back()) << view;
        }
    }
    EXPECT_EQ(render({"-o", "b.png"}).status, 0);
    EXPECT_EQ(read_image(folder.file("b.png")).pixels, shown.front()) << "srgb is what nobody has to ask for";
}

TEST_F(Output, CompareKnowsTheNoiseFromTheVariance) {
    for (const std::string seed : {"1", "2"}) {
        EXPECT_EQ(render({"--aov", "samples,variance", "--seed", seed, "-o", "s" + seed + ".exr"}).status, 0);
    }
    const Finished same = run_lancer(folder, {"compare", "s1.exr", "s2.exr", "--min-p", "0.0001"});
    EXPECT_EQ(same.status, 0) << same.out;
    EXPECT_THAT(same.out, HasSubstr("p ="));
    std::string text = physical_scene;
    text.replace(text.find("[4, 4, 4]"), 9, "[5, 5, 5]");
    folder.write("scene.toml", text);
    EXPECT_EQ(render({"--aov", "samples,variance", "--seed", "3", "-o", "s3.exr"}).status, 0);
    EXPECT_EQ(run_lancer(folder, {"compare", "s1.exr", "s3.exr", "--min-p", "0.0001"}).status, 1);
}

TEST_F(Output, BadSamplesAreCountedPlacedAndLeftOut) {
    EXPECT_EQ(render({"-o", "good.exr", "--stats", "stats.json"}).status, 0);
    EXPECT_EQ(nlohmann::json::parse(folder.read("stats.json"))["bad_samples"]["count"], 0);
    std::string text = physical_scene;
    text.replace(text.find("[4, 4, 4]"), 9, "[1, 1, 1]\nemission_strength = 1e60");
    folder.write("scene.toml", text);
    const Finished finished = render({"-o", "bad.exr", "--stats", "stats.json", "--rgb"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.err, HasSubstr("infinite or negative; the picture is made without"));
    EXPECT_THAT(finished.err, HasSubstr("of material \""));
    EXPECT_THAT(finished.out, HasSubstr("bad sample"));
    const auto bad = nlohmann::json::parse(folder.read("stats.json"))["bad_samples"];
    EXPECT_GT(bad["count"], 10);
    EXPECT_EQ(bad["first"].size(), 8u);
    EXPECT_FALSE(bad["first"][0]["material"].get<std::string>().empty());
    for (const float value : plane(read_layers(folder.file("bad.exr")), "G")) {
        ASSERT_TRUE(std::isfinite(value));
    }
}

}  // namespace
}  // namespace lancer::test
