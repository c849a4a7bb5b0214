// Everything that gives light, seen from a point: which emitter is asked, where on it, and with what density.
#ifndef LANCER_KERNEL_EMITTER_H
#define LANCER_KERNEL_EMITTER_H

#include "lancer/kernel/frame.h"
#include "lancer/kernel/light.h"
#include "lancer/kernel/material.h"
#include "lancer/kernel/warp.h"

NAMESPACE_BEGIN

// ---- Which emitter -------------------------------------------------------------------------------------------------------------------

// About the irradiance that the emitter can make at a point: what the choice among emitters is weighed by. Never 0 where light arrives.
FN Float emitter_weight(IN(EmitterRecord) emitter, Vec3 from) {
    Float weight = Float(emitter.strength);
    if (emitter.kind != EMITTER_DIRECTIONAL && emitter.kind != EMITTER_ENVIRONMENT) {
        Vec3 way = from - broadcast(emitter.middle);
        Float radius_2 = Float(emitter.radius * emitter.radius);
        weight = weight / max(max(dot(way, way), radius_2), Float(SMALLEST));
        if (emitter.kind == EMITTER_TRIANGLE && emitter.two_sided == 0) {
            // Nothing reaches points behind its plane; those near the plane see little of it.
            Float height = dot(way, broadcast(emitter.direction));
            Float slant = height / sqrt(max(max(dot(way, way), radius_2), Float(SMALLEST)));
            weight = select(height > Float(0.0f), weight * max(slant, Float(0.05f)), Float(0.0f));
        }
    }
    return weight;
}

struct EmitterChoice {
    Int emitter;  // -1: none can be seen
    Float chance;
};

// The first of `count` cumulative shares (from `first` on) that is above u; the last where none is.
FN Int find_share(IN(WorldRecord) world, int first, int count, Float u, Mask mask) {
    Int low = Int(0);
    Int high = Int(count - 1);
    for (int step = count; step > 0; step /= 2) {
        Int middle = (low + high) >> 1;
        Mask above = gather_float(world.distributions, middle + Int(first), mask) > u;
        Mask open = is_above(high, low);
        high = select(both(open, above), middle, high);
        low = select(without(open, above), middle + Int(1), low);
    }
    return low;
}

// The share of one entry itself.
FN Float own_share(IN(WorldRecord) world, int first, Int entry, Mask mask) {
    Float upper = gather_float(world.distributions, entry + Int(first), mask);
    Float lower = gather_float(world.distributions, select(is_above(entry, Int(0)), entry, Int(1)) + Int(first - 1), mask);
    return upper - select(is_above(entry, Int(0)), lower, Float(0.0f));
}

FN EmitterChoice choose_emitter(IN(WorldRecord) world, Vec3 from, Float u, Mask mask) {
    EmitterChoice choice;
    choice.emitter = Int(-1);
    choice.chance = Float(0.0f);
    if (world.chosen_by_strength != 0) {
        choice.emitter = find_share(world, 0, world.emitter_count, u, mask);
        choice.chance = own_share(world, 0, choice.emitter, mask);
    } else if (world.emitter_count == 1) {
        Mask seen = emitter_weight(AT(world.emitters, 0), from) > Float(0.0f);
        choice.emitter = select(seen, Int(0), Int(-1));
        choice.chance = select(seen, Float(1.0f), Float(0.0f));
    } else {
        Float sum = Float(0.0f);
        for (int i = 0; i < world.emitter_count; ++i) {
            sum = sum + emitter_weight(AT(world.emitters, i), from);
        }
        Float goal = u * sum;
        Float so_far = Float(0.0f);
        for (int i = 0; i < world.emitter_count; ++i) {
            Float weight = emitter_weight(AT(world.emitters, i), from);
            Mask here = both(goal >= so_far, weight > Float(0.0f));  // the last one that qualifies
            choice.emitter = select(here, Int(i), choice.emitter);
            choice.chance = select(here, weight / sum, choice.chance);
            so_far = so_far + weight;
        }
    }
    return choice;
}

FN Float emitter_chance(IN(WorldRecord) world, Vec3 from, Int emitter, Mask mask) {
    Float chance = Float(0.0f);
    if (world.chosen_by_strength != 0) {
        chance = own_share(world, 0, select(is_above(emitter, Int(-1)), emitter, Int(0)), mask);
    } else if (world.emitter_count == 1) {
        chance = select(emitter_weight(AT(world.emitters, 0), from) > Float(0.0f), Float(1.0f), Float(0.0f));
    } else {
        Float sum = Float(0.0f);
        Float own = Float(0.0f);
        for (int i = 0; i < world.emitter_count; ++i) {
            Float weight = emitter_weight(AT(world.emitters, i), from);
            sum = sum + weight;
            own = select(is_equal(emitter, Int(i)), weight, own);
        }
        chance = select(sum > Float(0.0f), own / max(sum, Float(SMALLEST)), Float(0.0f));
    }
    return chance;
}

// ---- Where on it ---------------------------------------------------------------------------------------------------------------------

// A point of an emitter as it is seen from another point.
struct EmitterSample {
    Vec3 target;     // on the emitter; from far emitters: from + direction
    Vec3 error;      // bound of the rounding of `target`
    Vec3 normal;     // there
    Vec3 direction;  // towards it, length 1
    Float distance;  // FAR for far ones
    Float density;   // per solid angle at the point that looks; 1 for lights without size
    Mask discrete;   // a light without size
    Mask valid;
};

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

struct AreaPoint {
    Vec3 position;
    Vec3 error;
    Vec3 normal;    // outwards, length 1
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
        Vec3 grown = vec3_of(area_growth(shape, vec3_of(Float(1.0f), Float(0.0f), Float(0.0f))), area_growth(shape, n),
                             area_growth(shape, vec3_of(Float(0.0f), Float(0.0f), Float(1.0f))));
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
    point.position = apply_affine(shape.to_world, p);
    point.error = reach_linear(shape.to_world, placed_rounding(shape));
    point.normal = normalize(apply_transposed(shape.to_object, n));
    point.density = density / max(area_growth(shape, n), Float(SMALLEST));
    return point;
}

FN AreaPoint triangle_point(Vec3 a, Vec3 b, Vec3 c, float area, Vec2 u) {
    Vec2 at = on_triangle(u);
    SurfacePoint s = triangle_surface(a, b, c, at.x, at.y);
    AreaPoint point;
    point.position = s.position;
    point.error = s.error;
    point.normal = s.normal;
    point.density = Float(1.0f / area);
    return point;
}

// The number is used up by the choice of the triangle and stretched again for the place within it.
FN AreaPoint mesh_point(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec2 u, Mask mask) {
    Int part = find_share(world, emitter.first_share, emitter.share_count, u.x, mask);
    Float share = own_share(world, emitter.first_share, part, mask);
    Float before = gather_float(world.distributions, part + Int(emitter.first_share), mask) - share;
    Vec2 rest = vec2_of(min(clamp01((u.x - before) / max(share, Float(SMALLEST))), Float(0.99999994f)), u.y);
    Vec2 at = on_triangle(rest);
    SurfacePoint s = mesh_surface(world, emitter.index, part, at.x, at.y, mask);
    AreaPoint point;
    point.position = s.position;
    point.error = s.error;
    point.normal = s.normal;
    point.density = Float(1.0f / emitter.area);
    return point;
}

// A sphere seen from outside: directions uniform over what it covers of the sky. From inside: uniform over its surface.
FN EmitterSample sphere_light_sample(IN(SphereRecord) sphere, Vec3 from, Vec2 u) {
    EmitterSample s;
    Vec3 center = broadcast(sphere.center);
    Float radius = Float(sphere.radius);
    Vec3 way = center - from;
    Float distance_2 = dot(way, way);
    Float radius_2 = radius * radius;
    Mask outside = distance_2 > radius_2 * Float(1.0001f);
    Float distance = sqrt(distance_2);
    Frame frame = frame_around(way / max(distance, Float(SMALLEST)));
    Float sin_2 = min(radius_2 / max(distance_2, Float(SMALLEST)), Float(1.0f));
    Float cos_most = sqrt(Float(1.0f) - sin_2);
    Float room = sin_2 / (Float(1.0f) + cos_most);  // 1 - cos_most
    Float off = room * u.x;                         // 1 - cosine
    Float sine_2 = max(off * (Float(2.0f) - off), Float(0.0f));
    Float sine = sqrt(sine_2);
    Vec2 around = on_circle(u.y);
    Vec3 towards = to_world(frame, vec3_of(sine * around.x, sine * around.y, Float(1.0f) - off));
    // The nearer of the two points of the sphere that lie there.
    Float half_chord = sqrt(max(radius_2 - distance_2 * sine_2, Float(0.0f)));
    Vec3 near = from + towards * (distance * (Float(1.0f) - off) - half_chord);
    Vec3 normal = select(outside, normalize(near - center), on_sphere(u));
    s.normal = normal;
    s.target = center + normal * radius;
    s.error = (abs(center) + vec3_all(radius)) * Float(8.0f * ROUNDING);
    Vec3 line = s.target - from;
    Float length_2 = dot(line, line);
    s.distance = sqrt(length_2);
    s.direction = line / max(s.distance, Float(SMALLEST));
    Float cosine = abs(dot(s.direction, normal));
    Float by_area = length_2 / max(cosine * Float(4.0f * PI) * radius_2, Float(SMALLEST));
    s.density = select(outside, Float(0.5f / PI) / max(room, Float(SMALLEST)), by_area);
    s.discrete = Float(1.0f) < Float(0.0f);
    s.valid = s.distance > Float(0.0f);
    return s;
}

FN EmitterSample area_sample(IN(AreaPoint) point, Vec3 from) {
    EmitterSample s;
    s.target = point.position;
    s.error = point.error;
    s.normal = point.normal;
    Vec3 way = point.position - from;
    Float distance_2 = dot(way, way);
    s.distance = sqrt(distance_2);
    s.direction = way / max(s.distance, Float(SMALLEST));
    Float cosine = abs(dot(s.direction, point.normal));
    s.density = point.density * distance_2 / max(cosine, Float(SMALLEST));
    s.discrete = Float(1.0f) < Float(0.0f);
    s.valid = both(cosine > Float(0.0f), distance_2 > Float(0.0f));
    return s;
}

FN EmitterSample far_sample(Vec3 from, Vec3 direction, Float density, Mask discrete) {
    EmitterSample s;
    s.target = from + direction;
    s.error = vec3_all(Float(0.0f));
    s.normal = -direction;
    s.direction = direction;
    s.distance = Float(FAR);
    s.density = density;
    s.discrete = discrete;
    s.valid = density > Float(0.0f);
    return s;
}

FN EmitterSample point_sample(IN(EmitterRecord) emitter, Vec3 from) {
    EmitterSample s;
    Vec3 way = broadcast(emitter.position) - from;
    s.target = broadcast(emitter.position);
    s.error = vec3_all(Float(0.0f));
    s.distance = length(way);
    s.direction = way / max(s.distance, Float(SMALLEST));
    s.normal = -s.direction;
    s.density = Float(1.0f);
    s.discrete = s.density > Float(0.0f);
    s.valid = s.distance > Float(0.0f);
    return s;
}

FN EmitterSample emitter_sample(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec3 from, Vec2 u, Mask mask) {
    Mask yes = Float(1.0f) > Float(0.0f);
    Mask no = Float(1.0f) < Float(0.0f);
    EmitterSample s;
    if (emitter.kind == EMITTER_SPHERE) {
        s = sphere_light_sample(AT(world.spheres, emitter.index), from, u);
    } else if (emitter.kind == EMITTER_TRIANGLE) {
        TriangleRecord t = AT(world.triangles, emitter.index);
        AreaPoint point = triangle_point(broadcast(t.a), broadcast(t.b), broadcast(t.c), emitter.area, u);
        point.normal = broadcast(emitter.direction);
        s = area_sample(point, from);
    } else if (emitter.kind == EMITTER_MESH) {
        s = area_sample(mesh_point(world, emitter, u, mask), from);
    } else if (emitter.kind == EMITTER_PLACED) {
        s = area_sample(placed_point(AT(world.placed, emitter.index), AT(world.objects, emitter.object).kind, emitter, u), from);
    } else if (emitter.kind == EMITTER_DIRECTIONAL) {
        s = far_sample(from, broadcast(-emitter.direction), Float(1.0f), yes);
    } else if (emitter.kind == EMITTER_ENVIRONMENT) {
        s = far_sample(from, on_sphere(u), Float(0.25f / PI), no);
    } else {
        s = point_sample(emitter, from);
    }
    return s;
}

// The density, per solid angle at `from`, with which emitter_sample draws the point of an emitting object that a ray from there has met.
FN Float emitter_density(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec3 from, Vec3 direction, IN(SurfacePoint) point) {
    Float density = Float(0.25f / PI);
    if (emitter.kind != EMITTER_ENVIRONMENT) {
        Vec3 way = point.position - from;
        Float to_solid_angle = dot(way, way) / max(abs(dot(direction, point.normal)), Float(SMALLEST));
        density = to_solid_angle * Float(1.0f / emitter.area);
        if (emitter.kind == EMITTER_SPHERE) {
            SphereRecord sphere = AT(world.spheres, emitter.index);
            Vec3 to_center = broadcast(sphere.center) - from;
            Float distance_2 = dot(to_center, to_center);
            Float radius_2 = Float(sphere.radius * sphere.radius);
            Float sin_2 = min(radius_2 / max(distance_2, Float(SMALLEST)), Float(1.0f));
            Float room = sin_2 / (Float(1.0f) + sqrt(Float(1.0f) - sin_2));
            density = select(distance_2 > radius_2 * Float(1.0001f), Float(0.5f / PI) / max(room, Float(SMALLEST)), density);
        } else if (emitter.kind == EMITTER_PLACED) {
            PlacedRecord shape = AT(world.placed, emitter.index);
            Vec3 n = apply_transposed(shape.to_world, point.normal);  // back in the shape's own space, of any length
            n = normalize(n);
            Float growth = area_growth(shape, n);
            int kind = AT(world.objects, emitter.object).kind;
            if (kind == OBJECT_PLACED_BOX) {
                Vec3 grown = vec3_of(area_growth(shape, vec3_of(Float(1.0f), Float(0.0f), Float(0.0f))),
                                     area_growth(shape, vec3_of(Float(0.0f), Float(1.0f), Float(0.0f))),
                                     area_growth(shape, vec3_of(Float(0.0f), Float(0.0f), Float(1.0f))));
                density = to_solid_angle / ((grown.x + grown.y + grown.z) * Float(8.0f));
            } else {
                density = to_solid_angle / (growth * Float(emitter.area));
            }
        }
    }
    return density;
}

// ---- How much light --------------------------------------------------------------------------------------------------------------------

// The surroundings along a direction.
FN Spectrum environment_radiance(IN(WorldRecord) world, Vec3 direction, Vec4 nanometres, Mask mask) {
    Spectrum radiance = black();
    if (world.environment >= 0) {
        SurfacePoint nowhere = no_surface();
        Float up = direction.y;
        Spectrum horizon = color_value(world, world.sky_horizon, nowhere, nanometres, mask);
        Spectrum above = horizon + (color_value(world, world.sky_zenith, nowhere, nanometres, mask) - horizon) * max(up, Float(0.0f));
        Spectrum below = horizon + (color_value(world, world.sky_nadir, nowhere, nanometres, mask) - horizon) * max(-up, Float(0.0f));
        radiance = select(up < Float(0.0f), below, above);
    }
    return radiance;
}

// What arrives at the point if nothing is in the way: radiance, or irradiance at right angles of lights without size.
FN Spectrum emitted_light(IN(WorldRecord) world, IN(EmitterRecord) emitter, IN(EmitterSample) s, Vec4 nanometres, Mask mask) {
    SurfacePoint there = no_surface();
    Spectrum light = black();
    if (emitter.kind == EMITTER_ENVIRONMENT) {
        light = environment_radiance(world, s.direction, nanometres, mask);
    } else if (emitter.object >= 0) {
        MaterialRecord material = AT(world.surfaces, emitter.material);
        Mask front = dot(s.normal, s.direction) < Float(0.0f);
        Mask shines = mask;
        if (emitter.two_sided == 0) {
            shines = both(mask, front);
        }
        light = select(shines, color_value(world, material.emission, there, nanometres, shines), light);
    } else {
        light = color_value(world, emitter.light, there, nanometres, mask);
        if (emitter.kind != EMITTER_DIRECTIONAL) {
            light = light / max(s.distance * s.distance, Float(SMALLEST));
        }
        if (emitter.kind == EMITTER_SPOT) {
            Float cosine = -dot(s.direction, broadcast(emitter.direction));
            Float x = clamp01((cosine - Float(emitter.cos_outer)) / Float(emitter.cos_inner - emitter.cos_outer));
            light = light * (x * x * (Float(3.0f) - Float(2.0f) * x));
        }
    }
    return light;
}

NAMESPACE_END

#endif
