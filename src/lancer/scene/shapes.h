// Shapes, each in its own object space, where they are placed, and groups of them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/base/diagnostic.h"

namespace lancer::scene {

struct Sphere {
    glm::dvec3 center{0.0};
    double radius = 1.0;
};

struct Box {
    glm::dvec3 min{-0.5};
    glm::dvec3 max{0.5};
};

struct Plane {  // infinite
    glm::dvec3 point{0.0};
    glm::dvec3 normal{0.0, 1.0, 0.0};
};

struct Disk {
    glm::dvec3 center{0.0};
    glm::dvec3 normal{0.0, 1.0, 0.0};
    double radius = 1.0;
};

struct Cylinder {
    glm::dvec3 from{0.0};
    glm::dvec3 to{0.0, 1.0, 0.0};
    double radius = 0.5;
    bool capped = true;
};

struct Cone {  // a cone, or a truncated one when `top_radius` is not 0
    glm::dvec3 from{0.0};
    glm::dvec3 to{0.0, 1.0, 0.0};
    double radius = 0.5;      // at `from`
    double top_radius = 0.0;  // at `to`
    bool capped = true;
};

// Triangles, counter-clockwise seen from outside. What belongs to vertices is empty or as long as `positions`.
struct TriangleMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uvs;
    std::vector<glm::uvec3> triangles;
    std::vector<glm::vec2> second_uvs = {};
    std::vector<glm::vec4> tangents = {};     // where u grows, of length 1; w is 1 or -1: v grows along w * cross(normal, tangent)
    std::vector<glm::vec4> colors = {};       // linear RGB and alpha
    std::vector<glm::vec4> face_colors = {};  // of each triangle, or empty
};

// The data of a mesh is shared by all its placements.
struct Mesh {
    std::shared_ptr<const TriangleMesh> data;
    bool smooth = true;  // use the vertex normals where there are any
};

using Shape = std::variant<Sphere, Box, Plane, Disk, Cylinder, Cone, Mesh>;

struct Object {
    std::string name;
    Shape shape;
    int material = 0;  // index into Scene::materials
    glm::dmat4 to_parent{1.0};
    SourcePosition position;
};

struct Placement {
    int group = 0;  // index into Scene::groups; smaller than the index of the group that contains this placement
    glm::dmat4 to_parent{1.0};
    std::optional<int> material;  // replaces the materials of everything placed
    SourcePosition position;
};

struct Group {
    std::string name;
    std::vector<Object> objects;
    std::vector<Placement> placements;
};

}  // namespace lancer::scene
