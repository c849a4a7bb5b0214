#include "lancer/import/mitsuba/curves.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "lancer/import/mesh/mesh_check.h"
#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/import/mitsuba/values.h"

namespace lancer::mitsuba {

namespace {

constexpr int sides = 8;
constexpr int steps_a_span = 6;
constexpr std::size_t most_rings = 4'000'000;

using Curve = std::vector<glm::dvec4>;  // points, and radii as the fourth

std::vector<Curve> parse(std::string_view text, MeshMessages& messages) {
    std::vector<Curve> curves(1);
    int line = 0;
    while (!text.empty() && !messages.has_too_many_errors()) {
        ++line;
        const std::size_t end = std::min(text.find('\n'), text.size());
        const auto numbers = parse_numbers(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!numbers || (numbers->size() != 4 && !numbers->empty())) {
            messages.error(line, 1, "expected four numbers: x y z radius");
        } else if (numbers->empty()) {
            curves.emplace_back();
        } else if (!((*numbers)[3] > 0.0)) {
            messages.error(line, 1, fmt::format("the radius is {}: expected one above 0", (*numbers)[3]));
        } else {
            curves.back().emplace_back((*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]);
        }
    }
    return curves;
}

// The weights of four control points of a uniform cubic B-spline.
glm::dvec4 on_spline(const glm::dvec4* p, double t) {
    const double s = 1.0 - t;
    return (p[0] * (s * s * s) + p[1] * (3.0 * t * t * t - 6.0 * t * t + 4.0) + p[2] * (3.0 * s * s * s - 6.0 * s * s + 4.0) +
            p[3] * (t * t * t)) /
           6.0;
}

Curve points_of(const Curve& control, bool smooth) {
    if (!smooth) {
        return control;
    }
    Curve points;
    for (std::size_t i = 0; i + 4 <= control.size(); ++i) {
        for (int k = i == 0 ? 0 : 1; k <= steps_a_span; ++k) {
            points.push_back(on_spline(&control[i], static_cast<double>(k) / steps_a_span));
        }
    }
    return points;
}

void add_tube(const Curve& points, scene::TriangleMesh& mesh) {
    glm::dvec3 across(0.0);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 along = glm::dvec3(points[std::min(i + 1, points.size() - 1)]) - glm::dvec3(points[i > 0 ? i - 1 : 0]);
        const glm::dvec3 forward = glm::length(along) > 0.0 ? glm::normalize(along) : glm::dvec3(0.0, 0.0, 1.0);
        // The frame turns as little as it can from ring to ring.
        across -= forward * glm::dot(across, forward);
        if (!(glm::length(across) > 1e-9)) {
            across = glm::cross(forward, std::abs(forward.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0));
        }
        across = glm::normalize(across);
        const glm::dvec3 third = glm::cross(forward, across);
        for (int k = 0; k < sides; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / sides;
            const glm::dvec3 out = across * std::cos(angle) + third * std::sin(angle);
            mesh.positions.emplace_back(glm::dvec3(points[i]) + out * points[i].w);
            mesh.normals.emplace_back(out);
            mesh.uvs.emplace_back(static_cast<float>(k) / sides, static_cast<float>(i) / static_cast<float>(points.size() - 1));
        }
    }
    for (std::uint32_t i = 0; i + 1 < points.size(); ++i) {
        for (std::uint32_t k = 0; k < sides; ++k) {
            const std::uint32_t a = first + i * sides + k, b = first + i * sides + (k + 1) % sides;
            mesh.triangles.emplace_back(a, b, b + sides);
            mesh.triangles.emplace_back(a, b + sides, a + sides);
        }
    }
}

}  // namespace

std::optional<scene::TriangleMesh> read_curves(std::string_view text, bool smooth, const std::string& file, Diagnostics& diagnostics) {
    MeshMessages messages(file, diagnostics);
    const std::vector<Curve> curves = parse(text, messages);
    scene::TriangleMesh mesh;
    for (const Curve& control : curves) {
        if (messages.has_errors()) {
            return std::nullopt;
        }
        const Curve points = points_of(control, smooth);
        if (points.size() >= 2) {
            add_tube(points, mesh);
        } else if (!control.empty()) {
            messages.warning(0, 0, fmt::format("a curve of {} points is left out: it takes {}", control.size(), smooth ? 4 : 2));
        }
        if (mesh.positions.size() > most_rings * sides) {
            messages.error(0, 0, "there are far too many curves");
        }
    }
    return !messages.has_errors() && check_mesh(mesh, messages) ? std::optional(std::move(mesh)) : std::nullopt;
}

}  // namespace lancer::mitsuba
