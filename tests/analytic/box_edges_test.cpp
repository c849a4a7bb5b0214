// Rays in the planes of a box's faces, along its edges and through its corners, and rays that start there. Boxes are half open: a ray in the
// plane of a low face is inside, one in the plane of a high face outside, whatever the signs of its zeros.
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "analytic/families.h"

namespace lancer::tests {
namespace {

// The same box in the world and as a placed shape.
std::vector<Shape> both_kinds() {
    const scene::Box box{{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
    Shape placed;
    placed.kind = kernel::OBJECT_PLACED_BOX;
    const kernel::AffineRecord identity{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    placed.placed = {identity, identity, identity, 1.0f, 1.0f, 1};
    return {compile_shape(box), placed};
}

// All directions along axis `i`, with each pair of signs of the zeros.
std::vector<glm::dvec3> along_axis(int i, double sign) {
    std::vector<glm::dvec3> directions;
    for (const double first : {0.0, -0.0}) {
        for (const double second : {0.0, -0.0}) {
            glm::dvec3 d(0.0);
            d[i] = sign;
            d[(i + 1) % 3] = first;
            d[(i + 2) % 3] = second;
            directions.push_back(d);
        }
    }
    return directions;
}

template <class Check>
void for_each_direction(const Check& check) {
    for (const Shape& shape : both_kinds()) {
        for (int i = 0; i < 3; ++i) {
            for (const double sign : {1.0, -1.0}) {
                for (const glm::dvec3& d : along_axis(i, sign)) {
                    check(shape, i, d);
                }
            }
        }
    }
}

TEST(BoxEdges, HalfOpenInThePlaneOfAFace) {
    for_each_direction([](const Shape& shape, int i, const glm::dvec3& d) {
        for (const Kernel* kernel : {&in_float, &in_double}) {
            const int across = (i + 1) % 3;
            glm::dvec3 origin = -3.0 * d;
            origin[(i + 2) % 3] = 0.25;
            origin[across] = -1.0;
            EXPECT_EQ(kernel->meet(shape, {origin, d}).t, 2.0) << "in the plane of a low face";
            origin[across] = 1.0;
            EXPECT_FALSE(kernel->meet(shape, {origin, d}).hits()) << "in the plane of a high face";
        }
    });
}

TEST(BoxEdges, HalfOpenAlongAnEdge) {
    for_each_direction([](const Shape& shape, int i, const glm::dvec3& d) {
        for (const double first : {-1.0, 1.0}) {
            for (const double second : {-1.0, 1.0}) {
                glm::dvec3 origin = -3.0 * d;
                origin[(i + 1) % 3] = first;
                origin[(i + 2) % 3] = second;
                EXPECT_EQ(in_float.meet(shape, {origin, d}).hits(), first < 0.0 && second < 0.0);
            }
        }
    });
}

TEST(BoxEdges, OriginsOnAFace) {
    for_each_direction([](const Shape& shape, int i, const glm::dvec3& d) {
        glm::dvec3 on_face(0.0);
        on_face[i] = -d[i];  // the face that the ray comes in by
        EXPECT_EQ(in_float.meet(shape, {on_face, d}).t, 2.0) << "inwards: the far face";
        EXPECT_FALSE(in_float.meet(shape, {-on_face, d}).hits()) << "outwards";
        EXPECT_EQ(in_float.meet(shape, {glm::dvec3(0.0), d}).t, 1.0) << "from the middle";
    });
}

TEST(BoxEdges, OriginsOnEdgesAndCorners) {
    const glm::dvec3 diagonal = in_float.unit(glm::dvec3(1.0));
    for (const Shape& shape : both_kinds()) {
        EXPECT_FALSE(in_float.meet(shape, {glm::dvec3(1.0), diagonal}).hits());
        EXPECT_FALSE(in_float.meet(shape, {glm::dvec3(-1.0), -diagonal}).hits());
        EXPECT_NEAR(in_float.meet(shape, {glm::dvec3(-1.0), diagonal}).t, std::sqrt(12.0), 1e-6);
        EXPECT_NEAR(in_float.meet(shape, {glm::dvec3(1.0), -diagonal}).t, std::sqrt(12.0), 1e-6);
        const glm::dvec3 inwards = in_float.unit({1.0, 1.0, 0.0});
        EXPECT_NEAR(in_float.meet(shape, {{-1.0, -1.0, 0.0}, inwards}).t, std::sqrt(8.0), 1e-6);
        EXPECT_FALSE(in_float.meet(shape, {{1.0, 1.0, 0.0}, inwards}).hits());
    }
}

// A face seen from outside near its edge: it is that face and no other, even where the point rounds onto the edge.
TEST(BoxEdges, NormalsFaceTheRay) {
    Dice dice(31);
    for (const Shape& shape : both_kinds()) {
        for (int i = 0; i < 20000; ++i) {
            const int axis = dice.below(3);
            glm::dvec3 target = dice.in_cube(1.0);
            target[axis] = dice.sign();
            target[(axis + 1) % 3] = dice.sign() * (1.0 - dice.log_between(1e-9, 1e-5));
            const glm::dvec3 origin = rounded(dice.direction() * dice.log_between(0.1, 1e3));
            const Line line{origin, in_float.unit(target - origin)};
            const Met met = in_float.meet(shape, line);
            if (!met.hits()) {
                continue;
            }
            const bool outside = std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)}) > 1.0;
            ASSERT_EQ(glm::dot(in_float.surface(shape, line, met).normal, line.direction) < 0.0, outside) << i;
        }
    }
}

}  // namespace
}  // namespace lancer::tests
