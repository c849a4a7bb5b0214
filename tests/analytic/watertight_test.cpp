// No ray slips between two triangles that share an edge or a corner, however it rounds; nor past the rim of a closed cylinder or cone.
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "analytic/families.h"
#include "analytic/solids.h"

namespace lancer::tests {
namespace {

struct ClosedMesh {
    std::vector<glm::vec3> corners;
    std::vector<glm::uvec3> triangles;
    glm::dvec3 center{0.0};

    bool is_hit(const Line& line) const {
        Shape shape;
        shape.kind = kernel::OBJECT_TRIANGLE;
        for (const glm::uvec3& t : triangles) {
            shape.triangle = {corners[t.x], corners[t.y], corners[t.z]};
            if (in_float.meet(shape, line).hits()) {
                return true;
            }
        }
        return false;
    }
};

// Rings of longitude and latitude around a center: two poles where many triangles meet, sixes elsewhere, flat triangles near the poles.
ClosedMesh globe(int rings, int sectors, double bumps, const glm::dvec3& center, Dice& dice) {
    ClosedMesh mesh;
    mesh.center = center;
    const auto add = [&](double polar, double around) {
        const glm::dvec3 p(std::sin(polar) * std::sin(around), std::cos(polar), std::sin(polar) * std::cos(around));
        mesh.corners.emplace_back(center + p * (1.0 + bumps * dice.between(-1.0, 1.0)));
    };
    add(0.0, 0.0);
    for (int i = 1; i < rings; ++i) {
        for (int j = 0; j < sectors; ++j) {
            add(std::numbers::pi * i / rings, 2.0 * std::numbers::pi * j / sectors);
        }
    }
    add(std::numbers::pi, 0.0);
    const auto corner = [&](int i, int j) {
        return i == 0       ? 0u
               : i == rings ? static_cast<unsigned>(mesh.corners.size() - 1)
                            : static_cast<unsigned>(1 + (i - 1) * sectors + j % sectors);
    };
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < sectors; ++j) {
            if (i > 0) {
                mesh.triangles.emplace_back(corner(i, j), corner(i + 1, j), corner(i, j + 1));
            }
            if (i + 1 < rings) {
                mesh.triangles.emplace_back(corner(i, j + 1), corner(i + 1, j), corner(i + 1, j + 1));
            }
        }
    }
    return mesh;
}

// A corner, a point on an edge, or one in the middle of a triangle.
glm::dvec3 place_on(const ClosedMesh& mesh, Dice& dice) {
    const glm::uvec3 t = mesh.triangles[static_cast<std::size_t>(dice.below(static_cast<int>(mesh.triangles.size())))];
    const double w = dice.coin() ? 0.0 : dice.between(0.0, 1.0);
    return glm::mix(glm::dvec3(mesh.corners[t.x]), glm::dvec3(mesh.corners[t.y]), w);
}

TEST(Watertight, FromInsideAMesh) {
    Dice dice(41);
    for (const double from_origin : {0.0, 10.0, 1e3}) {
        const ClosedMesh mesh = globe(7, 13, 0.2, from_origin * glm::dvec3(1.0, 0.7, -0.4), dice);
        for (int i = 0; i < 12000; ++i) {
            const glm::dvec3 origin = rounded(mesh.center + dice.in_cube(0.25));
            ASSERT_TRUE(mesh.is_hit({origin, in_float.unit(place_on(mesh, dice) - origin)})) << i << ", " << from_origin;
        }
    }
}

// A convex mesh, aimed at well inside of its outline.
TEST(Watertight, FromOutsideAMesh) {
    Dice dice(42);
    const ClosedMesh mesh = globe(7, 13, 0.0, {3.0, -2.0, 1.0}, dice);
    int tried = 0;
    for (int i = 0; i < 30000; ++i) {
        const glm::dvec3 origin = rounded(mesh.center + dice.direction() * dice.log_between(1.5, 1e4));
        const glm::dvec3 target = place_on(mesh, dice);
        if (glm::dot(glm::normalize(target - mesh.center), glm::normalize(origin - target)) < 0.5) {
            continue;
        }
        ++tried;
        ASSERT_TRUE(mesh.is_hit({origin, in_float.unit(target - origin)})) << i;
    }
    EXPECT_GT(tried, 5000);
}

// Rays that pass a corner exactly, with coordinates that do not round.
TEST(Watertight, ExactlyThroughCorners) {
    ClosedMesh cube;
    for (int i = 0; i < 8; ++i) {
        cube.corners.emplace_back((i & 1) != 0 ? 1.0f : -1.0f, (i & 2) != 0 ? 1.0f : -1.0f, (i & 4) != 0 ? 1.0f : -1.0f);
    }
    for (const glm::uvec4& q : {glm::uvec4(0, 2, 3, 1), glm::uvec4(4, 5, 7, 6), glm::uvec4(0, 1, 5, 4), glm::uvec4(2, 6, 7, 3),
                                glm::uvec4(0, 4, 6, 2), glm::uvec4(1, 3, 7, 5)}) {
        cube.triangles.emplace_back(q.x, q.y, q.z);
        cube.triangles.emplace_back(q.x, q.z, q.w);
    }
    for (const glm::vec3& corner : cube.corners) {
        EXPECT_TRUE(cube.is_hit({glm::dvec3(0.0), in_float.unit(glm::dvec3(corner))}));
    }
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            glm::dvec3 d(0.0);
            d[axis] = sign;
            EXPECT_TRUE(cube.is_hit({glm::dvec3(0.0), d})) << "onto the diagonal of a face";
        }
    }
}

// A ray past the rim of a closed body that comes in must not be seen from inside first.
TEST(Watertight, Rims) {
    Dice dice(43);
    for (const double top : {1.0, 0.4, 1.7}) {
        const Shape shape = compile_shape(scene::Cone{{0.3, -0.2, 0.1}, {0.9, 1.1, -0.4}, 1.0, top, true});
        const glm::dvec3 middle(0.6, 0.45, -0.15);
        for (int i = 0; i < 20000; ++i) {
            // A point of the rim, at the bottom or at the top.
            const bool upper = dice.coin();
            const double angle = dice.between(0.0, 2.0 * std::numbers::pi);
            const double radius = static_cast<double>(upper ? shape.placed.top_radius : shape.placed.bottom_radius);
            const glm::dvec3 p(radius * std::cos(angle), upper ? 1.0 : 0.0, radius * std::sin(angle));
            const kernel::AffineRecord& m = shape.placed.to_world;
            const glm::dvec3 rim(glm::dot(glm::dvec3(m.row_x), p) + static_cast<double>(m.shift.x),
                                 glm::dot(glm::dvec3(m.row_y), p) + static_cast<double>(m.shift.y),
                                 glm::dot(glm::dvec3(m.row_z), p) + static_cast<double>(m.shift.z));
            const glm::dvec3 origin = rounded(middle + dice.direction() * dice.log_between(4.0, 1e3));
            const Line line{origin, in_float.unit(rim - origin)};
            const Met met = in_float.meet(shape, line);
            if (met.hits()) {
                ASSERT_LT(glm::dot(in_float.surface(shape, line, met).normal, line.direction), 1e-3) << i;
            }
        }
    }
}

}  // namespace
}  // namespace lancer::tests
