#include "lancer/trace/tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "lancer/base/failure.h"
#include "lancer/kernel/all_objects.h"
#include "lancer/trace/implementation.h"

namespace lancer {

Tree::Implementation::~Implementation() {
    for (RTCScene mesh : mesh_scenes) {
        rtcReleaseScene(mesh);
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

kernel::Ray ray_of(RTCRayN* rays, unsigned n, unsigned i) {
    return {kernel::vec3_of(RTCRayN_org_x(rays, n, i), RTCRayN_org_y(rays, n, i), RTCRayN_org_z(rays, n, i)),
            kernel::vec3_of(RTCRayN_dir_x(rays, n, i), RTCRayN_dir_y(rays, n, i), RTCRayN_dir_z(rays, n, i)), RTCRayN_tfar(rays, n, i)};
}

void bound_shape(const RTCBoundsFunctionArguments* arguments) {
    const auto& tree = *static_cast<const Implementation*>(arguments->geometryUserPtr);
    *arguments->bounds_o = shape_bounds(tree.world, tree.shapes[arguments->primID]);
}

void intersect_shape(const RTCIntersectFunctionNArguments* arguments) {
    const auto& tree = *static_cast<const Implementation*>(arguments->geometryUserPtr);
    RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, arguments->N);
    RTCHitN* hits = RTCRayHitN_HitN(arguments->rayhit, arguments->N);
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] != -1) {
            continue;
        }
        const kernel::Ray ray = ray_of(rays, arguments->N, i);
        const kernel::TriangleHit hit = shape_hit(tree.world, tree.shapes[arguments->primID], ray);
        // At the same distance the object that the author named first is in front, in whatever order the tree asks.
        const bool first_of_equals = hit.t == ray.reach && RTCHitN_geomID(hits, arguments->N, i) == arguments->geomID &&
                                     arguments->primID < RTCHitN_primID(hits, arguments->N, i);
        if (hit.t < ray.reach || first_of_equals) {
            RTCRayN_tfar(rays, arguments->N, i) = hit.t;
            RTCHitN_u(hits, arguments->N, i) = hit.u;
            RTCHitN_v(hits, arguments->N, i) = hit.v;
            RTCHitN_geomID(hits, arguments->N, i) = arguments->geomID;
            RTCHitN_primID(hits, arguments->N, i) = arguments->primID;
            RTCHitN_instID(hits, arguments->N, i, 0) = RTC_INVALID_GEOMETRY_ID;
        }
    }
}

void occlude_shape(const RTCOccludedFunctionNArguments* arguments) {
    const auto& tree = *static_cast<const Implementation*>(arguments->geometryUserPtr);
    for (unsigned i = 0; i < arguments->N; ++i) {
        if (arguments->valid[i] != -1) {
            continue;
        }
        const kernel::Ray ray = ray_of(arguments->ray, arguments->N, i);
        if (shape_hit(tree.world, tree.shapes[arguments->primID], ray).t < ray.reach) {
            RTCRayN_tfar(arguments->ray, arguments->N, i) = -std::numeric_limits<float>::infinity();
        }
    }
}

RTCScene build_mesh(RTCDevice device, const World& world, const kernel::MeshRecord& mesh) {
    RTCScene scene = rtcNewScene(device);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    // The last position of all is padding.
    const std::size_t vertices = world.positions.size() - static_cast<std::size_t>(mesh.first_vertex) - 1;
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, world.positions.data(),
                               static_cast<std::size_t>(mesh.first_vertex) * sizeof(kernel::vec3), sizeof(kernel::vec3), vertices);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, world.indices.data(),
                               static_cast<std::size_t>(mesh.first_triangle) * 3 * sizeof(int), 3 * sizeof(int),
                               static_cast<std::size_t>(mesh.triangle_count));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
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
    rtcSetGeometryBoundsFunction(geometry, [](const RTCBoundsFunctionArguments* a) { bound_shape(a); }, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect_shape);
    rtcSetGeometryOccludedFunction(geometry, occlude_shape);
    rtcCommitGeometry(geometry);
    tree.shapes_geometry = rtcAttachGeometry(tree.scene, geometry);
    tree.objects_of_geometry.resize(tree.shapes_geometry + 1, -1);
    rtcReleaseGeometry(geometry);
}

void add_instances(Implementation& tree, const World& world) {
    for (const kernel::MeshRecord& mesh : world.meshes) {
        tree.mesh_scenes.push_back(build_mesh(tree.device, world, mesh));
    }
    for (std::size_t i = 0; i < world.objects.size(); ++i) {
        if (world.objects[i].kind != kernel::OBJECT_MESH) {
            continue;
        }
        const kernel::InstanceRecord& instance = world.instances[static_cast<std::size_t>(world.objects[i].index)];
        RTCGeometry geometry = rtcNewGeometry(tree.device, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(geometry, tree.mesh_scenes[static_cast<std::size_t>(instance.mesh)]);
        const kernel::AffineRecord& m = instance.to_world;
        const float rows[12] = {m.row_x.x, m.row_x.y, m.row_x.z, m.shift.x, m.row_y.x, m.row_y.y,
                                m.row_y.z, m.shift.y, m.row_z.x, m.row_z.y, m.row_z.z, m.shift.z};
        rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_ROW_MAJOR, rows);
        rtcCommitGeometry(geometry);
        const unsigned id = rtcAttachGeometry(tree.scene, geometry);
        tree.objects_of_geometry.resize(std::max<std::size_t>(tree.objects_of_geometry.size(), id + 1), -1);
        tree.objects_of_geometry[id] = static_cast<int>(i);
        rtcReleaseGeometry(geometry);
    }
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
    add_instances(tree, world);
    rtcCommitScene(tree.scene);
    check(tree.device);
}

Tree::~Tree() = default;

}  // namespace lancer
