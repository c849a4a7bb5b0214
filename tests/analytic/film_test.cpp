// What the path integrator tells beside a pixel's light: first hits, direct light, spectra, variance, and samples that are wrong.
#include "lancer/film/film_sums.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "analytic/small_world.h"
#include "lancer/device/cpu/cpu.h"
#include "lancer/kernel/spectrum.h"
#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/sensor.h"

namespace lancer::tests {
namespace {

scene::Material diffuse(const scene::Rgb& color, double emission = 0.0) {
    scene::Material material;
    material.model = scene::DiffuseMaterial{color, 0.0};
    if (emission > 0.0) {
        material.emission = scene::Emission{scene::Rgb(1.0), emission, true};
    }
    return material;
}

// A world of a few pixels for the path integrator.
class PathWorld : public SmallWorld {
public:
    PathWorld(int size, int bounces, bool rgb) {
        scene.settings.integrator = "path";
        scene.settings.bounces = bounces;
        scene.settings.rgb = rgb;
        scene.settings.filter = scene::PixelFilter::box;
        scene.settings.width = scene.settings.height = size;
    }
    int material(const scene::Material& m) {
        scene.materials.push_back(m);
        return static_cast<int>(scene.materials.size()) - 1;
    }
};

struct Samples {
    std::vector<glm::vec3> radiance, direct;
    std::vector<FirstHit> hits;
    std::vector<SpectralSample> spectra;

    PathSamples all() { return {radiance, direct, hits, spectra}; }
};

Samples trace(const std::shared_ptr<const World>& world, int size, int spp, const CpuOptions& options = {}) {
    const PathRange range{0, 0, size, size, 0, spp};
    Samples samples;
    samples.radiance.resize(range.paths());
    samples.direct.resize(range.paths());
    samples.hits.resize(range.paths());
    samples.spectra.resize(range.paths());
    RayCounts counts;
    make_cpu_device(world, options)->trace_paths(range, samples.all(), counts);
    return samples;
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

PathWorld busy(int bounces, bool rgb) {
    PathWorld world(24, bounces, rgb);
    scene::Material glass;
    glass.model = scene::DielectricMaterial{.refraction = scene::NamedGlass{"SF11"}, .roughness = 0.2};
    scene::Material gold;
    gold.model = scene::ConductorMaterial{.metal = "gold"};
    world.add(scene::Sphere{{-0.8, 0.0, 0.0}, 0.8}, world.material(glass));
    world.add(scene::Sphere{{0.9, 0.0, 0.0}, 0.8}, world.material(gold));
    world.add(scene::Plane{{0.0, -0.8, 0.0}, {0.0, 1.0, 0.0}}, world.material(diffuse({0.7, 0.5, 0.2})));
    world.add(scene::Sphere{{0.0, 3.0, 1.0}, 0.5}, world.material(diffuse(scene::Rgb(0.0), 10.0)));
    world.set_background(0.3, 0.2, 0.1);
    return world;
}

TEST(PathSamples, SameBytesForAnyLanesAndWhateverElseIsAsked) {
    const auto world = busy(6, false).compile();
    const Samples first = trace(world, 24, 6, {.lanes = 4});
    for (const int lanes : {8, 16}) {
        if (lanes > make_cpu_device(world)->lanes()) {
            continue;
        }
        const Samples other = trace(world, 24, 6, {.lanes = lanes});
        EXPECT_TRUE(same_bytes(first.radiance, other.radiance)) << lanes;
        EXPECT_TRUE(same_bytes(first.direct, other.direct)) << lanes;
        EXPECT_TRUE(same_bytes(first.hits, other.hits)) << lanes;
        EXPECT_TRUE(same_bytes(first.spectra, other.spectra)) << lanes;
    }
    std::vector<glm::vec3> alone(first.radiance.size());
    RayCounts counts;
    make_cpu_device(world)->follow_paths({0, 0, 24, 24, 0, 6}, alone, counts);
    EXPECT_TRUE(same_bytes(first.radiance, alone));
}

TEST(PathSamples, DirectLightIsWhatPathsOfTwoVerticesBring) {
    for (const bool rgb : {true, false}) {
        const Samples deep = trace(busy(8, rgb).compile(), 24, 8);
        const Samples flat = trace(busy(1, rgb).compile(), 24, 8);
        EXPECT_TRUE(same_bytes(deep.direct, flat.radiance)) << rgb;
        EXPECT_FALSE(same_bytes(deep.direct, deep.radiance)) << rgb;
    }
}

TEST(PathSamples, FirstHitsAreWhereGeometrySays) {
    PathWorld world(40, 2, false);
    const int red = world.material(diffuse({0.6, 0.1, 0.05})), grey = world.material(diffuse(scene::Rgb(0.25)));
    world.add(scene::Sphere{{0.0, 0.0, 0.0}, 1.0}, red);
    world.add(scene::Box{{-9.0, -9.0, -4.0}, {0.0, 9.0, -3.0}}, grey);
    world.set_background(1.0, 1.0, 1.0);
    const auto compiled = world.compile();
    const Samples samples = trace(compiled, 40, 16);
    int on_ball = 0, on_box = 0, nowhere = 0;
    for (const FirstHit& hit : samples.hits) {
        EXPECT_EQ(hit.weight, 1.0f);
        if (hit.object < 0) {
            ++nowhere;
            EXPECT_EQ(hit.albedo, glm::vec3(0.0f));
            continue;
        }
        EXPECT_NEAR(hit.depth, 5.0f - hit.position.z, 1e-5f);
        EXPECT_GT(glm::dot(hit.normal, glm::vec3(0.0f, 0.0f, 5.0f) - hit.position), 0.0f);
        const bool ball = compiled->object_name(hit.object) == "sphere 1";
        const glm::vec3 albedo = ball ? glm::vec3(0.6f, 0.1f, 0.05f) : glm::vec3(0.25f);
        EXPECT_LT(glm::length(hit.albedo - albedo), 1e-6f);
        EXPECT_EQ(hit.material, ball ? red : grey);
        EXPECT_STREQ(compiled->object_kind(hit.object), ball ? "sphere" : "box");
        if (ball) {
            ++on_ball;
            EXPECT_LT(glm::length(hit.normal - hit.position), 2e-5f);
        } else {
            ++on_box;
            EXPECT_NEAR(hit.position.z, -3.0f, 1e-5f);
            EXPECT_EQ(hit.normal, glm::vec3(0.0f, 0.0f, 1.0f));
        }
    }
    EXPECT_GT(on_ball, 300);
    EXPECT_GT(on_box, 300);
    EXPECT_GT(nowhere, 300);
}

TEST(PathSamples, MetalsShowTheirColor) {
    PathWorld world(8, 2, false);
    scene::Material gold;
    gold.model = scene::ConductorMaterial{.metal = "gold"};
    world.add(scene::Disk{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 50.0}, world.material(gold));
    world.scene.cameras[0].fov = 1.0;
    world.set_background(1.0, 1.0, 1.0);
    const Samples samples = trace(world.compile(), 8, 4);
    EXPECT_GT(samples.hits[0].albedo.x, 0.9f);
    EXPECT_LT(samples.hits[0].albedo.z, 0.6f);
}

// ---- Spectra ----------------------------------------------------------------------------------------------------------------------

// All samples together as the sums of one pixel.
FilmSums spectrum_of(Samples& samples, int bins) {
    FilmSums sums(1, 1, {.spectral_bins = bins});
    sums.add(0, {samples.radiance, {}, {}, samples.spectra});
    return sums;
}

// Four standard errors of a bin's value, as a share of it: by how many of the paths' wavelengths fall into it.
double error_of_bin(const World& world, int bin, int bins, std::size_t paths) {
    double share = 0.0;
    for (int i = 0; i < kernel::WAVELENGTH_COUNT; ++i) {
        const bool inside = i * bins / (kernel::WAVELENGTH_COUNT - 1) == bin;
        share += inside ? static_cast<double>(world.wavelength_densities[static_cast<std::size_t>(i)]) : 0.0;
    }
    return 4.0 / std::sqrt(share * 4.0 * static_cast<double>(paths));
}

TEST(SpectralBins, AreEqualInAFurnaceOfEqualEnergy) {
    PathWorld world(4, 200, false);
    world.add(scene::Sphere{{0.0, 0.0, 5.0}, 2.0}, world.material(diffuse(scene::Rgb(0.5), 1.0)));
    auto compiled = std::const_pointer_cast<World>(world.compile());
    kernel::ColorRecord& light = compiled->surfaces.back().emission;
    light.coefficients = kernel::vec3(0.0f);  // a half
    light.scale = 2.0f;
    light.curve = light.illuminant = light.texture = -1;
    Samples samples = trace(compiled, 4, 16384);
    const FilmSums sums = spectrum_of(samples, 16);
    for (int bin = 0; bin < 16; ++bin) {
        EXPECT_NEAR(static_cast<double>(sums.spectral(0, bin)), 2.0, 2.0 * error_of_bin(*compiled, bin, 16, samples.spectra.size())) << bin;
    }
}

TEST(SpectralBins, HoldTheCurveOfD65AndGiveTheRgbPicture) {
    PathWorld world(4, 1, false);
    world.set_background(1.0, 1.0, 1.0);
    const auto compiled = world.compile();
    Samples samples = trace(compiled, 4, 16384);
    constexpr int bins = 47;  // ten nanometres each
    const FilmSums sums = spectrum_of(samples, bins);
    glm::dvec3 rgb(0.0);
    for (int bin = 0; bin < bins; ++bin) {
        double mean = 0.0;
        for (int i = 0; i < 100; ++i) {
            const double nanometres = 360.0 + 10.0 * bin + 0.1 * (i + 0.5);
            mean += unit_d65().at(nanometres) / 100.0;
        }
        const double value = static_cast<double>(sums.spectral(0, bin));
        EXPECT_NEAR(value, mean, mean * error_of_bin(*compiled, bin, bins, samples.spectra.size())) << bin;
        for (int i = 0; i < 10; ++i) {
            rgb += value * sensor_weight(360.0 + 10.0 * bin + i + 0.5);
        }
    }
    const glm::vec3 picture = sums.mean(0);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(rgb[c], static_cast<double>(picture[c]), 0.01) << c;
        EXPECT_NEAR(picture[c], 1.0f, 0.005f) << c;
    }
}

// ---- Variance ---------------------------------------------------------------------------------------------------------------------

// Over many seeds the means vary no more than each picture says of itself.
TEST(Variance, IsNoLessThanWhatSeedsShow) {
    constexpr int seeds = 200, spp = 16;
    glm::dvec3 sum(0.0), squares(0.0), stated(0.0);
    for (int seed = 0; seed < seeds; ++seed) {
        PathWorld world(1, 1, true);
        world.scene.settings.seed = seed;
        world.add(scene::Disk{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.01}, world.material(diffuse(scene::Rgb(1.0))));
        world.add(scene::Sphere{{0.0, 2.0, 0.0}, 1.0}, world.material(diffuse(scene::Rgb(0.0), 1.0)));
        world.look({0.0, 0.5, 5.0}, {0.0, -0.1, -1.0});
        world.scene.cameras[0].fov = 0.001;
        Samples samples = trace(world.compile(), 1, spp);
        FilmSums sums(1, 1, {.variance = true});
        sums.add(0, {samples.radiance, {}, {}, {}});
        const glm::dvec3 mean(sums.mean(0));
        sum += mean;
        squares += mean * mean;
        stated += glm::dvec3(sums.variance(0)) / static_cast<double>(seeds);
    }
    const double spread = (squares.x - sum.x * sum.x / seeds) / (seeds - 1);
    EXPECT_GT(spread, 0.0);
    EXPECT_GT(stated.x, spread * (1.0 - 4.0 * std::sqrt(2.0 / seeds)));
}

// ---- Samples that are wrong ---------------------------------------------------------------------------------------------------------

TEST(Faults, AreMarkedAndFoundWhereTheyArise) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    struct Case {
        kernel::vec3 light;
        PathFault::What what;
    };
    for (const Case& wrong :
         {Case{kernel::vec3(nan), PathFault::What::not_a_number}, Case{kernel::vec3(1.0f, nan, 1.0f), PathFault::What::not_a_number},
          Case{kernel::vec3(infinite), PathFault::What::infinite}, Case{kernel::vec3(1.0f, -1.0f, 1.0f), PathFault::What::negative}}) {
        PathWorld world(16, 4, true);
        world.add(scene::Plane{{0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}}, world.material(diffuse(scene::Rgb(0.5))));
        scene::Material lamp = diffuse(scene::Rgb(0.0), 1.0);
        lamp.name = "broken";
        world.add(scene::Sphere{{0.0, 0.5, 0.0}, 0.5}, world.material(lamp));
        world.scene.objects.back().name = "the lamp";
        auto compiled = std::const_pointer_cast<World>(world.compile());
        compiled->emitters.clear();  // found by chance only, so that the vertex is that of the lamp
        for (kernel::ObjectRecord& object : compiled->objects) {
            object.emitter = -1;
        }
        compiled->surfaces[static_cast<std::size_t>(world.scene.objects.back().material)].emission.rgb = wrong.light;
        Samples samples = trace(compiled, 16, 16);
        const auto device = make_cpu_device(compiled);
        int bad = 0, later = 0;
        for (std::size_t i = 0; i < samples.radiance.size(); ++i) {
            const glm::vec3& c = samples.radiance[i];
            if (!std::isnan(c.x)) {
                EXPECT_TRUE(std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z) && c.x >= 0.0f && c.y >= 0.0f);
                continue;
            }
            ++bad;
            const int pixel = static_cast<int>(i / 16);
            const PathFault fault = device->find_fault(pixel % 16, pixel / 16, static_cast<int>(i % 16));
            EXPECT_EQ(fault.what, wrong.what);
            EXPECT_EQ(compiled->object_name(fault.object), "the lamp");
            EXPECT_EQ(compiled->material_name(fault.material), "broken");
            EXPECT_EQ(fault.vertex == 0, samples.hits[i].object == fault.object);
            later += fault.vertex > 0 ? 1 : 0;
        }
        EXPECT_GT(bad, 20);
        EXPECT_GT(later, 0);
        EXPECT_LT(bad, 16 * 16 * 16 / 2);
        FilmSums sums(16, 16, {});
        std::uint32_t counted = 0;
        for (std::size_t pixel = 0; pixel < 256; ++pixel) {
            sums.add(pixel, samples.all().part(16 * pixel, 16));
            counted += sums.count(pixel);
            EXPECT_TRUE(std::isfinite(sums.mean(pixel).y));
        }
        EXPECT_EQ(counted, samples.radiance.size() - static_cast<std::size_t>(bad));
    }
}

TEST(Faults, AHealthySceneHasNone) {
    for (const bool rgb : {true, false}) {
        for (const glm::vec3& c : trace(busy(16, rgb).compile(), 24, 64).radiance) {
            ASSERT_FALSE(std::isnan(c.x));
        }
    }
}

}  // namespace
}  // namespace lancer::tests
