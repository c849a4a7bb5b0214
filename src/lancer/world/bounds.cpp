#include "lancer/world/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lancer/kernel/placed.h"

namespace lancer {

namespace {

struct Bound {
    kernel::Vec3 center;
    float radius;
};

Bound around_box(const kernel::Vec3& low, const kernel::Vec3& high) {
    const kernel::Vec3 center = (low + high) * 0.5f;
    return {center, kernel::length(high - center)};
}

// Of the points middle + (x, y, z) with |x|, |z| <= 1 and |y| <= half: the corners of that box reach farthest.
Bound around_placed(const kernel::PlacedRecord& shape, float middle, float half) {
    Bound bound{kernel::apply_affine(shape.to_world, kernel::vec3_of(0.0f, middle, 0.0f)), 0.0f};
    for (const float x : {-1.0f, 1.0f}) {
        for (const float y : {-half, half}) {
            bound.radius = std::max({bound.radius, kernel::length(kernel::apply_linear(shape.to_world, kernel::vec3_of(x, y, 1.0f))),
                                     kernel::length(kernel::apply_linear(shape.to_world, kernel::vec3_of(x, y, -1.0f)))});
        }
    }
    return bound;
}

Bound around(const World& world, const kernel::ObjectRecord& object) {
    const auto i = static_cast<std::size_t>(object.index);
    switch (object.kind) {
        case kernel::OBJECT_SPHERE:
            return {kernel::broadcast(world.spheres[i].center), world.spheres[i].radius};
        case kernel::OBJECT_BOX:
            return around_box(kernel::broadcast(world.boxes[i].low), kernel::broadcast(world.boxes[i].high));
        case kernel::OBJECT_PLACED_SPHERE:
        case kernel::OBJECT_PLACED_BOX:
            return around_placed(world.placed[i], 0.0f, 1.0f);
        case kernel::OBJECT_PLACED_DISK:
            return around_placed(world.placed[i], 0.0f, 0.0f);
        case kernel::OBJECT_PLACED_CONE:
            return around_placed(world.placed[i], 0.5f, 0.5f);
        case kernel::OBJECT_TRIANGLE: {
            const kernel::Vec3 a = kernel::broadcast(world.triangles[i].a);
            const kernel::Vec3 b = kernel::broadcast(world.triangles[i].b);
            const kernel::Vec3 c = kernel::broadcast(world.triangles[i].c);
            return around_box(kernel::min(kernel::min(a, b), c), kernel::max(kernel::max(a, b), c));
        }
        default:
            return {kernel::vec3_all(0.0f), std::numeric_limits<float>::infinity()};
    }
}

}  // namespace

void compile_bounds(World& world) {
    const auto add = [&](const Bound& bound) {
        world.bound_x.push_back(bound.center.x);
        world.bound_y.push_back(bound.center.y);
        world.bound_z.push_back(bound.center.z);
        world.bound_radius.push_back(bound.radius);
    };
    for (const kernel::ObjectRecord& object : world.objects) {
        Bound bound = around(world, object);
        // Thousands of ulps of everything that enters: culling only has to be right, not tight.
        const float room = kernel::ROUNDING * 4096.0f;
        bound.radius += room * (bound.radius + kernel::length(bound.center));
        add(bound);
    }
    while (world.bound_x.size() % 16 != 0) {
        add({kernel::vec3_all(0.0f), -std::numeric_limits<float>::infinity()});
    }
}

}  // namespace lancer
