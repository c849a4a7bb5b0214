#include "lancer/import/pbrt/quadrics.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace lancer::pbrt {

namespace {

constexpr int steps_around = 256;  // of a full turn
constexpr int steps_along = 128;

}  // namespace

scene::TriangleMesh swept_mesh(const Sweep& sweep) {
    scene::TriangleMesh mesh;
    const int around = std::max(3, static_cast<int>(std::ceil(steps_around * sweep.degrees / 360.0)));
    for (int i = 0; i <= around; ++i) {
        const double u = static_cast<double>(i) / around;
        const double angle = glm::radians(sweep.degrees) * u;
        const double c = std::cos(angle), s = std::sin(angle);
        const auto turned = [&](const glm::dvec3& p) { return glm::dvec3(p.x * c - p.y * s, p.x * s + p.y * c, p.z); };
        for (int j = 0; j <= sweep.steps; ++j) {
            const double v = static_cast<double>(j) / sweep.steps;
            const glm::dvec3 point = turned(sweep.point(v));
            // At a pole, where the sweep stands still, the way around is that of points nearby.
            const glm::dvec3 spread = std::hypot(point.x, point.y) > 0.0 ? point : turned(sweep.point(v < 0.5 ? 1e-6 : 1.0 - 1e-6));
            const glm::dvec3 across(-spread.y, spread.x, 0.0);
            const glm::dvec3 normal = glm::cross(across, turned(sweep.along(v)));
            const double length = glm::length(normal);
            mesh.positions.emplace_back(point);
            mesh.normals.emplace_back(length > 0.0 ? normal / length : glm::dvec3(0.0, 0.0, 1.0));
            mesh.uvs.emplace_back(u, v);
        }
    }
    const auto vertex = [&](int i, int j) { return static_cast<std::uint32_t>(i * (sweep.steps + 1) + j); };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        // Triangles at a pole have two corners in one place.
        if (mesh.positions[a] != mesh.positions[b] && mesh.positions[b] != mesh.positions[c] && mesh.positions[c] != mesh.positions[a]) {
            mesh.triangles.emplace_back(a, b, c);
        }
    };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < sweep.steps; ++j) {
            add(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
            add(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
        }
    }
    return mesh;
}

Sweep sphere_sweep(double radius, double low, double high, double degrees) {
    const double first = std::acos(std::clamp(low / radius, -1.0, 1.0)), last = std::acos(std::clamp(high / radius, -1.0, 1.0));
    const auto angle = [=](double v) { return first + (last - first) * v; };
    const auto point = [=](double v) {  // exactly on the axis at the poles
        const double z = radius * std::cos(angle(v));
        return glm::dvec3(std::sqrt(std::max((radius - z) * (radius + z), 0.0)), 0.0, z);
    };
    return {point, [=](double v) { return glm::dvec3(-std::cos(angle(v)), 0.0, std::sin(angle(v))); }, degrees, steps_along};
}

Sweep cone_sweep(double radius, double low, double other_radius, double high, double degrees) {
    const glm::dvec3 begin(radius, 0.0, low), end(other_radius, 0.0, high);
    return {[=](double v) { return begin + (end - begin) * v; }, [=](double) { return end - begin; }, degrees, 1};
}

Sweep paraboloid_sweep(double radius, double low, double high, double degrees) {
    const double top = std::max(high, 1e-30);
    const auto height = [=](double v) { return low + (high - low) * v; };
    const auto width = [=](double v) { return radius * std::sqrt(std::max(height(v), 0.0) / top); };
    return {[=](double v) { return glm::dvec3(width(v), 0.0, height(v)); },
            [=](double v) { return glm::dvec3(radius * radius / (2.0 * top), 0.0, width(v)); }, degrees, steps_along};
}

Sweep hyperboloid_sweep(const glm::dvec3& one, const glm::dvec3& other, double degrees) {
    return {[=](double v) { return one + (other - one) * v; }, [=](double) { return other - one; }, degrees, steps_along};
}

}  // namespace lancer::pbrt
