// Sums over samples, and the layers of a picture that are made of them.
#include "lancer/film/film_sums.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "lancer/film/layered_picture.h"
#include "lancer/image/cryptomatte.h"

namespace lancer {
namespace {

std::vector<float> plane(const LayeredImage& image, const std::string& name) {
    const Channel* channel = find_channel(image, name);
    return channel != nullptr ? channel->values : std::vector<float>{};
}

TEST(FilmSums, VarianceOfIndependentSamplesIsUnbiased) {
    constexpr std::size_t pixels = 4000, samples = 8;
    FilmSums sums(static_cast<int>(pixels), 1, {.variance = true});
    std::mt19937 generator(7);
    std::exponential_distribution<float> light(0.5f);  // mean 2, variance 4
    double stated = 0.0;
    for (std::size_t i = 0; i < pixels; ++i) {
        std::vector<glm::vec3> radiance(samples);
        for (glm::vec3& c : radiance) {
            c = glm::vec3(light(generator));
        }
        sums.add(i, {std::span(radiance).first(3), {}, {}, {}});
        sums.add(i, {std::span(radiance).subspan(3), {}, {}, {}});
        stated += static_cast<double>(sums.variance(i).y) / static_cast<double>(pixels);
    }
    // The spread of one estimate: the fourth moment of an exponential is 9 variances squared.
    const double one = 4.0 / static_cast<double>(samples) * std::sqrt((9.0 - 5.0 / 7.0) / static_cast<double>(samples));
    EXPECT_NEAR(stated, 4.0 / static_cast<double>(samples), 4.0 * one / std::sqrt(static_cast<double>(pixels)));
}

TEST(FilmSums, OfOneSampleTheVarianceIsUnknown) {
    FilmSums sums(1, 1, {.variance = true});
    EXPECT_EQ(sums.mean(0), glm::vec3(0.0f));
    std::vector<glm::vec3> one(1, glm::vec3(3.0f));
    sums.add(0, {one, {}, {}, {}});
    EXPECT_EQ(sums.mean(0), glm::vec3(3.0f));
    EXPECT_TRUE(std::isinf(sums.variance(0).x));
    sums.add(0, {one, {}, {}, {}});
    EXPECT_EQ(sums.variance(0), glm::vec3(0.0f));
}

TEST(FilmSums, LeaveOutWhatIsNoNumber) {
    FilmSums sums(1, 1, {.variance = true, .direct = true, .surface = true, .ids = true});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<glm::vec3> radiance = {glm::vec3(1.0f), glm::vec3(nan), glm::vec3(3.0f)}, direct(3, glm::vec3(0.5f));
    std::vector<FirstHit> hits(3);
    for (FirstHit& hit : hits) {
        hit.object = hit.material = 0;
        hit.weight = 1.0f;
        hit.depth = 2.0f;
    }
    hits[1].depth = nan;
    sums.add(0, {radiance, direct, hits, {}});
    EXPECT_EQ(sums.count(0), 2u);
    EXPECT_EQ(sums.mean(0), glm::vec3(2.0f));
    EXPECT_EQ(sums.direct(0), glm::vec3(0.5f));
    EXPECT_EQ(sums.surface(0).depth, 4.0);
    EXPECT_EQ(sums.objects(0).at(0).second, 2u);
    EXPECT_EQ(sums.variance(0), glm::vec3(1.0f));
}

// Three samples of one pixel: two on a thing, one on another of the same name; a second pixel sees nothing.
TEST(LayeredPicture, HoldsWhatWasAsked) {
    PictureContents contents;
    for (const AovKind& kind : aov_kinds()) {
        contents.aovs.push_back(kind.aov);
    }
    contents.spectral_bins = 2;
    FilmSums sums(2, 1, layers_for(contents));
    std::vector<glm::vec3> radiance = {glm::vec3(1.0f), glm::vec3(2.0f), glm::vec3(6.0f), glm::vec3(4.0f)}, direct = radiance;
    direct[2] = glm::vec3(0.0f);
    std::vector<FirstHit> hits(4);
    for (FirstHit& hit : hits) {
        hit.weight = 1.0f;
    }
    const int objects[] = {0, 1, 2};
    for (std::size_t i = 0; i < 3; ++i) {
        hits[i] = {glm::vec3(0.5f),
                   glm::vec3(0.0f, 0.0f, 1.0f),
                   glm::vec3(1.0f, 2.0f, 3.0f),
                   static_cast<float>(i),
                   glm::vec2(0.25f, 0.75f),
                   1.0f,
                   objects[i],
                   0};
    }
    hits[3].object = -1;
    std::vector<SpectralSample> spectra(4, {glm::vec4(1.0f), glm::vec4(400.0f, 500.0f, 600.0f, 700.0f)});
    const PathSamples all{radiance, direct, hits, spectra};
    sums.add(0, all);
    sums.add(1, all.part(3, 1));
    Film film(2, 1);
    film.radiance = {sums.mean(0), sums.mean(1)};
    const LayeredImage image = layered_picture(film, sums, contents, {{"a", "b", "a"}, {"paint"}}, {{"key", "value"}});

    EXPECT_EQ(plane(image, "R"), (std::vector<float>{3.25f, 4.0f}));
    EXPECT_EQ(plane(image, "direct.G")[0] + plane(image, "indirect.G")[0], 3.25f);
    EXPECT_EQ(plane(image, "indirect.G")[0], 1.5f);
    EXPECT_EQ(plane(image, "samples"), (std::vector<float>{4.0f, 1.0f}));
    EXPECT_TRUE(std::isinf(plane(image, "interval.high")[0])) << "four samples tell nothing of their spread";
    EXPECT_EQ(plane(image, "albedo.R"), (std::vector<float>{0.375f, 0.0f}));
    EXPECT_EQ(plane(image, "normal.Z"), (std::vector<float>{0.75f, 0.0f}));
    EXPECT_EQ(plane(image, "depth.Z")[0], 1.0f);
    EXPECT_TRUE(std::isinf(plane(image, "depth.Z")[1]));
    EXPECT_EQ(plane(image, "position.Y"), (std::vector<float>{2.0f, 0.0f}));
    EXPECT_EQ(plane(image, "uv.V"), (std::vector<float>{0.75f, 0.0f}));
    EXPECT_TRUE(std::isinf(plane(image, "variance.B")[1]));
    // Two objects of one name cover half of the pixel together, a quarter sees nothing.
    EXPECT_EQ(plane(image, "CryptoObject00.R")[0], cryptomatte_id("a"));
    EXPECT_EQ(plane(image, "CryptoObject00.G")[0], 0.5f);
    EXPECT_EQ(plane(image, "CryptoObject00.B")[0], cryptomatte_id("b"));
    EXPECT_EQ(plane(image, "CryptoObject00.A")[0], 0.25f);
    EXPECT_EQ(plane(image, "CryptoMaterial00.G"), (std::vector<float>{0.75f, 0.0f}));
    EXPECT_EQ(plane(image, "S0.477,500000nm")[0], 2.0f / 235.0f);
    EXPECT_EQ(plane(image, "S0.712,500000nm")[1], 2.0f / 235.0f);
    EXPECT_EQ(image.metadata.at("key"), "value");
    EXPECT_EQ(image.metadata.at("spectralLayoutVersion"), "1.0");
    int manifests = 0;
    for (const auto& [key, value] : image.metadata) {
        manifests += key.ends_with("/manifest") ? 1 : 0;
    }
    EXPECT_EQ(manifests, 2);
    for (const char* name : {"depth.Z", "position.X", "CryptoObject02.A", "variance.R", "samples", "S0.477,500000nm"}) {
        ASSERT_NE(find_channel(image, name), nullptr) << name;
        EXPECT_EQ(find_channel(image, name)->stored, Stored::float32) << name;
    }
    EXPECT_EQ(find_channel(image, "R")->stored, Stored::half);
    contents.wide = true;
    EXPECT_EQ(find_channel(layered_picture(film, sums, contents, {{"a", "b", "a"}, {"paint"}}, {}), "albedo.R")->stored, Stored::float32);
}

}  // namespace
}  // namespace lancer
