#include "lancer/import/pbrt/curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace lancer::pbrt {

namespace {

constexpr int steps = 8;  // along each piece of the curve
constexpr int sides = 6;  // of a tube

using Piece = std::array<glm::dvec3, 4>;  // a cubic Bezier curve

// The pieces of a curve as cubic Bezier curves; empty where the number of points does not fit.
std::vector<Piece> pieces_of(const std::vector<glm::vec3>& points, bool b_spline, int degree) {
    std::vector<Piece> pieces;
    const std::size_t d = static_cast<std::size_t>(degree);
    const auto p = [&](std::size_t i) { return glm::dvec3(points[i]); };
    if (b_spline ? points.size() < d + 1 : points.size() < d + 1 || (points.size() - 1) % d != 0) {
        return pieces;
    }
    const std::size_t count = b_spline ? points.size() - d : (points.size() - 1) / d;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = b_spline ? i : i * d;
        if (degree == 3 && b_spline) {  // the same curve through Bezier's points
            const glm::dvec3 a = p(at), b = p(at + 1), c = p(at + 2), e = p(at + 3);
            pieces.push_back({(a + 4.0 * b + c) / 6.0, (2.0 * b + c) / 3.0, (b + 2.0 * c) / 3.0, (b + 4.0 * c + e) / 6.0});
        } else if (degree == 3) {
            pieces.push_back({p(at), p(at + 1), p(at + 2), p(at + 3)});
        } else {  // a parabola, raised to a cubic
            const glm::dvec3 begin = b_spline ? 0.5 * (p(at) + p(at + 1)) : p(at), middle = p(at + 1);
            const glm::dvec3 end = b_spline ? 0.5 * (p(at + 1) + p(at + 2)) : p(at + 2);
            pieces.push_back({begin, (begin + 2.0 * middle) / 3.0, (2.0 * middle + end) / 3.0, end});
        }
    }
    return pieces;
}

glm::dvec3 point_at(const Piece& b, double t) {
    const double s = 1.0 - t;
    return b[0] * (s * s * s) + b[1] * (3.0 * s * s * t) + b[2] * (3.0 * s * t * t) + b[3] * (t * t * t);
}

glm::dvec3 slope_at(const Piece& b, double t) {
    const double s = 1.0 - t;
    const glm::dvec3 slope = (b[1] - b[0]) * (s * s) + (b[2] - b[1]) * (2.0 * s * t) + (b[3] - b[2]) * (t * t);
    return glm::length(slope) > 0.0 ? slope : b[3] - b[0];
}

glm::dvec3 across(const glm::dvec3& direction) {
    const glm::dvec3 other = std::abs(direction.x) < 0.9 * glm::length(direction) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    return glm::normalize(glm::cross(direction, other));
}

struct Outline {
    std::vector<glm::dvec3> points, slopes;
    std::vector<double> widths, v;
};

Outline outline_of(const std::vector<Piece>& pieces, double first_width, double last_width) {
    Outline outline;
    const double all = static_cast<double>(pieces.size()) * steps;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int j = i == 0 ? 0 : 1; j <= steps; ++j) {
            const double t = static_cast<double>(j) / steps;
            const double v = (static_cast<double>(i) * steps + j) / all;
            outline.points.push_back(point_at(pieces[i], t));
            outline.slopes.push_back(slope_at(pieces[i], t));
            outline.widths.push_back(first_width + (last_width - first_width) * v);
            outline.v.push_back(v);
        }
    }
    return outline;
}

// Rings of corners around the curve; neighbours are turned as little as can be.
scene::TriangleMesh tube(const Outline& outline) {
    scene::TriangleMesh mesh;
    glm::dvec3 side(0.0);
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
        const double length = glm::length(outline.slopes[i]);
        const glm::dvec3 along = length > 0.0 ? outline.slopes[i] / length : glm::dvec3(0, 0, 1);
        side -= along * glm::dot(side, along);
        side = glm::length(side) > 1e-6 ? glm::normalize(side) : across(along);
        const glm::dvec3 up = glm::cross(along, side);
        for (int k = 0; k <= sides; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / sides;
            const glm::dvec3 normal = side * std::cos(angle) + up * std::sin(angle);
            mesh.positions.emplace_back(outline.points[i] + normal * (0.5 * outline.widths[i]));
            mesh.normals.emplace_back(normal);
            mesh.uvs.emplace_back(static_cast<double>(k) / sides, outline.v[i]);
        }
    }
    for (std::uint32_t i = 0; i + 1 < outline.points.size(); ++i) {
        for (std::uint32_t k = 0; k < sides; ++k) {
            const std::uint32_t a = i * (sides + 1) + k, b = a + sides + 1;
            mesh.triangles.emplace_back(a, a + 1, b + 1);
            mesh.triangles.emplace_back(a, b + 1, b);
        }
    }
    return mesh;
}

// A strip whose faces look along normals that turn from those of one end of a piece to those of its other end.
scene::TriangleMesh ribbon(const Outline& outline, const std::vector<glm::vec3>& normals) {
    scene::TriangleMesh mesh;
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
        const double at = static_cast<double>(i) / steps;
        const std::size_t piece = std::min(static_cast<std::size_t>(at), normals.size() - 2);
        const double t = at - static_cast<double>(piece);
        glm::dvec3 normal = glm::dvec3(normals[piece]) * (1.0 - t) + glm::dvec3(normals[piece + 1]) * t;
        glm::dvec3 side = glm::cross(outline.slopes[i], normal);
        side = glm::length(side) > 0.0 ? glm::normalize(side) : across(outline.slopes[i]);
        normal = glm::cross(side, outline.slopes[i]);
        for (int k = 0; k < 2; ++k) {
            mesh.positions.emplace_back(outline.points[i] + side * ((k - 0.5) * outline.widths[i]));
            mesh.normals.emplace_back(glm::length(normal) > 0.0 ? glm::normalize(normal) : glm::dvec3(0, 0, 1));
            mesh.uvs.emplace_back(k, outline.v[i]);
        }
    }
    for (std::uint32_t i = 0; i + 1 < outline.points.size(); ++i) {
        mesh.triangles.emplace_back(2 * i, 2 * i + 1, 2 * i + 3);
        mesh.triangles.emplace_back(2 * i, 2 * i + 3, 2 * i + 2);
    }
    return mesh;
}

}  // namespace

SharedMesh read_curve_mesh(const Parameters& parameters, bool reversed) {
    const std::string basis = parameters.string("basis", "bezier"), type = parameters.string("type", "flat");
    const int degree = parameters.integer("degree", 3);
    const std::vector<glm::vec3> points = parameters.triples("P");
    if ((basis != "bezier" && basis != "bspline") || degree < 2 || degree > 3) {
        parameters.context().diagnostics.error(parameters.position(), parameters.owner() + " is a bezier or a bspline of degree 2 or 3");
        return nullptr;
    }
    const std::vector<Piece> pieces = pieces_of(points, basis == "bspline", degree);
    if (pieces.empty()) {
        parameters.context().diagnostics.error(parameters.position(), fmt::format("{}: {} points do not make a {} of degree {}",
                                                                                  parameters.owner(), points.size(), basis, degree));
        return nullptr;
    }
    const double width = parameters.number("width", 1.0);
    const Outline outline = outline_of(pieces, parameters.number("width0", width), parameters.number("width1", width));
    parameters.pass_over({"splitdepth"});
    const std::vector<glm::vec3> normals = parameters.triples("N");
    if (type == "ribbon") {
        if (normals.size() != pieces.size() + 1) {
            parameters.context().diagnostics.error(parameters.position(),
                                                   fmt::format("{}: a ribbon of {} pieces needs {} normals, found {}", parameters.owner(),
                                                               pieces.size(), pieces.size() + 1, normals.size()));
            return nullptr;
        }
        parameters.context().report.approximated(parameters.owner() + ", ribbon", "triangles", parameters.position());
        return finished_mesh(ribbon(outline, normals), parameters, reversed);
    }
    parameters.context().report.approximated(parameters.owner() + ", " + type, fmt::format("tubes of {} sides", sides),
                                             parameters.position());
    return finished_mesh(tube(outline), parameters, reversed);
}

}  // namespace lancer::pbrt
