// The tree by which one of many emitters is chosen: it chooses with the chance that it states, and none is left out that sends light.
#include "lancer/kernel/emitter/emitter.h"

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "lancer/world/compile.h"
#include "statistics/chi_squared.h"

namespace lancer::statistics {
namespace {

using namespace kernel;

class Dice {
public:
    explicit Dice(unsigned seed) : numbers_(seed) {}
    double number(double low = 0.0, double high = 1.0) { return low + (high - low) * uniform_(numbers_); }
    glm::dvec3 point(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
    glm::dvec3 direction() {
        for (;;) {
            const glm::dvec3 p = point(1.0);
            const double length = glm::length(p);
            if (length > 0.1 && length < 1.0) {
                return p / length;
            }
        }
    }

private:
    std::mt19937 numbers_;
    std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

void add_light(scene::Scene& scene, decltype(scene::Light::model) model, double power) {
    scene::Light light;
    light.model = std::move(model);
    light.power = scene::Rgb(power);
    scene.lights.push_back(light);
}

// Lights of every near kind, and lamps of every shape, in a cube of 20 m; `far`: and a sky and two suns.
std::shared_ptr<const World> world_of_lights(unsigned seed, int count, bool far) {
    Dice dice(seed);
    scene::Scene scene;
    scene.settings.integrator = "path";
    scene.settings.rgb = true;
    scene.cameras.push_back({});
    for (const bool both_sides : {false, true}) {
        scene::Material material;
        material.model = scene::DiffuseMaterial{};
        material.emission = scene::Emission{scene::Rgb(1.0), 2.0, both_sides};
        scene.materials.push_back(material);
    }
    const auto photometry =
        std::make_shared<const scene::Photometry>(scene::Photometry{{0.0, 20.0, 40.0, 60.0}, {0.0}, {5.0, 3.0, 0.0, 0.0}});
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 p = dice.point(10.0);
        const double power = std::pow(10.0, dice.number(-1.0, 1.0));
        scene::Object object;
        object.material = i % 2;
        const double size = dice.number(0.01, 0.5);
        switch (i % 8) {
            case 0:
                add_light(scene, scene::PointLight{p}, power);
                continue;
            case 1:
                add_light(scene, scene::SpotLight{p, dice.direction(), dice.number(5.0, 120.0), 3.0}, power);
                continue;
            case 2:
                add_light(scene, scene::IesLight{p, dice.direction(), {0.3, 0.2, 0.9}, photometry}, power);
                continue;
            case 3:
                object.shape = scene::Sphere{p, size};
                break;
            case 4:
            case 5:
                object.shape = scene::Disk{p, dice.direction(), size};
                object.material = i % 8 - 4;
                break;
            case 6:
                object.shape = scene::Box{p - size, p + size};
                break;
            default: {
                auto mesh = std::make_shared<scene::TriangleMesh>();
                const int corners = dice.number() < 0.5 ? 3 : 60;  // one triangle, or many
                for (int j = 0; j < corners; ++j) {
                    mesh->positions.push_back(glm::vec3(p + dice.point(size)));
                }
                for (unsigned j = 0; j + 2 < static_cast<unsigned>(corners); j += 3) {
                    mesh->triangles.push_back({j, j + 1, j + 2});
                }
                object.shape = scene::Mesh{mesh, false};
                break;
            }
        }
        scene.objects.push_back(object);
    }
    if (far) {
        add_light(scene, scene::DirectionalLight{{0.3, -1.0, 0.2}}, 0.4);
        add_light(scene, scene::DirectionalLight{{-0.8, 0.1, 0.2}}, 0.2);
        scene.background.zenith = scene::Rgb(0.4);  // a more even sky would be left to materials
        scene.background.horizon = scene::Rgb(0.005);
        scene.background.nadir = scene::Rgb(0.005);
    }
    Diagnostics diagnostics;
    auto world = compile_world(scene, scene.cameras.front(), diagnostics);
    EXPECT_TRUE(world);
    EXPECT_EQ(world->record().has_tree, 1);
    EXPECT_EQ(world->far_count, far ? 3 : 0);
    return world;
}

Vec3 to_kernel(const glm::dvec3& v) { return vec3_of(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)); }

// Places to look from: anywhere, among the lights and outside; of every third one, any direction counts.
struct Place {
    Vec3 from;
    Vec3 facing;
};

Place place(Dice& dice, int i) {
    return {to_kernel(dice.point(i % 5 == 0 ? 60.0 : 11.0)), i % 3 == 0 ? vec3_all(0.0f) : to_kernel(dice.direction())};
}

TEST(LightTree, ChoosesWithTheChanceThatItStates) {
    Dice dice(1);
    for (const bool far : {false, true}) {
        const auto world = world_of_lights(7, 200, far);
        ASSERT_TRUE(world);
        const WorldRecord record = world->record();
        const auto count = static_cast<std::size_t>(record.emitter_count);
        for (int i = 0; i < 12; ++i) {
            const Place at = place(dice, i);
            std::vector<double> counts(count + 1), expected(count + 1);
            double sum = 0.0;
            constexpr int draws = 40000;
            for (std::size_t e = 0; e < count; ++e) {
                const double chance = double(emitter_chance(record, at.from, at.facing, static_cast<int>(e), true));
                sum += chance;
                expected[e] = chance * draws;
            }
            EXPECT_LE(sum, 1.0 + 1e-4);
            expected[count] = std::max(1.0 - sum, 0.0) * draws;
            for (int j = 0; j < draws; ++j) {
                const auto u = std::min(static_cast<float>(dice.number()), 0.99999994f);
                const EmitterChoice choice = choose_emitter(record, at.from, at.facing, u, true);
                if (choice.emitter < 0) {
                    counts[count] += 1.0;
                    continue;
                }
                counts[static_cast<std::size_t>(choice.emitter)] += 1.0;
                ASSERT_EQ(choice.chance, emitter_chance(record, at.from, at.facing, choice.emitter, true));
            }
            if (!(expected[count] > 0.5)) {  // rounding of the sum
                ASSERT_EQ(counts[count], 0.0);
                expected[count] = 0.0;
            }
            const Verdict verdict = compare_counts(counts, expected);
            EXPECT_TRUE(verdict.right()) << verdict.words();
        }
    }
}

// The luminous part of what one point of an emitter sends to a place, at right angles and in front of what it faces.
double sent(const WorldRecord& record, int emitter, const Place& at, const Vec2& u) {
    const EmitterRecord& e = record.emitters[emitter];
    const EmitterSample s = emitter_sample(record, e, at.from, u, true);
    if (!s.valid || (dot(at.facing, at.facing) > 0.5f && dot(at.facing, s.direction) <= 1e-5f)) {
        return 0.0;
    }
    const double cosine = dot(at.facing, at.facing) > 0.5f ? double(dot(at.facing, s.direction)) : 1.0;
    return double(emitted_light(record, e, s, vec4_all(550.0f), true).y) * cosine / double(s.density);
}

TEST(LightTree, LeavesNoLightOut) {
    Dice dice(2);
    for (const bool far : {false, true}) {
        for (const int lights : {40, 400}) {
            const auto world = world_of_lights(static_cast<unsigned>(lights), lights, far);
            ASSERT_TRUE(world);
            const WorldRecord record = world->record();
            int lit = 0;
            for (int i = 0; i < 300; ++i) {
                const Place at = place(dice, i);
                for (int e = 0; e < record.emitter_count; ++e) {
                    if (emitter_chance(record, at.from, at.facing, e, true) > 0.0f) {
                        continue;
                    }
                    for (int j = 0; j < 6; ++j) {
                        const Vec2 u = vec2_of(static_cast<float>(dice.number()), static_cast<float>(dice.number()) * 0.999f);
                        const double light = sent(record, e, at, u);
                        lit += light > 0.0 ? 1 : 0;
                        EXPECT_EQ(light, 0.0) << "emitter " << e << " of kind " << record.emitters[e].kind << ", place " << i;
                    }
                }
            }
            EXPECT_EQ(lit, 0);
        }
    }
}

// What is asked for through the tree is, in the mean, what all emitters send. A two-sided z-test; one false alarm in 10^6 for all of it.
TEST(LightTree, FindsTheLightOfAllEmitters) {
    Dice dice(3);
    for (const bool far : {false, true}) {
        const auto world = world_of_lights(11, 300, far);
        ASSERT_TRUE(world);
        const WorldRecord record = world->record();
        for (int i = 0; i < 8; ++i) {
            const Place at = place(dice, i);
            const auto any = [&] { return vec2_of(static_cast<float>(dice.number()), static_cast<float>(dice.number()) * 0.9999f); };
            double all = 0.0, all_variance = 0.0;
            for (int e = 0; e < record.emitter_count; ++e) {
                double mean = 0.0, squares = 0.0;
                const int draws = e < record.far_count ? 20000 : 400;  // of a sky with a bright spot, more
                for (int j = 0; j < draws; ++j) {
                    const double light = sent(record, e, at, any());
                    mean += light / draws;
                    squares += light * light / draws;
                }
                all += mean;
                all_variance += std::max(squares - mean * mean, 0.0) / draws;
            }
            double mean = 0.0, squares = 0.0;
            constexpr int draws = 40000;
            for (int j = 0; j < draws; ++j) {
                const auto u = std::min(static_cast<float>(dice.number()), 0.99999994f);
                const EmitterChoice choice = choose_emitter(record, at.from, at.facing, u, true);
                const double light = choice.emitter < 0 ? 0.0 : sent(record, choice.emitter, at, any()) / double(choice.chance);
                mean += light / draws;
                squares += light * light / draws;
            }
            const double error = std::sqrt(std::max(squares - mean * mean, 0.0) / draws + all_variance);
            EXPECT_NEAR(mean, all, 5.6 * error) << i;
            // And it is worth the way: relative to even chances the variance is far smaller.
            EXPECT_LT(error, 0.05 * all + 1e-12);
        }
    }
}

// A lamp that gives most of the light at a place is asked far more often than one of 1000 would be by chance.
TEST(LightTree, PrefersTheNearLamp) {
    scene::Scene scene;
    scene.settings.integrator = "path";
    scene.settings.rgb = true;
    scene.cameras.push_back({});
    for (int i = 0; i < 1000; ++i) {
        add_light(scene, scene::PointLight{{10.0 * (i % 32), 0.0, 10.0 * (i / 32)}}, 1.0);
    }
    Diagnostics diagnostics;
    const auto world = compile_world(scene, scene.cameras.front(), diagnostics);
    ASSERT_TRUE(world);
    const WorldRecord record = world->record();
    const int near = 5 + 32 * 7;
    const Vec3 from = vec3_of(50.0f, 0.3f, 70.0f);
    double all = 0.0;
    for (int e = 0; e < record.emitter_count; ++e) {
        all += double(emitter_weight(record.emitters[e], from, vec3_all(0.0f)));
    }
    const double best = double(emitter_weight(record.emitters[near], from, vec3_all(0.0f))) / all;
    EXPECT_GT(best, 0.8);
    EXPECT_GT(double(emitter_chance(record, from, vec3_all(0.0f), near, true)), 0.5 * best);
}

}  // namespace
}  // namespace lancer::statistics
