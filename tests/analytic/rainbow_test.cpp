// Newton's experiment: where the colours fall that the prism of the gallery throws on its wall.
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <glm/vec2.hpp>

#include "lancer/device/cpu/cpu.h"
#include "lancer/import/import.h"
#include "lancer/world/compile.h"

namespace lancer::tests {
namespace {

// Seen from above: x to the right, z towards the camera; metres.
constexpr double beam_z = 0.035;
constexpr double wall_z = -0.8;

// Of SF11, from the catalogue of the glass maker.
double index_of_sf11(double nanometres) {
    const double l2 = nanometres * nanometres * 1e-6;
    return std::sqrt(1.0 + 1.73848403 * l2 / (l2 - 0.0136068604) + 0.311168974 * l2 / (l2 - 0.0615960463) +
                     1.17490871 * l2 / (l2 - 121.922711));
}

glm::dvec2 turned(double x, double z) {
    const double a = 33.0 * std::numbers::pi / 180.0;
    return {x * std::cos(a) + z * std::sin(a), -x * std::sin(a) + z * std::cos(a)};
}

double dot(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.x + a.y * b.y; }

// Onto the line through two corners, and through it by Snell's law; `eta`: index behind over index before.
void refract(const glm::dvec2& from, const glm::dvec2& to, double eta, glm::dvec2& place, glm::dvec2& direction) {
    const glm::dvec2 along = to - from;
    glm::dvec2 normal(-along.y, along.x);
    normal /= std::sqrt(dot(normal, normal));
    if (dot(normal, direction) > 0.0) {
        normal = -normal;
    }
    place += direction * (dot(from - place, normal) / dot(direction, normal));
    const double cosine = -dot(direction, normal);
    const double cos_t = std::sqrt(1.0 - (1.0 - cosine * cosine) / (eta * eta));
    direction = direction / eta + normal * (cosine / eta - cos_t);
}

double place_on_wall(double nanometres) {
    const double n = index_of_sf11(nanometres);
    const glm::dvec2 apex = turned(0.0, 0.0692820), left = turned(-0.06, -0.0346410), right = turned(0.06, -0.0346410);
    glm::dvec2 place(-1.6, beam_z), direction(1.0, 0.0);
    refract(apex, left, n, place, direction);
    refract(apex, right, 1.0 / n, place, direction);
    return place.x + direction.x * (wall_z - place.y) / direction.y;
}

// Where the light of a line falls in the picture: the middle of all of it.
std::optional<double> place_in_picture(double nanometres, const std::string& integrator) {
    Diagnostics diagnostics;
    std::optional<scene::Scene> scene = import_scene(LANCER_SOURCE_FOLDER "/scenes/gallery/prism.toml", diagnostics);
    if (!scene || scene->lights.size() != 1) {
        return std::nullopt;
    }
    scene->background = {};
    for (scene::Material& material : scene->materials) {
        material.emission.reset();
        material.interior.reset();
    }
    scene::SpotLight beam;
    beam.position = {-1.6, 0.03, beam_z};
    beam.direction = {1.0, 0.0, 0.0};
    beam.angle = 0.1;
    beam.falloff = 0.02;
    scene->lights[0].model = beam;
    scene::Spectrum line{scene::MeasuredSpectrum{{nanometres - 1.0, nanometres, nanometres + 1.0}, {0.0, 1.0, 0.0}}, 1.0, std::nullopt};
    scene->lights[0].power = scene::Color(line);
    scene::RenderSettings& settings = scene->settings;
    settings.integrator = integrator;
    settings.bounces = 3;  // in, out, and off the wall
    settings.width = 512;
    settings.height = 16;
    settings.filter = scene::PixelFilter::box;
    scene::Camera& camera = scene->cameras[0];
    camera.projection = scene::Projection::orthographic;
    camera.position = {0.35, 0.03, -0.5};
    camera.direction = {0.0, 0.0, -1.0};
    camera.extent = 0.64;
    const auto world = compile_world(*scene, camera, diagnostics);
    if (!world) {
        ADD_FAILURE() << to_string(diagnostics.list().back());
        return std::nullopt;
    }
    const PathRange range{0, 0, settings.width, settings.height, 0, 4};
    std::vector<glm::vec3> radiance(range.paths());
    std::vector<Splat> splats;
    RayCounts counts;
    make_cpu_device(world)->trace_paths(range, {radiance, {}, {}, {}, &splats}, counts);
    double sum = 0.0, moment = 0.0;
    for (const Splat& s : splats) {
        // Whatever colour it has, all of it has the same.
        const double light = std::abs(double(s.light.r)) + std::abs(double(s.light.g)) + std::abs(double(s.light.b));
        sum += light;
        moment += light * (static_cast<double>(s.pixel % 512) + 0.5);
    }
    if (sum == 0.0) {
        ADD_FAILURE() << "no light on the wall";
        return std::nullopt;
    }
    return 0.35 - 0.32 + 0.64 * moment / sum / 512.0;
}

TEST(Rainbow, FallsWhereSnellsLawPutsIt) {
    double before = -1.0;
    for (const double line : {435.8343, 486.1327, 587.5618, 656.2725}) {  // g, F, d, C
        const double truth = place_on_wall(line);
        for (const char* integrator : {"light", "bdpt"}) {
            const std::optional<double> found = place_in_picture(line, integrator);
            ASSERT_TRUE(found);
            EXPECT_NEAR(*found, truth, 0.001 * truth) << line << " nm, " << integrator;
        }
        EXPECT_GT(truth, before + 0.01);  // each well apart from the last one
        before = truth;
    }
}

}  // namespace
}  // namespace lancer::tests
