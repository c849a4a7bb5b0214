// Light as it leaves an emitter: where a path of light begins, which way it goes, and with what density.
//
// Far emitters (the surroundings, directional lights) send their light through a disk at right angles to it, as wide as all that is in the scene:
// `world.scene_middle`, `world.scene_radius`.
#ifndef LANCER_KERNEL_EMITTER_EMISSION_H
#define LANCER_KERNEL_EMITTER_EMISSION_H

#include "lancer/kernel/emitter/radiance.h"

NAMESPACE_BEGIN

// Densities of a point of an emitter and of a direction there. Of those that are not drawn, of lights without size, 1.
struct EmissionDensity {
    Float place;      // per square metre: of the emitter, or of the disk of far ones
    Float direction;  // per solid angle
};

struct EmissionSample {
    SurfacePoint point;  // `normal` on the side to which the light goes; of far ones and of points the direction itself
    Vec3 direction;      // the way the light travels, length 1
    Spectrum light;      // power over the densities: what a path of light starts with; before the choice of the emitter
    Float cosine;        // of the direction and the normal
    EmissionDensity density;
    Mask discrete;  // a light without size: chance does not meet it
    Mask far;
    Mask valid;
};

FN Mask is_far(IN(EmitterRecord) emitter) {
    return all_or_none(emitter.kind == EMITTER_DIRECTIONAL || emitter.kind == EMITTER_ENVIRONMENT);
}

// ---- Which emitter: by its power, see world/emission.h. ------------------------------------------------------------------------------------

struct EmissionChoice {
    Int emitter;  // -1: there is none
    Float chance;
};

FN EmissionChoice choose_emission(IN(WorldRecord) world, Float u, Mask mask) {
    EmissionChoice choice;
    choice.emitter = Int(-1);
    choice.chance = Float(0.0f);
    if (world.emitter_count > 0) {
        choice.emitter = find_share(world, Int(world.first_emission), world.emitter_count, u, mask);
        choice.chance = own_share(world, Int(world.first_emission), choice.emitter, mask);
    }
    return choice;
}

FN Float emission_chance(IN(WorldRecord) world, int emitter, Mask mask) {
    return own_share(world, Int(world.first_emission), Int(emitter), mask);
}

// ---- Densities ----------------------------------------------------------------------------------------------------------------------------

FN Float scene_disk_density(IN(WorldRecord) world) { return Float(1.0f / (PI * world.scene_radius * world.scene_radius)); }

// Whether far light that comes to the point has come through the disk. Infinite planes reach beyond what it lights.
FN Mask comes_through_disk(IN(WorldRecord) world, Vec3 to, Vec3 direction) {
    Vec3 way = to - broadcast(world.scene_middle);
    Vec3 off = cross(way, direction);
    return both(dot(off, off) < Float(world.scene_radius * world.scene_radius), dot(way, direction) > Float(-world.scene_radius));
}

// 1 - cosine of the half angle of a spot's cone.
FN Float cone_height(IN(EmitterRecord) emitter) { return max(Float(1.0f - emitter.cos_outer), Float(1.0e-6f)); }

FN Float cone_density(IN(EmitterRecord) emitter) { return Float(0.5f / PI) / cone_height(emitter); }

// With which a direction is drawn around a light without size. Spots: even over their cone.
FN Float point_direction_density(IN(EmitterRecord) emitter, Vec3 direction) {
    Float density = Float(0.25f / PI);
    if (emitter.kind == EMITTER_SPOT) {
        Mask within = dot(direction, broadcast(emitter.direction)) >= Float(emitter.cos_outer);
        density = select(within, cone_density(emitter), Float(0.0f));
    }
    return density;
}

// Of light that leaves the point of an emitter in `direction`, to go to `to`. `place`: the density of the point on a near emitter with a size.
FN EmissionDensity emission_density(IN(WorldRecord) world, IN(EmitterRecord) emitter, IN(SurfacePoint) point, Vec3 direction, Vec3 to,
                                    Float place, Mask mask) {
    EmissionDensity d;
    d.place = Float(1.0f);
    d.direction = Float(1.0f);
    if (emitter.kind == EMITTER_DIRECTIONAL || emitter.kind == EMITTER_ENVIRONMENT) {
        d.place = select(comes_through_disk(world, to, direction), scene_disk_density(world), Float(0.0f));
        if (emitter.kind == EMITTER_ENVIRONMENT) {
            d.direction = sky_density(world, -direction, mask);
        }
    } else if (emitter.object >= 0) {
        Float cosine = dot(direction, point.normal);
        d.place = place;
        if (emitter.two_sided != 0) {
            d.direction = abs(cosine) * Float(0.5f / PI);
        } else {
            d.direction = max(cosine, Float(0.0f)) * Float(1.0f / PI);
        }
    } else {
        d.direction = point_direction_density(emitter, direction);
        if (is_thrown(emitter)) {
            d.direction = thrown_density(world, emitter, direction, mask);
        }
    }
    return d;
}

// ---- Drawing ------------------------------------------------------------------------------------------------------------------------------

FN EmissionSample far_emission(IN(WorldRecord) world, Vec3 direction, Float density, Vec2 u, Mask discrete) {
    EmissionSample s;
    Frame frame = frame_around(direction);
    Vec2 on = on_disk(u);
    Vec3 off = (frame.x * on.x + frame.y * on.y - direction) * Float(world.scene_radius);
    s.point = no_surface();
    s.point.position = broadcast(world.scene_middle) + off;
    s.point.normal = direction;
    s.direction = direction;
    s.cosine = Float(1.0f);
    s.density.place = scene_disk_density(world);
    s.density.direction = density;
    s.discrete = discrete;
    s.far = all_or_none(true);
    s.valid = density > Float(0.0f);
    s.light = black();
    return s;
}

FN EmissionSample point_emission(IN(EmitterRecord) emitter, Vec2 u) {
    EmissionSample s;
    s.direction = on_sphere(u);
    if (emitter.kind == EMITTER_SPOT) {
        Frame frame = frame_around(broadcast(emitter.direction));
        Float off = u.x * cone_height(emitter);
        Float sine = sqrt(max(off * (Float(2.0f) - off), Float(0.0f)));
        Vec2 around = on_circle(u.y);
        s.direction = to_world(frame, vec3_of(sine * around.x, sine * around.y, Float(1.0f) - off));
    }
    s.point = no_surface();
    s.point.position = broadcast(emitter.position);
    s.point.normal = s.direction;
    s.cosine = Float(1.0f);
    s.density.place = Float(1.0f);
    s.density.direction = Float(0.25f / PI);
    if (emitter.kind == EMITTER_SPOT) {
        s.density.direction = cone_density(emitter);
    }
    s.discrete = all_or_none(true);
    s.far = all_or_none(false);
    s.valid = s.discrete;
    s.light = black();
    return s;
}

// A direction around the normal by its cosine; of lamps with two sides, either side. `side` in [0, 1).
FN EmissionSample area_emission(IN(AreaPoint) point, bool two_sided, Float side, Vec2 u) {
    EmissionSample s;
    s.point = point.at;
    Float density = Float(1.0f / PI);
    if (two_sided) {
        s.point.normal = select(side < Float(0.5f), -s.point.normal, s.point.normal);
        density = Float(0.5f / PI);
    }
    Vec3 local = cosine_hemisphere(u);
    s.direction = normalize(to_world(frame_around(s.point.normal), local));
    s.cosine = local.z;
    s.density.place = point.density;
    s.density.direction = local.z * density;
    s.discrete = all_or_none(false);
    s.far = s.discrete;
    s.valid = both(local.z > Float(0.0f), point.density > Float(0.0f));
    s.light = black();
    return s;
}

FN AreaPoint sphere_point(IN(SphereRecord) sphere, IN(EmitterRecord) emitter, Vec2 u) {
    AreaPoint point;
    Vec3 center = broadcast(sphere.center);
    Vec3 normal = on_sphere(u);
    point.at = no_surface();
    point.at.normal = normal;
    point.at.position = center + normal * Float(sphere.radius);
    point.at.error = (abs(center) + vec3_all(Float(sphere.radius))) * Float(8.0f * ROUNDING);
    if (emitter.textured != 0) {
        point.at.uv = sphere_uv(normal);
        point.at.local = point.at.position;
        point.at.local_in = -normal;
    }
    point.density = Float(1.0f / emitter.area);
    return point;
}

// `place` and `u`: for the point and for the direction; `side`: a number of its own.
FN EmissionSample emission_sample(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec2 place, Vec2 u, Float side, Vec4 nanometres,
                                  Mask mask) {
    EmissionSample s;
    EmitterSample seen;  // the emitter as the light's first point would ask for it
    if (emitter.kind == EMITTER_ENVIRONMENT) {
        SkySample sky = sky_sample(world, u, mask);
        s = far_emission(world, -sky.direction, sky.density, place, all_or_none(false));
    } else if (emitter.kind == EMITTER_DIRECTIONAL) {
        s = far_emission(world, broadcast(emitter.direction), Float(1.0f), place, all_or_none(true));
    } else if (emitter.kind == EMITTER_SPHERE) {
        s = area_emission(sphere_point(AT(world.spheres, emitter.index), emitter, place), emitter.two_sided != 0, side, u);
    } else if (emitter.kind == EMITTER_TRIANGLE) {
        s = area_emission(triangle_point(world, emitter, on_triangle(place), mask), emitter.two_sided != 0, side, u);
    } else if (emitter.kind == EMITTER_MESH) {
        s = area_emission(mesh_point(world, emitter, place, mask), emitter.two_sided != 0, side, u);
    } else if (emitter.kind == EMITTER_MESH_TRIANGLE) {
        s = area_emission(part_point(world, emitter, on_triangle(place), mask), emitter.two_sided != 0, side, u);
    } else if (emitter.kind == EMITTER_PLACED) {
        s = area_emission(placed_point(AT(world.placed, emitter.index), AT(world.objects, emitter.object).kind, emitter, place),
                          emitter.two_sided != 0, side, u);
    } else {
        s = point_emission(emitter, u);
        if (is_thrown(emitter)) {
            ThrownWay thrown = thrown_sample(world, emitter, u, mask);
            s.direction = thrown.way;
            s.point.normal = thrown.way;
            s.density.direction = thrown.density;
            s.valid = thrown.density > Float(0.0f);
        }
    }
    seen.point = s.point;
    seen.direction = -s.direction;
    seen.distance = Float(1.0f);
    seen.density = Float(1.0f);
    seen.place = Float(1.0f);
    seen.discrete = s.discrete;
    seen.valid = s.valid;
    Mask good = both(mask, s.valid);
    Spectrum light = emitted_light(world, emitter, seen, nanometres, good);
    Float density = s.density.place * s.density.direction;
    s.light = select(good, light * (s.cosine / max(density, Float(SMALLEST))), s.light);
    return s;
}

NAMESPACE_END

#endif
