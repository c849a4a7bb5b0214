// Every integrator paints the same picture of media; agreement.h says how often this fails by chance.
#include <optional>
#include <string>
#include <vector>

#include "lancer/import/import.h"
#include "statistics/agreement.h"

namespace lancer::statistics {
namespace {

struct MediaCase {
    std::string name;
    std::string scene;
    std::vector<std::string> integrators;
    int spp;
};

const std::string floor_and_lamp = R"(
[material]
floor = { type = "diffuse", color = [0.6, 0.5, 0.4] }
lamp = { type = "diffuse", color = "black", emission = [1, 0.9, 0.8], emission_strength = 12 }
[[box]]
min = [-3, -0.2, -3]
max = [3, 0, 3]
material = "floor"
[[sphere]]
center = [0.5, 1.5, 0]
radius = 0.25
material = "lamp"
)";

const std::string camera = R"(
[camera]
position = [0, 1.2, 4]
look_at = [0, 0.8, 0]
fov = 50
)";

// A lamp and a floor in a box of fog.
const std::string fog_with_lamp = camera + floor_and_lamp + R"(
[medium.fog]
scattering = [0.5, 0.5, 0.5]
absorption = [0.05, 0.05, 0.05]
asymmetry = 0.5
[material.fog]
type = "null"
interior = "fog"
[[box]]
min = [-2.5, -0.1, -2.5]
max = [2.5, 2.5, 2.5]
material = "fog"
)";

// The camera stands in fog as well. Vertices near it are joined to it with 1 / distance^2, whose variance has no bound in a medium where nothing else
// finds them: light alone is right in the mean, but no z-test tells.
const std::string fog_everywhere = camera + floor_and_lamp + R"(
[medium.fog]
everywhere = true
scattering = [0.3, 0.3, 0.3]
absorption = [0.05, 0.05, 0.05]
asymmetry = 0.5
)";

// Each wavelength is scattered differently; a ball of it with a lamp inside, one without, and the sky.
const std::string coloured_fog = camera + floor_and_lamp + R"(
[background]
zenith = [0.4, 0.6, 1]
horizon = [0.6, 0.6, 0.6]
nadir = [0.1, 0.1, 0.1]
[medium.air]
scattering = [0.3, 1.2, 4]
absorption = [0.2, 0.1, 0]
phase = "rayleigh"
[material.air]
type = "null"
interior = "air"
[[sphere]]
center = [0.4, 1.4, 0.1]
radius = 0.8
material = "air"
[[sphere]]
center = [-1.1, 0.9, 0.3]
radius = 0.7
material = "air"
)";

// A layer under a light without size, as light of the lamp and as seen from above.
const std::string slab = R"(
[camera]
position = [0, 3, 1]
look_at = [0, 0, 0]
fov = 40
[medium.milk]
scattering = [2, 3, 4]
absorption = [0.4, 0.2, 0.1]
asymmetry = -0.3
[material]
milk = { type = "null", interior = "milk" }
floor = { type = "diffuse", color = [0.5, 0.5, 0.5] }
[[box]]
min = [-2, 0, -2]
max = [2, 0.5, 2]
material = "milk"
[[box]]
min = [-2, -0.3, -2]
max = [2, -0.1, 2]
material = "floor"
[[light]]
type = "point"
position = [0.5, 1.5, 0]
power = [8, 8, 8]
[[light]]
type = "directional"
direction = [0.3, -1, 0.2]
power = [0.5, 0.5, 1]
)";

// Rough glass, so that paths may be joined through it; a lamp without size outside.
const std::string glass_body = camera + floor_and_lamp + R"(
[medium.ink]
scattering = [2, 1, 0.5]
absorption = [0.1, 0.3, 0.8]
[material.glass]
type = "dielectric"
refraction = 1.4
roughness = 0.4
interior = "ink"
[[sphere]]
center = [-0.6, 0.8, 0.6]
radius = 0.7
material = "glass"
)";

// The camera and a light without size in a ball of fog.
const std::string within = R"(
[camera]
position = [0, 0.2, 1]
look_at = [0, 0, 0]
fov = 70
[medium.fog]
scattering = [0.8, 0.8, 0.8]
asymmetry = 0.7
[material]
fog = { type = "null", interior = "fog" }
floor = { type = "diffuse", color = [0.7, 0.7, 0.7] }
[[sphere]]
center = [0, 0, 0]
radius = 2
material = "fog"
[[box]]
min = [-1, -0.6, -1]
max = [1, -0.5, 1]
material = "floor"
[[light]]
type = "spot"
position = [-0.9, 0.5, -0.3]
look_at = [0.5, -0.2, 0]
angle = 40
falloff = 10
power = [6, 6, 6]
)";

// What differs from place to place has no closed form: its weights leave it out.
const std::string cloud = camera + floor_and_lamp + R"(
[background]
color = [0.3, 0.4, 0.6]
[medium.cloud]
scattering = [3, 3, 4]
absorption = [0.2, 0.1, 0.1]
asymmetry = 0.4
density = { cells = [2, 2, 2], values = [1, 0.2, 0, 0.5, 0.7, 1, 0.1, 0.4], min = [-1.3, 0.2, -0.8], max = [0.8, 1.7, 0.8] }
[material.cloud]
type = "null"
interior = "cloud"
[[box]]
min = [-1.3, 0.2, -0.8]
max = [0.8, 1.7, 0.8]
material = "cloud"
)";

// What shines by itself, and glass above water by priority.
const std::string glowing = camera + floor_and_lamp + R"(
[medium.glow]
scattering = [0.5, 0.5, 0.5]
absorption = [0.5, 1, 2]
emission = [0.6, 0.5, 0.2]
[medium.ink]
scattering = [0.4, 0.6, 0.8]
absorption = [1, 0.5, 0.2]
[material.glow]
type = "null"
interior = "glow"
[material.ball]
type = "dielectric"
refraction = 1.5
roughness = 0.3
priority = 1
[material.ink]
type = "dielectric"
refraction = 1.33
roughness = 0.5
interior = "ink"
[[sphere]]
center = [-1, 1, 0]
radius = 0.6
material = "glow"
[[sphere]]
center = [0.9, 0.7, 0.8]
radius = 0.4
material = "ball"
[[box]]
min = [0.5, 0.02, 0.4]
max = [1.6, 0.7, 1.3]
material = "ink"
)";

class MediaAgreement : public testing::TestWithParam<MediaCase> {};

TEST_P(MediaAgreement, OfAllIntegrators) {
    const MediaCase& c = GetParam();
    for (const bool rgb : {false, true}) {
        Diagnostics diagnostics;
        std::optional<scene::Scene> scene = import_toml(c.scene, "scene.toml", diagnostics);
        ASSERT_TRUE(scene) << (diagnostics.list().empty() ? "" : to_string(diagnostics.list().back()));
        scene->settings.bounces = 6;
        scene->settings.rgb = rgb;
        const Blocks path = rendered_blocks(*scene, "path", c.spp, 100);
        int seed = 200;
        for (const std::string& integrator : c.integrators) {
            expect_agreement(path, rendered_blocks(*scene, integrator, c.spp, seed), integrator + (rgb ? "_rgb" : ""));
            seed += 100;
        }
    }
}

std::string name_of(const testing::TestParamInfo<MediaCase>& one) { return one.param.name; }

INSTANTIATE_TEST_SUITE_P(Statistics, MediaAgreement,
                         testing::Values(MediaCase{"FogWithLamp", fog_with_lamp, {"light", "bdpt"}, 6},
                                         MediaCase{"ColouredFog", coloured_fog, {"light", "bdpt"}, 6},
                                         MediaCase{"CameraWithin", within, {"bdpt"}, 6}),
                         name_of);

INSTANTIATE_TEST_SUITE_P(SlowStatistics, MediaAgreement,
                         testing::Values(MediaCase{"FogWithLamp", fog_with_lamp, {"light", "bdpt", "vcm"}, 32},
                                         MediaCase{"FogEverywhere", fog_everywhere, {"bdpt", "vcm"}, 32},
                                         MediaCase{"ColouredFog", coloured_fog, {"light", "bdpt", "vcm"}, 32},
                                         MediaCase{"Slab", slab, {"light", "bdpt", "vcm"}, 32},
                                         MediaCase{"GlassBody", glass_body, {"light", "bdpt", "vcm"}, 32},
                                         MediaCase{"CameraWithin", within, {"bdpt", "vcm"}, 32},
                                         MediaCase{"Cloud", cloud, {"light", "bdpt", "vcm"}, 32},
                                         MediaCase{"Glowing", glowing, {"bdpt", "vcm"}, 32}),
                         name_of);

}  // namespace
}  // namespace lancer::statistics
