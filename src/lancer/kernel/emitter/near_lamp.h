// Points of lamps made of triangles, seen from a place: near lamps are drawn from evenly over what they cover of the directions there.
#ifndef LANCER_KERNEL_EMITTER_NEAR_LAMP_H
#define LANCER_KERNEL_EMITTER_NEAR_LAMP_H

#include "lancer/kernel/emitter/area.h"
#include "lancer/kernel/emitter/solid_angle.h"

NAMESPACE_BEGIN

// Of a mesh that is drawn as a whole only two triangles, a pane, are looked at one by one.
FN bool is_pair(IN(EmitterRecord) emitter) { return emitter.kind == EMITTER_MESH && emitter.share_count == 2 && emitter.textured == 0; }

FN SeenTriangle see_part(IN(WorldRecord) world, int instance_index, int part, Vec3 from) {
    InstanceRecord instance = AT(world.instances, instance_index);
    MeshRecord mesh = AT(world.meshes, instance.mesh);
    int first = (part + mesh.first_triangle) * 3;
    vec3 a = AT(world.positions, AT(world.indices, first) + mesh.first_vertex);
    vec3 b = AT(world.positions, AT(world.indices, first + 1) + mesh.first_vertex);
    vec3 c = AT(world.positions, AT(world.indices, first + 2) + mesh.first_vertex);
    return see_triangle(apply_affine(instance.to_world, broadcast(a)), apply_affine(instance.to_world, broadcast(b)),
                        apply_affine(instance.to_world, broadcast(c)), from);
}

FN SeenTriangle see_emitter(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec3 from) {
    SeenTriangle seen;
    if (emitter.kind == EMITTER_TRIANGLE) {
        TriangleRecord t = AT(world.triangles, emitter.index);
        seen = see_triangle(broadcast(t.a), broadcast(t.b), broadcast(t.c), from);
    } else {
        seen = see_part(world, emitter.index, is_pair(emitter) ? 0 : emitter.first_share, from);
    }
    return seen;
}

// Farther away their area is as good: what is left of the noise there is not worth its price.
const float NEAR_LAMP_2 = 8.0f;  // squared distance of their middle over their area

FN Mask is_near_lamp(IN(EmitterRecord) emitter, Vec3 from) {
    Vec3 way = broadcast(emitter.middle) - from;
    return dot(way, way) < Float(NEAR_LAMP_2 * emitter.area);
}

// The solid angle that a point of the emitter is drawn by; 0: by area.
FN Float drawn_solid_angle(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec3 from, Mask mask) {
    Float solid_angle = Float(0.0f);
    if (emitter.kind == EMITTER_TRIANGLE || emitter.kind == EMITTER_MESH_TRIANGLE || is_pair(emitter)) {
        Mask near = is_near_lamp(emitter, from);
        if (some(both(mask, near))) {
            SeenTriangle seen = see_emitter(world, emitter, from);
            solid_angle = seen.solid_angle;
            if (is_pair(emitter)) {
                SeenTriangle other = see_part(world, emitter.index, 1, from);
                Mask wide = both(seen.solid_angle > Float(0.0f), other.solid_angle > Float(0.0f));
                solid_angle = select(wide, seen.solid_angle + other.solid_angle, Float(0.0f));
            }
            solid_angle = select(near, solid_angle, Float(0.0f));
        }
    }
    return solid_angle;
}

// Of a triangle; `solid_angle` becomes that which it is drawn by.
FN AreaPoint seen_triangle_point(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec3 from, Vec2 u, Mask mask, INOUT(Float) solid_angle) {
    Vec2 on = on_triangle(u);
    Mask near = is_near_lamp(emitter, from);
    solid_angle = Float(0.0f);
    if (some(both(mask, near))) {
        SeenTriangle seen = see_emitter(world, emitter, from);
        solid_angle = select(near, seen.solid_angle, Float(0.0f));
        Mask wide = solid_angle > Float(0.0f);
        Vec2 even = on_seen_triangle(seen, u);
        on.x = select(wide, even.x, on.x);
        on.y = select(wide, even.y, on.y);
    }
    AreaPoint point;
    if (emitter.kind == EMITTER_TRIANGLE) {
        point = triangle_point(world, emitter, on, mask);
    } else {
        point = part_point(world, emitter, on, mask);
    }
    return point;
}

// Of a mesh that is drawn from as a whole.
FN AreaPoint seen_mesh_point(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec3 from, Vec2 u, Mask mask, INOUT(Float) solid_angle) {
    solid_angle = drawn_solid_angle(world, emitter, from, mask);
    AreaPoint point = mesh_point(world, emitter, u, mask);
    Mask wide = both(mask, solid_angle > Float(0.0f));
    if (some(wide)) {
        SeenTriangle one = see_part(world, emitter.index, 0, from);
        SeenTriangle other = see_part(world, emitter.index, 1, from);
        Float goal = u.x * solid_angle;
        Mask is_first = goal < one.solid_angle;
        Float left = select(is_first, goal / max(one.solid_angle, Float(SMALLEST)),
                            (goal - one.solid_angle) / max(other.solid_angle, Float(SMALLEST)));
        Vec2 rest = vec2_of(min(max(left, Float(0.0f)), Float(0.99999994f)), u.y);
        Vec2 on_one = on_seen_triangle(one, rest);
        Vec2 on_other = on_seen_triangle(other, rest);
        SurfacePoint at = mesh_surface(world, emitter.index, select(is_first, Int(0), Int(1)), select(is_first, on_one.x, on_other.x),
                                       select(is_first, on_one.y, on_other.y), wide);
        point.at.position = select(wide, at.position, point.at.position);
        point.at.error = select(wide, at.error, point.at.error);
        point.at.normal = select(wide, at.normal, point.at.normal);
    }
    return point;
}

NAMESPACE_END

#endif
