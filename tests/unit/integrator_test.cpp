// Which way light is followed when nobody says.
#include "lancer/scene/integrator.h"

#include <gtest/gtest.h>

namespace lancer::scene {
namespace {

Scene physical(bool glass, bool light_without_size) {
    Scene scene;
    scene.cameras.push_back({});
    Material matt;
    matt.model = DiffuseMaterial{};
    scene.materials.push_back(matt);
    if (glass) {
        Material clear;
        clear.model = DielectricMaterial{};
        scene.materials.push_back(clear);
    }
    if (light_without_size) {
        Light light;
        light.model = PointLight{};
        light.power = Rgb(1.0);
        scene.lights.push_back(light);
    }
    scene.background.horizon = Rgb(0.1);
    return scene;
}

TEST(Integrator, IsChosenByWhatTheSceneHas) {
    EXPECT_EQ(choose_integrator(Scene{}).name, "whitted");
    EXPECT_EQ(choose_integrator(physical(false, false)).name, "path");
    EXPECT_EQ(choose_integrator(physical(false, true)).name, "path");
    EXPECT_EQ(choose_integrator(physical(true, false)).name, "path");
    EXPECT_EQ(choose_integrator(physical(true, true)).name, "vcm");
    Scene rough = physical(true, true);
    std::get<DielectricMaterial>(rough.materials[1].model).roughness = 0.5;
    EXPECT_EQ(choose_integrator(rough).name, "path");
}

Object ball(const glm::dvec3& center, double radius, int material) {
    return {"ball", Sphere{center, radius}, material, glm::dmat4(1.0), {}};
}

TEST(Integrator, DependsOnHowSmallLampsAre) {
    Scene scene = physical(true, false);
    Material lamp;
    lamp.model = DiffuseMaterial{};
    lamp.emission = Emission{Color(1.0, 1.0, 1.0), 5000.0};
    scene.materials.push_back(lamp);
    scene.objects = {ball({0.0, 0.0, 0.0}, 1.0, 1), ball({3.0, 3.0, 0.0}, 0.02, 2)};
    EXPECT_EQ(choose_integrator(scene).name, "vcm");
    Scene wide = scene;
    wide.objects[1] = ball({3.0, 3.0, 0.0}, 0.5, 2);
    EXPECT_EQ(choose_integrator(wide).name, "path");
    Scene pale = scene;  // what is around it gives more
    pale.materials[2].emission->strength = 50.0;
    EXPECT_EQ(choose_integrator(pale).name, "path");
    Scene placed = scene;
    placed.groups.push_back({"lamps", {scene.objects[1]}, {}});
    placed.objects.pop_back();
    placed.placements.push_back({0, glm::dmat4(1.0), std::nullopt, {}});
    EXPECT_EQ(choose_integrator(placed).name, "vcm");
    placed.placements[0].to_parent = glm::dmat4(glm::dmat3(30.0));
    placed.placements[0].to_parent[3] = glm::dvec4(-87.0, -87.0, 0.0, 1.0);  // where it was, but larger
    EXPECT_EQ(choose_integrator(placed).name, "path");
    Scene matt = scene;
    matt.objects[0].material = 0;
    matt.materials[1].model = DiffuseMaterial{};
    EXPECT_EQ(choose_integrator(matt).name, "path");
}

TEST(Integrator, DependsOnWhatStandsCloseToLampsWithoutSize) {
    Scene scene = physical(false, true);
    scene.cameras[0].position = {0.0, 0.0, 5.0};
    scene.objects = {ball({0.0, -1.05, 0.0}, 1.0, 0)};
    EXPECT_EQ(choose_integrator(scene).name, "bdpt");
    scene.objects[0] = ball({0.0, -2.0, 0.0}, 1.0, 0);
    EXPECT_EQ(choose_integrator(scene).name, "path");
    scene.objects.push_back({"wall", Plane{{0.0, 0.0, -0.05}, {0.0, 0.0, 1.0}}, 0, glm::dmat4(1.0), {}});
    EXPECT_EQ(choose_integrator(scene).name, "bdpt");
    scene.objects[0].material = 0;
    scene.materials[0].open_behind = true;
    EXPECT_EQ(choose_integrator(scene).name, "path");
    scene.materials[0].open_behind = false;
    scene.objects.back() = {"room", Box{{-3.0, -3.0, -3.0}, {3.0, 3.0, 6.0}}, 0, glm::dmat4(1.0), {}};
    EXPECT_EQ(choose_integrator(scene).name, "path");
    scene.objects.back() = {"wall", Plane{{0.0, 0.0, -0.05}, {0.0, 0.0, 1.0}}, 0, glm::dmat4(1.0), {}};
    scene.lights[0].model = DirectionalLight{};
    EXPECT_EQ(choose_integrator(scene).name, "path");
}

TEST(Integrator, ThatIsAskedForIsTaken) {
    Scene scene = physical(true, true);
    scene.settings.integrator = "light";
    EXPECT_EQ(choose_integrator(scene).name, "light");
}

TEST(Integrator, IsNeverOneThatCantRenderTheScene) {
    for (const auto& spoil : {+[](Scene& s) { s.materials[0].open_behind = true; }, +[](Scene& s) { s.settings.glossy_bounces = 2; },
                              +[](Scene& s) { s.settings.aovs = {"variance"}; }, +[](Scene& s) { s.settings.spectral_bins = 4; }}) {
        Scene scene = physical(true, true);
        spoil(scene);
        const IntegratorChoice choice = choose_integrator(scene);
        EXPECT_EQ(choice.name, "path");
        EXPECT_TRUE(obstacles(scene, choice.name).empty());
        EXPECT_FALSE(choice.why.empty());
    }
    EXPECT_TRUE(obstacles(physical(true, true), "vcm").empty());
}

TEST(Integrator, ThatStartsAtLampsMakesWhatIsSeenFirst) {
    Scene scene = physical(true, true);
    scene.settings.aovs = {"albedo", "object_id", "samples"};
    EXPECT_EQ(choose_integrator(scene).name, "vcm");
    EXPECT_EQ(lacking(scene, "bdpt"), "");
    EXPECT_EQ(lacking(scene, "light"), "the AOV albedo");
    scene.settings.aovs = {"direct"};
    EXPECT_EQ(lacking(scene, "bdpt"), "the AOV direct");
    EXPECT_EQ(lacking(scene, "path"), "");
}

TEST(Integrator, JoinsNothingInThickMedia) {
    Scene scene = physical(true, true);
    scene.media.emplace_back();
    EXPECT_EQ(choose_integrator(scene).name, "vcm");
    scene.settings.bounces = 64;
    EXPECT_EQ(choose_integrator(scene).name, "path");
}

TEST(Integrator, OfLightAloneFindsNoGlow) {
    Scene scene = physical(false, false);
    scene.media.emplace_back();
    EXPECT_TRUE(obstacles(scene, "light").empty());
    scene.media[0].emission = Rgb(0.5);
    EXPECT_FALSE(obstacles(scene, "light").empty());
    EXPECT_TRUE(obstacles(scene, "bdpt").empty());
}

TEST(Integrator, OfLightAloneNeedsAPlaceToBegin) {
    Scene scene = physical(false, false);
    EXPECT_TRUE(obstacles(scene, "light").empty());
    scene.objects.push_back({"floor", Plane{}, 0, glm::dmat4(1.0), {}});
    EXPECT_FALSE(obstacles(scene, "light").empty());
    EXPECT_TRUE(obstacles(scene, "bdpt").empty());
}

}  // namespace
}  // namespace lancer::scene
