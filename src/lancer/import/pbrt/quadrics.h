// Surfaces that a curve sweeps about z, as triangles with the true normals: for parts of spheres, disks with a hole and the like.
#pragma once

#include <functional>

#include <glm/vec3.hpp>

#include "lancer/scene/shapes.h"

namespace lancer::pbrt {

struct Sweep {
    // The point at v, 0 to 1, before the sweep, and the direction in which it changes with v there, of any length but 0.
    std::function<glm::dvec3(double)> point;
    std::function<glm::dvec3(double)> along;
    double degrees = 360.0;
    int steps = 1;  // along v
};

// Counter-clockwise where (direction of the sweep) x (direction of v) points; u runs with the sweep.
scene::TriangleMesh swept_mesh(const Sweep& sweep);

Sweep sphere_sweep(double radius, double low, double high, double degrees);
Sweep cone_sweep(double radius, double low, double other_radius, double high, double degrees);  // cylinders and disks, too
Sweep paraboloid_sweep(double radius, double low, double high, double degrees);
Sweep hyperboloid_sweep(const glm::dvec3& one, const glm::dvec3& other, double degrees);

}  // namespace lancer::pbrt
