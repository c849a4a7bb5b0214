// The kernel's geometry for tests, once in float and once in double: the same formulas, the same records, plain doubles in and out.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/kernel/records.h"

namespace lancer::tests {

// A shape of any kind: the record that `kind` names counts.
struct Shape {
    int kind = kernel::OBJECT_SPHERE;
    kernel::SphereRecord sphere{};
    kernel::BoxRecord box{};
    kernel::PlaneRecord plane{};
    kernel::PlacedRecord placed{};
    kernel::TriangleRecord triangle{};
};

struct Line {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0};
};

constexpr double nothing = 1e38;  // distances from here on: no hit

struct Met {
    double t = 0.0;
    double u = 0.0;  // of triangles
    double v = 0.0;

    bool hits() const { return t < nothing; }
};

struct Surface {
    glm::dvec3 position{0.0};
    glm::dvec3 error{0.0};
    glm::dvec3 normal{0.0};
    glm::dvec3 local{0.0};
    glm::dvec2 uv{0.0};
};

struct Kernel {
    // What a camera does: a direction of length 1 in this precision.
    glm::dvec3 (*unit)(const glm::dvec3& v);
    Met (*meet)(const Shape& shape, const Line& line);
    Surface (*surface)(const Shape& shape, const Line& line, const Met& met);
    glm::dvec3 (*leave)(const Surface& surface, const glm::dvec3& direction);
    glm::dvec3 (*mirror)(const glm::dvec3& v, const glm::dvec3& n);
    double (*fresnel)(double cos_i, double eta, double& cos_t);
    glm::dvec3 (*refracted)(const glm::dvec3& direction, const glm::dvec3& normal, double cos_i, double cos_t, double eta);
    double (*index)(const kernel::MediumRecord& material, double nanometres);
};

extern const Kernel in_float;
extern const Kernel in_double;

}  // namespace lancer::tests
