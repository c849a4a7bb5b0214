// Reflection, refraction and Fresnel's shares against their laws; a prism of N-BK7 ray by ray; nested and overlapping bodies.
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "analytic/families.h"
#include "lancer/kernel/refraction.h"
#include "lancer/spectrum/glass.h"

namespace lancer::tests {
namespace {

constexpr double u = 0x1p-24;
constexpr double n_bk7_d = 1.5168;

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }
double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

TEST(Reflection, TurnsTheRayRoundTheNormal) {
    Dice dice(71);
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 n = in_float.unit(dice.direction());
        const glm::dvec3 v = in_float.unit(dice.direction());
        const glm::dvec3 r = in_float.mirror(v, n);
        EXPECT_NEAR(glm::dot(r, n), glm::dot(v, n), 16.0 * u);
        EXPECT_NEAR(glm::length(r), 1.0, 16.0 * u);
        EXPECT_NEAR(glm::dot(glm::cross(v, n), r), 0.0, 16.0 * u) << "in one plane";
        EXPECT_LT(glm::length(r - (2.0 * glm::dot(v, n) * n - v)), 16.0 * u);
    }
}

TEST(Refraction, FollowsSnell) {
    Dice dice(72);
    int total = 0;
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 n = in_float.unit(dice.direction());
        glm::dvec3 d = in_float.unit(dice.direction());
        d = glm::dot(d, n) > 0.0 ? -d : d;
        const double eta = rounded(glm::dvec3(dice.log_between(0.4, 2.5))).x;
        const double cos_i = -glm::dot(d, n);
        double cos_t = 0.0;
        const double share = in_float.fresnel(cos_i, eta, cos_t);
        const double sin_t = std::sqrt(1.0 - cos_i * cos_i) / eta;
        if (sin_t >= 1.0 - 1e-6) {
            ++total;
            EXPECT_TRUE(share == 1.0 || sin_t < 1.0 + 1e-6);
            continue;
        }
        // The squared cosine is right to some roundings of the largest term, so near the critical angle the cosine to their root.
        EXPECT_NEAR(cos_t * cos_t, 1.0 - sin_t * sin_t, 8.0 * u * std::max(1.0, 1.0 / (eta * eta)));
        const glm::dvec3 t = in_float.refracted(d, n, cos_i, cos_t, eta);
        EXPECT_NEAR(glm::length(t), 1.0, 8.0 * u);
        EXPECT_LT(glm::dot(t, n), 0.0) << "on the other side";
        EXPECT_LT(glm::length(glm::cross(t, n) * eta - glm::cross(d, n)), 32.0 * u * (1.0 + eta)) << "n sin and the plane are kept";
    }
    EXPECT_GT(total, 200);
}

TEST(Fresnel, KnownValues) {
    for (const Kernel* kernel : {&in_float, &in_double}) {
        double cos_t = 0.0;
        EXPECT_NEAR(kernel->fresnel(1.0, n_bk7_d, cos_t), 0.0421646, 5e-8 + 4.0 * u);
        EXPECT_NEAR(cos_t, 1.0, 4.0 * u);
        // At Brewster's angle no parallel light is reflected: what is left is half of the perpendicular share.
        const double brewster = std::cos(radians(56.60383));
        const double perpendicular = std::pow((n_bk7_d * n_bk7_d - 1.0) / (n_bk7_d * n_bk7_d + 1.0), 2.0);
        EXPECT_NEAR(kernel->fresnel(brewster, n_bk7_d, cos_t), 0.5 * perpendicular, 1e-6);
        // Seen from inside, all is reflected from the critical angle on.
        EXPECT_LT(kernel->fresnel(std::cos(radians(41.24519 - 1e-4)), 1.0 / n_bk7_d, cos_t), 0.999);
        EXPECT_EQ(kernel->fresnel(std::cos(radians(41.24519 + 1e-4)), 1.0 / n_bk7_d, cos_t), 1.0);
        EXPECT_EQ(kernel->fresnel(0.1, 1.0 / n_bk7_d, cos_t), 1.0);
        EXPECT_EQ(cos_t, 0.0);
    }
}

TEST(Fresnel, EqualMediaReflectNothing) {
    for (double cosine = 1.0; cosine > 1e-6; cosine *= 0.7) {
        double cos_t = 0.0;
        EXPECT_EQ(in_float.fresnel(cosine, 1.0, cos_t), 0.0);
        EXPECT_NEAR(cos_t, cosine, 4.0 * u * cosine);
    }
}

// The energy that goes on, from the amplitudes of the refracted wave and the width of its beam, is what is not reflected.
TEST(Fresnel, EnergyIsKept) {
    Dice dice(73);
    for (int i = 0; i < 2000; ++i) {
        const double eta = dice.log_between(0.5, 2.5);
        const double cos_i = dice.between(0.01, 1.0);
        const double sin_t_2 = (1.0 - cos_i * cos_i) / (eta * eta);
        if (sin_t_2 > 0.999) {
            continue;
        }
        const double cos_t = std::sqrt(1.0 - sin_t_2);
        const double across = 2.0 * cos_i / (cos_i + eta * cos_t);
        const double along = 2.0 * cos_i / (eta * cos_i + cos_t);
        const double passes = eta * cos_t / cos_i * 0.5 * (across * across + along * along);
        double behind = 0.0;
        EXPECT_NEAR(in_double.fresnel(cos_i, eta, behind) + passes, 1.0, 1e-12);
        EXPECT_NEAR(behind, cos_t, 1e-12);
        EXPECT_NEAR(in_float.fresnel(cos_i, eta, behind) + passes, 1.0, 1e-5);
        // And light on the way back is reflected alike.
        double in_front = 0.0;
        EXPECT_NEAR(in_double.fresnel(cos_t, 1.0 / eta, in_front) + passes, 1.0, 1e-12);
        EXPECT_NEAR(in_front, cos_i, 1e-10);
    }
}

// A prism with an apex of 60 degrees, as a mesh: its refracting edge stands along z, its base below.
std::vector<Shape> prism_triangles() {
    auto mesh = std::make_shared<scene::TriangleMesh>();
    const float h = std::sqrt(3.0f);
    for (const float z : {-2.0f, 2.0f}) {
        mesh->positions.insert(mesh->positions.end(), {{-1.0f, 0.0f, z}, {1.0f, 0.0f, z}, {0.0f, h, z}});
    }
    mesh->triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < mesh->triangles.size(); ++i) {
        Shape shape;
        shape.kind = kernel::OBJECT_TRIANGLE;
        const glm::uvec3 t = mesh->triangles[i];
        shape.triangle = {mesh->positions[t.x], mesh->positions[t.y], mesh->positions[t.z]};
        shapes.push_back(shape);
    }
    return shapes;
}

// Follows one ray through glass by the kernel's own steps, until it leaves the scene; degrees between its first and its last direction.
double deviation(const Kernel& kernel, const std::vector<Shape>& shapes, const kernel::MediumRecord& glass, Line line, double nanometres) {
    const glm::dvec3 first = line.direction;
    for (int i = 0; i < 4; ++i) {
        const Shape* nearest = nullptr;
        Met met{nothing, 0.0, 0.0};
        for (const Shape& shape : shapes) {
            if (const Met m = kernel.meet(shape, line); m.t < met.t) {
                met = m;
                nearest = &shape;
            }
        }
        if (nearest == nullptr) {
            EXPECT_EQ(i, 2) << "in and out again";
            return degrees(std::atan2(glm::length(glm::cross(first, line.direction)), glm::dot(first, line.direction)));
        }
        const Surface s = kernel.surface(*nearest, line, met);
        const bool inside = glm::dot(s.normal, line.direction) > 0.0;
        const glm::dvec3 n = inside ? -s.normal : s.normal;
        const double index = kernel.index(glass, nanometres);
        const double eta = inside ? 1.0 / index : index;
        const double cos_i = -glm::dot(n, line.direction);
        double cos_t = 0.0;
        kernel.fresnel(cos_i, eta, cos_t);
        const glm::dvec3 d = kernel.refracted(line.direction, n, cos_i, cos_t, eta);
        line = {kernel.leave(s, d), d};
    }
    ADD_FAILURE() << "the ray does not leave the prism";
    return 0.0;
}

TEST(Prism, DeviatesEachLineAsTheCatalogueSays) {
    const Sellmeier bk7 = *find_glass("N-BK7");
    kernel::MediumRecord glass{};
    glass.refraction = kernel::REFRACTION_SELLMEIER;
    glass.refraction_a = kernel::vec3(glm::dvec3(bk7.b[0], bk7.b[1], bk7.b[2]));
    glass.refraction_b = kernel::vec3(glm::dvec3(bk7.c[0], bk7.c[1], bk7.c[2]));
    // Onto the left face, whose outward normal is 30 degrees above the horizon towards -x.
    const glm::dvec3 normal(-std::sqrt(3.0) / 2.0, 0.5, 0.0);
    const glm::dvec3 along(0.5, std::sqrt(3.0) / 2.0, 0.0);  // up the face
    const double incidence = radians(49.32335);
    const glm::dvec3 direction = -std::cos(incidence) * normal + std::sin(incidence) * along;
    const glm::dvec3 target = glm::dvec3(-1.0, 0.0, 0.0) + along * 1.0;
    struct LineOfLight {
        const char* name;
        double nanometres;
        double deviation;
    };
    for (const LineOfLight& light :
         {LineOfLight{"g", 435.8343, 39.52249}, LineOfLight{"F", 486.1327, 39.13905}, LineOfLight{"e", 546.0740, 38.81590},
          LineOfLight{"d", 587.5618, 38.64670}, LineOfLight{"C", 656.2725, 38.42932}}) {
        for (const Kernel* kernel : {&in_float, &in_double}) {
            const Line line{rounded(target - direction * 3.0), kernel->unit(direction)};
            EXPECT_NEAR(deviation(*kernel, prism_triangles(), glass, line, light.nanometres), light.deviation,
                        kernel == &in_float ? 1e-4 : 1e-5)
                << light.name << (kernel == &in_float ? " in float" : " in double");
        }
    }
}

TEST(Media, LastEnteredFirst) {
    using namespace kernel;
    const Media empty = no_media();
    EXPECT_EQ(empty.first, -1);
    Media m = entered(entered(empty, 7), 3);
    EXPECT_EQ(m.first, 3);
    EXPECT_EQ(m.second, 7);
    EXPECT_TRUE(is_inside(m, 7));
    EXPECT_FALSE(is_inside(m, 5));
    m = left(m, 7);  // out of the outer one while still in the inner one: they overlap
    EXPECT_EQ(m.first, 3);
    EXPECT_EQ(m.second, -1);
    m = left(m, 5);
    EXPECT_EQ(m.first, 3) << "leaving what was never entered changes nothing";
    EXPECT_EQ(left(m, 3).first, -1);
    m = left(entered(entered(empty, 4), 4), 4);
    EXPECT_EQ(m.first, 4) << "two bodies of one material";
    for (const int material : {1, 2, 3, 4, 5}) {
        m = entered(m, material);
    }
    EXPECT_EQ(m.first, 5);
    EXPECT_EQ(m.fourth, 2);
}

TEST(Media, BordersBendByWhatIsOnTheirSides) {
    using namespace kernel;
    std::array<MediumRecord, 2> fillings{};
    fillings[0].refraction_a = vec3(1.5f, 0.0f, 0.0f);  // glass
    fillings[1].refraction_a = vec3(1.2f, 0.0f, 0.0f);  // liquid
    WorldRecord world{};
    world.media = fillings.data();
    const auto eta = [&](const Media& media, int material, bool inside) {
        return static_cast<double>(border_at(world, media, material, inside, 0.9f, 587.6f, true).eta);
    };
    const Media glass = entered(no_media(), 0);
    EXPECT_NEAR(eta(no_media(), 0, false), 1.5, 1e-6);
    EXPECT_NEAR(eta(glass, 0, true), 1.0 / 1.5, 1e-6);
    EXPECT_NEAR(eta(glass, 1, false), 1.2 / 1.5, 1e-6) << "a drop in glass";
    EXPECT_NEAR(eta(entered(glass, 1), 1, true), 1.5 / 1.2, 1e-6);
    EXPECT_NEAR(eta(no_media(), 0, true), 1.0 / 1.5, 1e-6) << "the camera is in the glass";
    // The liquid reaches into the glass's wall and was entered last: it fills the overlap, and the wall in it bends nothing.
    EXPECT_EQ(eta(entered(glass, 1), 0, true), 1.0);
    EXPECT_NEAR(eta(entered(no_media(), 1), 1, true), 1.0 / 1.2, 1e-6);
}

}  // namespace
}  // namespace lancer::tests
