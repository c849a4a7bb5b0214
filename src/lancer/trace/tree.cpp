#include "lancer/trace/tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "lancer/base/failure.h"
#include "lancer/kernel/all_objects.h"
#include "lancer/trace/first_hit.h"
#include "lancer/trace/implementation.h"

namespace lancer {

Tree::Implementation::~Implementation() {
    for (RTCScene mesh : mesh_scenes) {
        if (mesh != nullptr) {
            rtcReleaseScene(mesh);
        }
    }
    if (scene != nullptr) {
        rtcReleaseScene(scene);
    }
    if (device != nullptr) {
        rtcReleaseDevice(device);
    }
}

namespace {

using Implementation = Tree::Implementation;

void check(RTCDevice device) {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_OUT_OF_MEMORY) {
        throw MachineFailure("out of memory while building the tree of the scene");
    }
    if (error != RTC_ERROR_NONE) {
        throw MachineFailure("Embree failed while building the tree of the scene (error " + std::to_string(error) + ")");
    }
}

// The tree's own arithmetic rounds too: bounds are widened by some dozens of ulps of the largest coordinate, or it would skip shapes that are
// hit at their very rim.
void widen(RTCBounds& bounds) {
    float largest = 0.0f;
    for (const float x : {bounds.lower_x, bounds.lower_y, bounds.lower_z, bounds.upper_x, bounds.upper_y, bounds.upper_z}) {
        largest = std::max(largest, std::abs(x));
    }
    const float margin = largest * 64.0f * kernel::ROUNDING;
    bounds.lower_x -= margin;
    bounds.lower_y -= margin;
    bounds.lower_z -= margin;
    bounds.upper_x += margin;
    bounds.upper_y += margin;
    bounds.upper_z += margin;
}

RTCBounds bounds_between(const kernel::Vec3& low, const kernel::Vec3& high) {
    RTCBounds bounds{};
    bounds.lower_x = low.x;
    bounds.lower_y = low.y;
    bounds.lower_z = low.z;
    bounds.upper_x = high.x;
    bounds.upper_y = high.y;
    bounds.upper_z = high.z;
    widen(bounds);
    return bounds;
}

// A canonical shape lies between -1 and 1 in x and z, and in y between -1 and 1, at 0, or between 0 and 1.
RTCBounds placed_bounds(const kernel::PlacedRecord& shape, int kind) {
    const bool is_cone = kind == kernel::OBJECT_PLACED_CONE;
    const bool is_disk = kind == kernel::OBJECT_PLACED_DISK;
    const kernel::Vec3 middle = kernel::vec3_of(0.0f, is_cone ? 0.5f : 0.0f, 0.0f);
    const kernel::Vec3 half = kernel::vec3_of(1.0f, is_cone ? 0.5f : is_disk ? 0.0f : 1.0f, 1.0f);
    const kernel::Vec3 center = kernel::apply_affine(shape.to_world, middle);
    const kernel::Vec3 reach = kernel::reach_linear(shape.to_world, half);
    return bounds_between(center - reach, center + reach);
}

RTCBounds shape_bounds(const kernel::WorldRecord& world, int number) {
    const kernel::ObjectRecord& object = world.objects[number];
    if (object.kind == kernel::OBJECT_SPHERE) {
        const kernel::SphereRecord& sphere = world.spheres[object.index];
        const kernel::Vec3 center = kernel::broadcast(sphere.center);
        return bounds_between(center - kernel::vec3_all(sphere.radius), center + kernel::vec3_all(sphere.radius));
    }
    if (object.kind == kernel::OBJECT_BOX) {
        return bounds_between(kernel::broadcast(world.boxes[object.index].low), kernel::broadcast(world.boxes[object.index].high));
    }
    if (object.kind == kernel::OBJECT_TRIANGLE) {
        const kernel::TriangleRecord& t = world.triangles[object.index];
        const kernel::Vec3 a = kernel::broadcast(t.a), b = kernel::broadcast(t.b), c = kernel::broadcast(t.c);
        return bounds_between(kernel::min(kernel::min(a, b), c), kernel::max(kernel::max(a, b), c));
    }
    return placed_bounds(world.placed[object.index], object.kind);
}

// The kernel's answer for one shape and one ray.
kernel::TriangleHit shape_hit(const kernel::WorldRecord& world, int number, const kernel::Ray& ray) {
    const kernel::ObjectRecord& object = world.objects[number];
    kernel::TriangleHit hit{kernel::FAR, 0.0f, 0.0f};
    if (object.kind == kernel::OBJECT_SPHERE) {
        hit.t = kernel::sphere_distance(world.spheres[object.index], ray, true);
    } else if (object.kind == kernel::OBJECT_BOX) {
        hit.t = kernel::box_distance(world.boxes[object.index], ray, kernel::slab_reciprocal(ray.direction));
    } else if (object.kind == kernel::OBJECT_TRIANGLE) {
        const kernel::TriangleRecord& t = world.triangles[object.index];
        hit = kernel::triangle_hit(kernel::broadcast(t.a), kernel::broadcast(t.b), kernel::broadcast(t.c), ray);
    } else {
        hit.t = kernel::placed_distance(world.placed[object.index], object.kind, ray);
    }
    return hit;
}

void bound_shape(const RTCBoundsFunctionArguments* arguments) {
    const auto& tree = *static_cast<const Implementation*>(arguments->geometryUserPtr);
    *arguments->bounds_o = shape_bounds(tree.world, tree.shapes[arguments->primID]);
}

const TraceContext& context_of(const RTCIntersectContext* context) { return *reinterpret_cast<const TraceContext*>(context); }

void intersect_shape(const RTCIntersectFunctionNArguments* arguments) {
    const auto& tree = *static_cast<const Implementation*>(arguments->geometryUserPtr);
    TracePacket& packet = *context_of(arguments->context).packet;
    RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, arguments->N);
    const int number = tree.shapes[arguments->primID];
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] != -1) {
            continue;
        }
        const int lane = static_cast<int>(RTCRayN_id(rays, arguments->N, i));
        if (keep_first(packet, lane, number, tree.world.objects[number].sub, shape_hit(tree.world, number, lane_ray(packet, lane)))) {
            float& far = RTCRayN_tfar(rays, arguments->N, i);
            far = std::min(far, first_known(packet, lane));  // a triangle may be nearer
        }
    }
}

void occlude_shape(const RTCOccludedFunctionNArguments* arguments) {
    const auto& tree = *static_cast<const Implementation*>(arguments->geometryUserPtr);
    const TracePacket& packet = *context_of(arguments->context).packet;
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] != -1) {
            continue;
        }
        const kernel::Ray ray = lane_ray(packet, static_cast<int>(RTCRayN_id(arguments->ray, arguments->N, i)));
        if (shape_hit(tree.world, tree.shapes[arguments->primID], ray).t < ray.reach) {
            RTCRayN_tfar(arguments->ray, arguments->N, i) = -std::numeric_limits<float>::infinity();
        }
    }
}

// Calls `decide(place, lane, object, part, hit)` for each triangle that Embree found, and refuses those for which it says no.
template <class Decide>
void filter_triangles(const RTCFilterFunctionNArguments* arguments, const Decide& decide) {
    const TraceContext& context = context_of(arguments->context);
    const kernel::WorldRecord& world = *context.world;
    const Implementation& tree = reinterpret_cast<const Tree*>(world.tree)->implementation();
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] != -1) {
            continue;
        }
        const int lane = static_cast<int>(RTCRayN_id(arguments->ray, arguments->N, i));
        const int object = tree.objects_of_geometry[RTCHitN_instID(arguments->hit, arguments->N, i, 0)];
        const int part = static_cast<int>(RTCHitN_primID(arguments->hit, arguments->N, i));
        const kernel::TriangleHit hit = mesh_hit(world, object, part, RTCHitN_u(arguments->hit, arguments->N, i),
                                                 RTCHitN_v(arguments->hit, arguments->N, i), lane_ray(*context.packet, lane));
        if (!decide(i, lane, object, part, hit)) {
            arguments->valid[i] = 0;
        }
    }
}

void choose_triangle(const RTCFilterFunctionNArguments* arguments) {
    TracePacket& packet = *context_of(arguments->context).packet;
    filter_triangles(arguments, [&](unsigned i, int lane, int object, int part, const kernel::TriangleHit& hit) {
        const bool is_first = hit.t < kernel::FAR && keep_first(packet, lane, object, part, hit);
        if (is_first) {
            RTCRayN_tfar(arguments->ray, arguments->N, i) = first_known(packet, lane);
        }
        return is_first;
    });
}

void confirm_triangle(const RTCFilterFunctionNArguments* arguments) {
    const TracePacket& packet = *context_of(arguments->context).packet;
    filter_triangles(arguments, [&](unsigned, int lane, int, int, const kernel::TriangleHit& hit) { return hit.t < packet.reach[lane]; });
}

void set_indices(RTCGeometry geometry, const World& world, const kernel::MeshRecord& mesh) {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, world.indices.data(),
                               static_cast<std::size_t>(mesh.first_triangle) * 3 * sizeof(int), 3 * sizeof(int),
                               static_cast<std::size_t>(mesh.triangle_count));
}

// As it was written.
RTCGeometry mesh_geometry(RTCDevice device, const World& world, const kernel::MeshRecord& mesh) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    // The last position of all is padding.
    const std::size_t vertices = world.positions.size() - static_cast<std::size_t>(mesh.first_vertex) - 1;
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, world.positions.data(),
                               static_cast<std::size_t>(mesh.first_vertex) * sizeof(kernel::vec3), sizeof(kernel::vec3), vertices);
    set_indices(geometry, world, mesh);
    return geometry;
}

// In world space, its corners those that the kernel compares with.
RTCGeometry placed_mesh_geometry(RTCDevice device, const World& world, const kernel::MeshRecord& mesh,
                                 const kernel::AffineRecord& to_world) {
    const auto corners = world.indices.begin() + 3 * static_cast<std::ptrdiff_t>(mesh.first_triangle);
    const int last = *std::max_element(corners, corners + 3 * static_cast<std::ptrdiff_t>(mesh.triangle_count));
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const places = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                     sizeof(kernel::vec3), static_cast<std::size_t>(last) + 1));
    if (places == nullptr) {
        throw MachineFailure("out of memory while building the tree of the scene");
    }
    for (int i = 0; i <= last; ++i) {
        const kernel::Vec3 p =
            kernel::apply_affine(to_world, kernel::broadcast(world.positions[static_cast<std::size_t>(mesh.first_vertex + i)]));
        places[3 * i] = p.x;
        places[3 * i + 1] = p.y;
        places[3 * i + 2] = p.z;
    }
    set_indices(geometry, world, mesh);
    return geometry;
}

// A mesh that instances place, its distances measured by the kernel: Embree's are those of rays that were turned into its space.
RTCScene build_mesh(RTCDevice device, const World& world, const kernel::MeshRecord& mesh) {
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = mesh_geometry(device, world, mesh);
    rtcSetGeometryIntersectFilterFunction(geometry, choose_triangle);
    rtcSetGeometryOccludedFilterFunction(geometry, confirm_triangle);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
}

bool is_identity(const kernel::AffineRecord& m) {
    return m.row_x == kernel::vec3(1, 0, 0) && m.row_y == kernel::vec3(0, 1, 0) && m.row_z == kernel::vec3(0, 0, 1) &&
           m.shift == kernel::vec3(0);
}

void add_shapes(Implementation& tree, const World& world) {
    for (std::size_t i = 0; i < world.objects.size(); ++i) {
        if (world.objects[i].kind != kernel::OBJECT_PLANE && world.objects[i].kind != kernel::OBJECT_MESH) {
            tree.shapes.push_back(static_cast<int>(i));
        }
    }
    if (tree.shapes.empty()) {
        return;
    }
    RTCGeometry geometry = rtcNewGeometry(tree.device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(tree.shapes.size()));
    rtcSetGeometryUserData(geometry, &tree);
    rtcSetGeometryBoundsFunction(
        geometry, [](const RTCBoundsFunctionArguments* a) { bound_shape(a); }, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect_shape);
    rtcSetGeometryOccludedFunction(geometry, occlude_shape);
    rtcCommitGeometry(geometry);
    tree.shapes_geometry = rtcAttachGeometry(tree.scene, geometry);
    tree.objects_of_geometry.resize(tree.shapes_geometry + 1, -1);
    rtcReleaseGeometry(geometry);
}

void attach(Implementation& tree, RTCGeometry geometry, std::size_t object) {
    rtcCommitGeometry(geometry);
    const unsigned id = rtcAttachGeometry(tree.scene, geometry);
    tree.objects_of_geometry.resize(std::max<std::size_t>(tree.objects_of_geometry.size(), id + 1), -1);
    tree.objects_of_geometry[id] = static_cast<int>(object);
    rtcReleaseGeometry(geometry);
}

// Meshes that stand where they were written, or are placed once, are part of the tree itself.
void add_meshes(Implementation& tree, const World& world) {
    tree.mesh_scenes.resize(world.meshes.size(), nullptr);
    std::vector<int> uses(world.meshes.size(), 0);
    for (const kernel::InstanceRecord& instance : world.instances) {
        ++uses[static_cast<std::size_t>(instance.mesh)];
    }
    for (std::size_t i = 0; i < world.objects.size(); ++i) {
        if (world.objects[i].kind != kernel::OBJECT_MESH) {
            continue;
        }
        const kernel::InstanceRecord& instance = world.instances[static_cast<std::size_t>(world.objects[i].index)];
        const kernel::MeshRecord& mesh = world.meshes[static_cast<std::size_t>(instance.mesh)];
        const kernel::AffineRecord& m = instance.to_world;
        if (is_identity(m)) {
            attach(tree, mesh_geometry(tree.device, world, mesh), i);
            continue;
        }
        if (uses[static_cast<std::size_t>(instance.mesh)] == 1) {
            attach(tree, placed_mesh_geometry(tree.device, world, mesh, m), i);
            continue;
        }
        RTCScene& mesh_scene = tree.mesh_scenes[static_cast<std::size_t>(instance.mesh)];
        if (mesh_scene == nullptr) {
            mesh_scene = build_mesh(tree.device, world, mesh);
        }
        RTCGeometry geometry = rtcNewGeometry(tree.device, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(geometry, mesh_scene);
        const float rows[12] = {m.row_x.x, m.row_x.y, m.row_x.z, m.shift.x, m.row_y.x, m.row_y.y,
                                m.row_y.z, m.shift.y, m.row_z.x, m.row_z.y, m.row_z.z, m.shift.z};
        rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_ROW_MAJOR, rows);
        attach(tree, geometry, i);
    }
}

// Far from the origin Embree's quick tests of boxes lose more to rounding than there is between things.
bool is_far_away(RTCScene scene) {
    RTCBounds b{};
    rtcGetSceneBounds(scene, &b);
    const float size = std::max({b.upper_x - b.lower_x, b.upper_y - b.lower_y, b.upper_z - b.lower_z});
    const float farthest = std::max(
        {std::abs(b.lower_x), std::abs(b.lower_y), std::abs(b.lower_z), std::abs(b.upper_x), std::abs(b.upper_y), std::abs(b.upper_z)});
    return farthest > 16.0f * size;
}

}  // namespace

Tree::Tree(const World& world, int threads) : implementation_(std::make_unique<Implementation>()) {
    Implementation& tree = *implementation_;
    tree.world = world.record();
    tree.device = rtcNewDevice(threads > 0 ? ("threads=" + std::to_string(threads)).c_str() : nullptr);
    if (tree.device == nullptr) {
        throw MachineFailure("Embree could not start on this machine (error " + std::to_string(rtcGetDeviceError(nullptr)) + ")");
    }
    tree.scene = rtcNewScene(tree.device);
    add_shapes(tree, world);
    add_meshes(tree, world);
    rtcCommitScene(tree.scene);
    if (is_far_away(tree.scene)) {
        rtcSetSceneFlags(tree.scene, RTC_SCENE_FLAG_ROBUST);
        rtcCommitScene(tree.scene);
    }
    check(tree.device);
}

Tree::~Tree() = default;

}  // namespace lancer
