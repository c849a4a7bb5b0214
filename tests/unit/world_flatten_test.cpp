// Groups and placements as one list, and the order in which their transforms act.
#include "lancer/world/flatten.h"

#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace lancer {
namespace {

const glm::dmat4 identity(1.0);
const glm::dmat4 to_the_right = glm::translate(identity, glm::dvec3(10.0, 0.0, 0.0));
const glm::dmat4 twice = glm::scale(identity, glm::dvec3(2.0));
const glm::dmat4 quarter_turn = glm::rotate(identity, std::numbers::pi / 2.0, glm::dvec3(0.0, 0.0, 1.0));  // x to y

scene::Object object(const char* name, const glm::dmat4& to_parent = identity, int material = 0) {
    return {name, scene::Sphere{}, material, to_parent, {}};
}

scene::Placement placement(int group, const glm::dmat4& to_parent = identity, std::optional<int> material = std::nullopt) {
    return {group, to_parent, material, {}};
}

glm::dvec3 where(const FlatObject& flat, const glm::dvec3& p) { return glm::dvec3(flat.to_world * glm::dvec4(p, 1.0)); }

std::string names(const std::vector<FlatObject>& flat) {
    std::string result;
    for (const FlatObject& f : flat) {
        result += f.object->name + " ";
    }
    return result;
}

TEST(Flatten, InTheOrderOfTheFile) {
    scene::Scene scene;
    scene.groups = {{"pair", {object("a"), object("b")}, {}}, {"more", {object("c")}, {placement(0), placement(0)}}};
    scene.objects = {object("first"), object("second")};
    scene.placements = {placement(1), placement(0)};
    EXPECT_EQ(names(flatten(scene)), "first second c a b a b a b ");
    scene.placements.clear();
    EXPECT_EQ(names(flatten(scene)), "first second ");
}

TEST(Flatten, InnerTransformsActFirst) {
    scene::Scene scene;
    scene.groups = {{"inner", {object("o", twice)}, {}}, {"outer", {}, {placement(0, quarter_turn)}}};
    scene.placements = {placement(1, to_the_right)};
    const auto flat = flatten(scene);
    ASSERT_EQ(flat.size(), 1u);
    // (1, 0, 0) is doubled, turned to y, then moved.
    EXPECT_LT(glm::length(where(flat[0], {1.0, 0.0, 0.0}) - glm::dvec3(10.0, 2.0, 0.0)), 1e-12);
}

TEST(Flatten, EachPlacementHasItsOwnMap) {
    scene::Scene scene;
    scene.groups = {{"group", {object("o", to_the_right)}, {}}};
    scene.placements = {placement(0), placement(0, quarter_turn), placement(0, twice)};
    const auto flat = flatten(scene);
    ASSERT_EQ(flat.size(), 3u);
    EXPECT_LT(glm::length(where(flat[0], glm::dvec3(0.0)) - glm::dvec3(10.0, 0.0, 0.0)), 1e-12);
    EXPECT_LT(glm::length(where(flat[1], glm::dvec3(0.0)) - glm::dvec3(0.0, 10.0, 0.0)), 1e-12);
    EXPECT_LT(glm::length(where(flat[2], glm::dvec3(0.0)) - glm::dvec3(20.0, 0.0, 0.0)), 1e-12);
}

TEST(Flatten, TheOutermostMaterialReplacesThoseInside) {
    scene::Scene scene;
    scene.groups = {{"inner", {object("o", identity, 1)}, {}},
                    {"outer", {object("p", identity, 2)}, {placement(0), placement(0, identity, 3)}}};
    scene.placements = {placement(1), placement(1, identity, 4)};
    std::vector<int> materials;
    for (const FlatObject& flat : flatten(scene)) {
        materials.push_back(flat.material);
    }
    EXPECT_EQ(materials, (std::vector<int>{2, 1, 3, 4, 4, 4}));
}

}  // namespace
}  // namespace lancer
