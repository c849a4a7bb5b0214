#include "lancer/import/pbrt/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "lancer/import/pbrt/curves.h"
#include "lancer/import/pbrt/meshes.h"
#include "lancer/import/pbrt/quadrics.h"
#include "lancer/import/pbrt/transforms.h"

namespace lancer::pbrt {

namespace {

std::optional<BuiltShape> as_shape(const SharedMesh& mesh) {
    return mesh ? std::optional(BuiltShape{scene::Mesh{mesh, true}, glm::dmat4(1.0)}) : std::nullopt;
}

std::optional<BuiltShape> tessellated(const Parameters& parameters, const Sweep& sweep, bool reversed, bool exact = false) {
    if (!exact) {
        parameters.context().report.approximated(parameters.owner(), "triangles, with the normals of the round shape",
                                                 parameters.position());
    }
    return as_shape(finished_mesh(swept_mesh(sweep), parameters, reversed));
}

// Positive, or an error.
std::optional<double> read_extent(const Parameters& parameters, std::string_view name, double otherwise) {
    const double value = parameters.number(name, otherwise);
    if (value > 0.0) {
        return value;
    }
    if (const Parameter* parameter = parameters.find(name)) {
        parameters.error(*parameter, fmt::format("\"{}\" must be above 0", name));
    }
    return std::nullopt;
}

std::optional<BuiltShape> build_sphere(const Parameters& parameters, bool reversed) {
    const auto radius = read_extent(parameters, "radius", 1.0);
    if (!radius) {
        return std::nullopt;
    }
    const double r = *radius;
    const double one = std::clamp(parameters.number("zmin", -r), -r, r), other = std::clamp(parameters.number("zmax", r), -r, r);
    const double low = std::min(one, other), high = std::max(one, other);
    const double sweep = std::clamp(parameters.number("phimax", 360.0), 0.0, 360.0);
    if (low <= -r && high >= r && sweep >= 360.0 && !reversed) {
        // The poles of our spheres' texture lie on y and its seam on -z, theirs on z and +x.
        const glm::dmat4 to_object(glm::dvec4(0, -1, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, 0, 0, 1));
        return BuiltShape{scene::Sphere{glm::dvec3(0.0), r}, to_object};
    }
    return tessellated(parameters, sphere_sweep(r, low, high, sweep), reversed);
}

std::optional<BuiltShape> build_cylinder(const Parameters& parameters, bool reversed) {
    const auto radius = read_extent(parameters, "radius", 1.0);
    if (!radius) {
        return std::nullopt;
    }
    const double one = parameters.number("zmin", -1.0), other = parameters.number("zmax", 1.0);
    const double sweep = std::clamp(parameters.number("phimax", 360.0), 0.0, 360.0);
    if (sweep >= 360.0 && one != other && !reversed) {
        return BuiltShape{scene::Cylinder{{0, 0, std::min(one, other)}, {0, 0, std::max(one, other)}, *radius, false}, glm::dmat4(1.0)};
    }
    return tessellated(parameters, cone_sweep(*radius, std::min(one, other), *radius, std::max(one, other), sweep), reversed);
}

std::optional<BuiltShape> build_disk(const Parameters& parameters, bool reversed) {
    const auto radius = read_extent(parameters, "radius", 1.0);
    if (!radius) {
        return std::nullopt;
    }
    const double height = parameters.number("height", 0.0);
    const double hole = parameters.number("innerradius", 0.0);
    const double sweep = std::clamp(parameters.number("phimax", 360.0), 0.0, 360.0);
    if (sweep >= 360.0 && hole <= 0.0) {
        return BuiltShape{scene::Disk{{0, 0, height}, {0, 0, reversed ? -1 : 1}, *radius}, glm::dmat4(1.0)};
    }
    return tessellated(parameters, cone_sweep(*radius, height, std::max(hole, 0.0), height, sweep), reversed);
}

// Of version 3, as are paraboloids and hyperboloids.
std::optional<BuiltShape> build_cone(const Parameters& parameters, bool reversed) {
    const auto radius = read_extent(parameters, "radius", 1.0);
    const auto height = read_extent(parameters, "height", 1.0);
    if (!radius || !height) {
        return std::nullopt;
    }
    const double sweep = std::clamp(parameters.number("phimax", 360.0), 0.0, 360.0);
    if (sweep >= 360.0 && !reversed) {
        return BuiltShape{scene::Cone{{0, 0, 0}, {0, 0, *height}, *radius, 0.0, false}, glm::dmat4(1.0)};
    }
    return tessellated(parameters, cone_sweep(*radius, 0.0, 0.0, *height, sweep), reversed);
}

std::optional<BuiltShape> build_paraboloid(const Parameters& parameters, bool reversed) {
    const auto radius = read_extent(parameters, "radius", 1.0);
    if (!radius) {
        return std::nullopt;
    }
    const double low = parameters.number("zmin", 0.0), high = parameters.number("zmax", 1.0);
    const double sweep = std::clamp(parameters.number("phimax", 360.0), 0.0, 360.0);
    return tessellated(parameters, paraboloid_sweep(*radius, std::min(low, high), std::max(low, high), sweep), reversed);
}

std::optional<BuiltShape> build_hyperboloid(const Parameters& parameters, bool reversed) {
    const glm::dvec3 one = parameters.triple("p1").value_or(glm::dvec3(0.0));
    const glm::dvec3 other = parameters.triple("p2").value_or(glm::dvec3(1.0));
    const double sweep = std::clamp(parameters.number("phimax", 360.0), 0.0, 360.0);
    return tessellated(parameters, hyperboloid_sweep(one, other, sweep), reversed);
}

}  // namespace

std::optional<BuiltShape> build_shape(const Parameters& parameters, const std::string& type, bool reversed) {
    if (type == "trianglemesh") {
        return as_shape(read_triangle_mesh(parameters, reversed));
    }
    if (type == "plymesh") {
        return as_shape(read_ply_mesh(parameters, reversed));
    }
    if (type == "bilinearmesh") {
        return as_shape(read_bilinear_mesh(parameters, reversed));
    }
    if (type == "loopsubdiv") {
        return as_shape(read_subdivision(parameters, reversed));
    }
    if (type == "curve") {
        return as_shape(read_curve_mesh(parameters, reversed));
    }
    if (type == "sphere") {
        return build_sphere(parameters, reversed);
    }
    if (type == "cylinder") {
        return build_cylinder(parameters, reversed);
    }
    if (type == "disk") {
        return build_disk(parameters, reversed);
    }
    if (type == "cone") {
        return build_cone(parameters, reversed);
    }
    if (type == "paraboloid") {
        return build_paraboloid(parameters, reversed);
    }
    if (type == "hyperboloid") {
        return build_hyperboloid(parameters, reversed);
    }
    parameters.context().report.dropped(parameters.owner(), "this shape is not known", parameters.position());
    return std::nullopt;
}

double surface_area(const scene::Shape& shape, const glm::dmat4& to_world) {
    using std::numbers::pi;
    // For round shapes under a map that keeps angles; a stretched one is near it.
    const double scale = std::pow(std::abs(glm::determinant(glm::dmat3(to_world))), 2.0 / 3.0);
    if (const auto* sphere = std::get_if<scene::Sphere>(&shape)) {
        return 4.0 * pi * sphere->radius * sphere->radius * scale;
    }
    if (const auto* disk = std::get_if<scene::Disk>(&shape)) {
        return pi * disk->radius * disk->radius * scale;
    }
    if (const auto* cylinder = std::get_if<scene::Cylinder>(&shape)) {
        return 2.0 * pi * cylinder->radius * glm::distance(cylinder->from, cylinder->to) * scale;
    }
    if (const auto* cone = std::get_if<scene::Cone>(&shape)) {
        return pi * cone->radius * std::hypot(cone->radius, glm::distance(cone->from, cone->to)) * scale;
    }
    double area = 0.0;
    if (const auto* mesh = std::get_if<scene::Mesh>(&shape)) {
        for (const glm::uvec3& t : mesh->data->triangles) {
            const glm::dvec3 a = apply_to_point(to_world, glm::dvec3(mesh->data->positions[t.x]));
            const glm::dvec3 b = apply_to_point(to_world, glm::dvec3(mesh->data->positions[t.y]));
            const glm::dvec3 c = apply_to_point(to_world, glm::dvec3(mesh->data->positions[t.z]));
            area += 0.5 * glm::length(glm::cross(b - a, c - a));
        }
    }
    return area;
}

}  // namespace lancer::pbrt
