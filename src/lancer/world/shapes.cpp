#include "lancer/world/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "lancer/kernel/placed.h"

namespace lancer {

namespace {

using kernel::ObjectRecord;

// Meshes with at most so many triangles in the whole scene are tested triangle by triangle, like any shape.
constexpr std::size_t loose_triangles = 56;

kernel::AffineRecord to_record(const glm::dmat4& m) {
    const auto row = [&](int i) { return kernel::vec3(glm::dvec3(m[0][i], m[1][i], m[2][i])); };
    return {row(0), row(1), row(2), kernel::vec3(glm::dvec3(m[3]))};
}

glm::dmat4 from_columns(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z, const glm::dvec3& shift) {
    return glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(shift, 1.0));
}

// Two directions of length 1 at right angles to `y` and to each other, so that (x, y, z) is right-handed.
std::pair<glm::dvec3, glm::dvec3> across(const glm::dvec3& y) {
    const glm::dvec3 n = glm::normalize(y);
    const glm::dvec3 other = std::abs(n.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 x = glm::normalize(other - n * glm::dot(n, other));
    return {x, glm::cross(x, n)};
}

// Rounding leaves a trace of this size in composed transforms.
bool is_near(double a, double b) { return std::abs(a - b) <= 1e-12 * (std::abs(a) + std::abs(b) + 1e-300); }

bool is_identity(const glm::dmat4& m) { return m == glm::dmat4(1.0); }

bool is_axis_aligned(const glm::dmat4& m) {
    return m[0][1] == 0.0 && m[0][2] == 0.0 && m[1][0] == 0.0 && m[1][2] == 0.0 && m[2][0] == 0.0 && m[2][1] == 0.0;
}

// The scale of a map that keeps angles, or 0.
double similarity_scale(const glm::dmat4& m) {
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    const double xx = glm::dot(x, x);
    const double skew = std::abs(glm::dot(x, y)) + std::abs(glm::dot(y, z)) + std::abs(glm::dot(z, x));
    return is_near(xx, glm::dot(y, y)) && is_near(xx, glm::dot(z, z)) && skew <= 1e-12 * xx ? std::sqrt(xx) : 0.0;
}

class Shapes {
public:
    Shapes(World& world, Diagnostics& diagnostics) : world_(world), diagnostics_(diagnostics) {}

    // `name`: into World::names.
    void add(const FlatObject& flat, int name) {
        name_ = name;
        const double determinant = glm::determinant(glm::dmat3(flat.to_world));
        if (!(std::abs(determinant) > 0.0) || !std::isfinite(determinant)) {
            diagnostics_.error(flat.object->position, "the transforms of this object together squeeze space flat or blow it up");
            return;
        }
        std::visit([&](const auto& shape) { add_shape(shape, flat); }, flat.object->shape);
    }

    // Objects in the order of their kinds; within a kind in the order of the file.
    void finish() {
        std::size_t loose = 0;
        for (const kernel::InstanceRecord& instance : world_.instances) {
            loose += static_cast<std::size_t>(world_.meshes[static_cast<std::size_t>(instance.mesh)].triangle_count);
        }
        if (loose <= loose_triangles) {
            for (std::size_t i = 0; i < world_.instances.size(); ++i) {
                add_triangles(static_cast<int>(i));
            }
        } else {
            for (std::size_t i = 0; i < world_.instances.size(); ++i) {
                by_kind_[kernel::OBJECT_MESH].push_back({kernel::OBJECT_MESH, static_cast<int>(i), instance_materials_[i], 0, 0, 0, -1});
                names_[kernel::OBJECT_MESH].push_back(instance_names_[i]);
            }
        }
        // The table of placed shapes holds several kinds: it is numbered in the order of its objects.
        std::vector<kernel::PlacedRecord> placed;
        for (auto& [kind, objects] : by_kind_) {
            for (ObjectRecord& object : objects) {
                if (kind >= kernel::OBJECT_PLACED_SPHERE && kind <= kernel::OBJECT_PLACED_CONE) {
                    placed.push_back(world_.placed[static_cast<std::size_t>(object.index)]);
                    object.index = static_cast<int>(placed.size()) - 1;
                }
                world_.objects.push_back(object);
            }
        }
        for (const auto& [kind, names] : names_) {
            world_.object_names.insert(world_.object_names.end(), names.begin(), names.end());
        }
        world_.placed = std::move(placed);
        if (!world_.positions.empty()) {
            world_.positions.emplace_back(0.0f);  // Embree reads 16 bytes at each vertex, four past the last one
        }
    }

private:
    bool keeps_own_space(const FlatObject& flat) const {
        const auto material = static_cast<std::size_t>(flat.material);
        const bool mapped = !world_.surfaces.empty() && (world_.surfaces[material].flags & kernel::MATERIAL_MAPPED) != 0;
        return (world_.materials[material].texture >= 0 || mapped) && !is_identity(flat.to_world);
    }

    // Points are drawn from lamps in their canonical space.
    bool shines(const FlatObject& flat) const {
        return !world_.surfaces.empty() && (world_.surfaces[static_cast<std::size_t>(flat.material)].flags & kernel::MATERIAL_EMITS) != 0;
    }

    // Readers refuse such shapes with better words; a scene may have been made by other means.
    bool has_extent(double size, const FlatObject& flat) {
        const bool good = std::isfinite(size) && size > 0.0;
        if (!good) {
            diagnostics_.error(flat.object->position, "this shape has no extent, or one without end");
        }
        return good;
    }

    template <class T>
    void add_record(std::vector<T>& table, int kind, const T& record, int material) {
        by_kind_[kind].push_back({kind, static_cast<int>(table.size()), material, 0, 0, 0, -1});
        names_[kind].push_back(name_);
        table.push_back(record);
    }

    void add_placed(int kind, const FlatObject& flat, const glm::dmat4& to_author, double bottom = 1.0, double top = 1.0,
                    bool capped = true) {
        const glm::dmat4 to_world = flat.to_world * to_author;
        if (!has_extent(std::abs(glm::determinant(glm::dmat3(to_world))), flat)) {
            return;
        }
        kernel::PlacedRecord record{to_record(glm::inverse(to_world)), to_record(to_world),     to_record(to_author),
                                    static_cast<float>(bottom),        static_cast<float>(top), capped ? 1 : 0};
        add_record(world_.placed, kind, record, flat.material);
    }

    void add_shape(const scene::Sphere& sphere, const FlatObject& flat) {
        const double scale = similarity_scale(flat.to_world);
        if (!has_extent(sphere.radius, flat)) {
            return;
        }
        if (scale > 0.0 && !keeps_own_space(flat)) {
            const glm::dvec3 center(flat.to_world * glm::dvec4(sphere.center, 1.0));
            add_record(world_.spheres, kernel::OBJECT_SPHERE, {kernel::vec3(center), static_cast<float>(sphere.radius * scale)},
                       flat.material);
        } else {
            const double r = sphere.radius;
            add_placed(kernel::OBJECT_PLACED_SPHERE, flat, from_columns({r, 0, 0}, {0, r, 0}, {0, 0, r}, sphere.center));
        }
    }

    void add_shape(const scene::Box& box, const FlatObject& flat) {
        const glm::dvec3 size = box.max - box.min;
        if (!has_extent(std::min({size.x, size.y, size.z}), flat)) {
            return;
        }
        if (is_axis_aligned(flat.to_world) && !keeps_own_space(flat) && !shines(flat)) {
            const glm::dvec3 a(flat.to_world * glm::dvec4(box.min, 1.0));
            const glm::dvec3 b(flat.to_world * glm::dvec4(box.max, 1.0));
            add_record(world_.boxes, kernel::OBJECT_BOX, {kernel::vec3(glm::min(a, b)), kernel::vec3(glm::max(a, b))}, flat.material);
        } else {
            const glm::dvec3 h = (box.max - box.min) * 0.5;
            add_placed(kernel::OBJECT_PLACED_BOX, flat, from_columns({h.x, 0, 0}, {0, h.y, 0}, {0, 0, h.z}, (box.min + box.max) * 0.5));
        }
    }

    void add_shape(const scene::Plane& plane, const FlatObject& flat) {
        if (!has_extent(glm::length(plane.normal), flat)) {
            return;
        }
        const glm::dmat3 normal_map = glm::transpose(glm::inverse(glm::dmat3(flat.to_world)));
        const glm::dvec3 normal = glm::normalize(normal_map * plane.normal);
        const glm::dvec3 point(flat.to_world * glm::dvec4(plane.point, 1.0));
        const kernel::PlaneRecord record{kernel::vec3(normal), static_cast<float>(glm::dot(normal, point)),
                                         kernel::vec3(glm::normalize(plane.normal)), to_record(glm::inverse(flat.to_world))};
        add_record(world_.planes, kernel::OBJECT_PLANE, record, flat.material);
    }

    void add_shape(const scene::Disk& disk, const FlatObject& flat) {
        const auto [x, z] = across(disk.normal);
        add_placed(kernel::OBJECT_PLACED_DISK, flat,
                   from_columns(x * disk.radius, glm::normalize(disk.normal), z * disk.radius, disk.center));
    }

    void add_shape(const scene::Cylinder& cylinder, const FlatObject& flat) {
        add_cone(cylinder.from, cylinder.to, cylinder.radius, cylinder.radius, cylinder.capped, flat);
    }

    void add_shape(const scene::Cone& cone, const FlatObject& flat) {
        add_cone(cone.from, cone.to, cone.radius, cone.top_radius, cone.capped, flat);
    }

    void add_cone(const glm::dvec3& from, const glm::dvec3& to, double radius, double top_radius, bool capped, const FlatObject& flat) {
        const auto [x, z] = across(to - from);
        const double unit = std::max(radius, top_radius);
        add_placed(kernel::OBJECT_PLACED_CONE, flat, from_columns(x * unit, to - from, z * unit, from), radius / unit, top_radius / unit,
                   capped);
    }

    void add_shape(const scene::Mesh& mesh, const FlatObject& flat) {
        if (mesh.data->triangles.empty()) {
            return;
        }
        const int number = mesh_number(mesh, flat);
        if (number < 0) {
            return;
        }
        const bool flips = glm::determinant(glm::dmat3(flat.to_world)) < 0.0;
        world_.instances.push_back({to_record(flat.to_world), to_record(glm::inverse(flat.to_world)), number, flips ? 1 : 0});
        instance_materials_.push_back(flat.material);
        instance_names_.push_back(name_);
    }

    // A mesh's data stands in the tables once, smooth or flat.
    int mesh_number(const scene::Mesh& mesh, const FlatObject& flat) {
        const auto key = std::make_pair(mesh.data.get(), mesh.smooth);
        if (const auto known = meshes_.find(key); known != meshes_.end()) {
            return known->second;
        }
        const scene::TriangleMesh& data = *mesh.data;
        const std::size_t largest = static_cast<std::size_t>(std::numeric_limits<int>::max());
        if (world_.positions.size() + data.positions.size() > largest || world_.indices.size() + 3 * data.triangles.size() > largest) {
            diagnostics_.error(flat.object->position, "the scene's meshes together have more than 2147483647 vertices or corners");
            return -1;
        }
        kernel::MeshRecord record{};
        record.first_vertex = static_cast<int>(world_.positions.size());
        record.first_triangle = static_cast<int>(world_.indices.size() / 3);
        record.triangle_count = static_cast<int>(data.triangles.size());
        world_.positions.insert(world_.positions.end(), data.positions.begin(), data.positions.end());
        if (mesh.smooth && !data.normals.empty()) {
            record.flags |= kernel::MESH_HAS_NORMALS;
            append(data.normals, static_cast<std::size_t>(record.first_vertex), world_.normals);
        }
        const auto first_vertex = static_cast<std::size_t>(record.first_vertex);
        record.flags |= append(data.uvs, first_vertex, world_.uvs) ? kernel::MESH_HAS_UVS : 0;
        record.flags |= append(data.second_uvs, first_vertex, world_.second_uvs) ? kernel::MESH_HAS_SECOND_UVS : 0;
        record.flags |= append(data.tangents, first_vertex, world_.tangents) ? kernel::MESH_HAS_TANGENTS : 0;
        record.flags |= append(data.colors, first_vertex, world_.colors) ? kernel::MESH_HAS_COLORS : 0;
        const auto first_triangle = static_cast<std::size_t>(record.first_triangle);
        record.flags |= append(data.face_colors, first_triangle, world_.face_colors) ? kernel::MESH_HAS_FACE_COLORS : 0;
        std::size_t corner = world_.indices.size();
        world_.indices.resize(corner + 3 * data.triangles.size());
        for (const glm::uvec3& triangle : data.triangles) {
            world_.indices[corner++] = static_cast<int>(triangle.x);
            world_.indices[corner++] = static_cast<int>(triangle.y);
            world_.indices[corner++] = static_cast<int>(triangle.z);
        }
        const int number = static_cast<int>(world_.meshes.size());
        world_.meshes.push_back(record);
        meshes_[key] = number;
        return number;
    }

    // Puts what the mesh has of something, if anything, at its place in the table.
    template <class T>
    static bool append(const std::vector<T>& values, std::size_t first, std::vector<T>& table) {
        if (values.empty()) {
            return false;
        }
        table.resize(first);
        table.insert(table.end(), values.begin(), values.end());
        return true;
    }

    // With the kernel's own arithmetic, so that the corners are the very ones that a tree would compare with.
    void add_triangles(int instance) {
        const kernel::InstanceRecord& placed = world_.instances[static_cast<std::size_t>(instance)];
        const kernel::MeshRecord& mesh = world_.meshes[static_cast<std::size_t>(placed.mesh)];
        const auto corner = [&](int triangle, int i) {
            const int vertex = world_.indices[static_cast<std::size_t>(3 * (mesh.first_triangle + triangle) + i)] + mesh.first_vertex;
            const kernel::Vec3 p =
                kernel::apply_affine(placed.to_world, kernel::broadcast(world_.positions[static_cast<std::size_t>(vertex)]));
            return kernel::vec3(p.x, p.y, p.z);
        };
        for (int i = 0; i < mesh.triangle_count; ++i) {
            by_kind_[kernel::OBJECT_TRIANGLE].push_back({kernel::OBJECT_TRIANGLE, static_cast<int>(world_.triangles.size()),
                                                         instance_materials_[static_cast<std::size_t>(instance)], placed.mesh, instance, i,
                                                         -1});
            names_[kernel::OBJECT_TRIANGLE].push_back(instance_names_[static_cast<std::size_t>(instance)]);
            world_.triangles.push_back({corner(i, 0), corner(i, 1), corner(i, 2)});
        }
    }

    World& world_;
    Diagnostics& diagnostics_;
    std::map<int, std::vector<ObjectRecord>> by_kind_;
    std::map<std::pair<const scene::TriangleMesh*, bool>, int> meshes_;
    std::map<int, std::vector<int>> names_;  // of by_kind_'s objects
    std::vector<int> instance_materials_;
    std::vector<int> instance_names_;
    int name_ = 0;  // of the object that is being added
};

}  // namespace

namespace {

// Tables that grow mesh by mesh would be copied again and again.
void make_room_for_meshes(const std::vector<FlatObject>& flat, World& world) {
    std::set<std::pair<const scene::TriangleMesh*, bool>> seen;
    std::size_t vertices = 0, normals = 0, uvs = 0, triangles = 0;
    for (const FlatObject& object : flat) {
        const auto* mesh = std::get_if<scene::Mesh>(&object.object->shape);
        if (mesh == nullptr || !seen.insert({mesh->data.get(), mesh->smooth}).second) {
            continue;
        }
        // Where a mesh has none of something its place is left free.
        normals = mesh->smooth && !mesh->data->normals.empty() ? vertices + mesh->data->normals.size() : normals;
        uvs = mesh->data->uvs.empty() ? uvs : vertices + mesh->data->uvs.size();
        vertices += mesh->data->positions.size();
        triangles += mesh->data->triangles.size();
    }
    world.positions.reserve(vertices + 1);  // see Shapes::finish
    world.normals.reserve(normals);
    world.uvs.reserve(uvs);
    world.indices.reserve(3 * triangles);
}

}  // namespace

void compile_shapes(const std::vector<FlatObject>& flat, World& world, Diagnostics& diagnostics) {
    make_room_for_meshes(flat, world);
    Shapes shapes(world, diagnostics);
    for (std::size_t i = 0; i < flat.size(); ++i) {
        shapes.add(flat[i], static_cast<int>(i));
    }
    shapes.finish();
}

}  // namespace lancer
