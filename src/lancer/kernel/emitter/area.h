// Points of lamps, drawn over their area.
#ifndef LANCER_KERNEL_EMITTER_AREA_H
#define LANCER_KERNEL_EMITTER_AREA_H

#include "lancer/kernel/distribution.h"
#include "lancer/kernel/surface.h"
#include "lancer/kernel/warp.h"

NAMESPACE_BEGIN

// |det M| |M^-T n| / |n|: how the area around a point of a canonical shape grows in the world.
FN Float area_growth(IN(PlacedRecord) shape, Vec3 canonical_normal) {
    vec3 a = shape.to_world.row_x;
    vec3 b = shape.to_world.row_y;
    vec3 c = shape.to_world.row_z;
    Vec3 across = cross(broadcast(b), broadcast(c));
    Float determinant = abs(dot(broadcast(a), across));
    Vec3 n = apply_transposed(shape.to_object, canonical_normal);
    return determinant * length(n) / length(canonical_normal);
}

// The areas around points of the three pairs of faces of a box.
FN Vec3 face_growths(IN(PlacedRecord) shape) {
    Float one = Float(1.0f);
    Float none = Float(0.0f);
    return vec3_of(area_growth(shape, vec3_of(one, none, none)), area_growth(shape, vec3_of(none, one, none)),
                   area_growth(shape, vec3_of(none, none, one)));
}

// Its coordinates for textures are found only where the lamp has one.
struct AreaPoint {
    SurfacePoint at;
    Float density;  // per square metre in the world
};

// Of canonical shapes, in their own space: spheres and disks of radius 1, boxes of edge 2, cones of height 1.
FN AreaPoint placed_point(IN(PlacedRecord) shape, int kind, IN(EmitterRecord) emitter, Vec2 u) {
    Vec3 p = vec3_all(Float(0.0f));
    Vec3 n = vec3_of(Float(0.0f), Float(1.0f), Float(0.0f));
    Float density = Float(1.0f / emitter.area);
    if (kind == OBJECT_PLACED_SPHERE) {
        p = on_sphere(u);
        n = p;
    } else if (kind == OBJECT_PLACED_DISK) {
        Vec2 q = on_disk(u);
        p = vec3_of(q.x, Float(0.0f), q.y);
    } else if (kind == OBJECT_PLACED_BOX) {
        // The faces by their area in the world.
        Vec3 grown = face_growths(shape);
        Float sum = grown.x + grown.y + grown.z;
        Float place = u.x * sum;
        Mask on_x = place < grown.x;
        Mask on_y = without(place < grown.x + grown.y, on_x);
        Float first = select(on_x, place / grown.x, select(on_y, (place - grown.x) / grown.y, (place - grown.x - grown.y) / grown.z));
        Float twice = min(first, Float(0.99999994f)) * Float(2.0f);
        Float side = select(twice < Float(1.0f), Float(-1.0f), Float(1.0f));
        Float a = select(twice < Float(1.0f), twice, twice - Float(1.0f)) * Float(2.0f) - Float(1.0f);
        Float b = u.y * Float(2.0f) - Float(1.0f);
        p = select(on_x, vec3_of(side, a, b), select(on_y, vec3_of(a, side, b), vec3_of(a, b, side)));
        Float none = Float(0.0f);
        n = select(on_x, vec3_of(side, none, none), select(on_y, vec3_of(none, side, none), vec3_of(none, none, side)));
        density = select(on_x, grown.x, select(on_y, grown.y, grown.z)) / (sum * Float(8.0f));
    } else {
        float bottom = shape.bottom_radius;
        float top = shape.top_radius;
        float side = emitter.side_share;
        float base = emitter.base_share;
        Mask on_side = u.x < Float(side);
        Mask on_base = without(u.x < Float(side + base), on_side);
        // Along the side so that the area grows evenly: the radius is the root of a straight line of squares.
        Float share = min(u.x / Float(side), Float(1.0f));
        Float radius = sqrt(Float(bottom * bottom) + share * Float(top * top - bottom * bottom));
        Float slope = Float(top - bottom);
        Float height = share;
        if (top - bottom > 1.0e-6f || bottom - top > 1.0e-6f) {
            height = clamp01((radius - Float(bottom)) / slope);
        }
        Vec2 around = on_circle(u.y);
        Vec3 on_cone = vec3_of(radius * around.x, height, radius * around.y);
        Vec3 out_of_cone = vec3_of(around.x, -slope, around.y);
        Float rest = select(on_base, (u.x - Float(side)) / Float(base > 0.0f ? base : 1.0f),
                            (u.x - Float(side + base)) / Float(side + base < 1.0f ? 1.0f - side - base : 1.0f));
        Vec2 q = on_disk(vec2_of(clamp01(rest), u.y));
        Float cap_radius = select(on_base, Float(bottom), Float(top));
        Vec3 on_cap = vec3_of(q.x * cap_radius, select(on_base, Float(0.0f), Float(1.0f)), q.y * cap_radius);
        Vec3 out_of_cap = vec3_of(Float(0.0f), select(on_base, Float(-1.0f), Float(1.0f)), Float(0.0f));
        p = select(on_side, on_cone, on_cap);
        n = select(on_side, out_of_cone, out_of_cap);
    }
    AreaPoint point;
    point.at = no_surface();
    point.at.position = apply_affine(shape.to_world, p);
    point.at.error = reach_linear(shape.to_world, placed_rounding(shape));
    point.at.normal = normalize(apply_transposed(shape.to_object, n));
    if (emitter.textured != 0) {
        point.at.uv = placed_uv(kind, p, n);
        point.at.local = apply_affine(shape.to_author, p);
        point.at.local_in = -normalize(apply_linear(shape.to_author, n));
    }
    point.density = density / max(area_growth(shape, n), Float(SMALLEST));
    return point;
}

// A triangle of a small mesh, at barycentric coordinates.
FN AreaPoint triangle_point(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec2 on, Mask mask) {
    AreaPoint point;
    if (emitter.textured != 0) {
        ObjectRecord object = AT(world.objects, emitter.object);
        point.at = mesh_surface(world, object.instance, Int(object.sub), on.x, on.y, mask);
    } else {
        TriangleRecord t = AT(world.triangles, emitter.index);
        point.at = triangle_surface(broadcast(t.a), broadcast(t.b), broadcast(t.c), on.x, on.y);
    }
    point.at.normal = broadcast(emitter.direction);
    point.density = Float(1.0f / emitter.area);
    return point;
}

// One triangle of a large mesh.
FN AreaPoint part_point(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec2 on, Mask mask) {
    AreaPoint point;
    point.at = mesh_surface(world, emitter.index, Int(emitter.first_share), on.x, on.y, mask);
    point.density = Float(1.0f / emitter.area);
    return point;
}

// Per square metre, of a triangle of a mesh: the same everywhere, but where a texture makes some brighter.
FN Float mesh_density(IN(WorldRecord) world, IN(EmitterRecord) emitter, Int part, Mask mask) {
    Float density = Float(1.0f / emitter.area);
    if (emitter.textured != 0) {
        density = gather_float(world.distributions, part + Int(emitter.first_density), mask);
    }
    return density;
}

// The number is used up by the choice of the triangle and stretched again for the place within it.
FN AreaPoint mesh_point(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec2 u, Mask mask) {
    Int part = find_share(world, Int(emitter.first_share), emitter.share_count, u.x, mask);
    Float share = own_share(world, Int(emitter.first_share), part, mask);
    Float before = gather_float(world.distributions, part + Int(emitter.first_share), mask) - share;
    Vec2 rest = vec2_of(min(clamp01((u.x - before) / max(share, Float(SMALLEST))), Float(0.99999994f)), u.y);
    Vec2 on = on_triangle(rest);
    AreaPoint point;
    point.at = mesh_surface(world, emitter.index, part, on.x, on.y, mask);
    point.density = mesh_density(world, emitter, part, mask);
    return point;
}

NAMESPACE_END

#endif
