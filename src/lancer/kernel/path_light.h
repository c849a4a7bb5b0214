// Light that a path finds: what it meets by itself, and what emitters that it asks send to it; where both ways could have found the same light, each has
// the weight that the power heuristic gives it [Veach 1997].
#ifndef LANCER_KERNEL_PATH_LIGHT_H
#define LANCER_KERNEL_PATH_LIGHT_H

#include "lancer/kernel/bsdf/bsdf.h"
#include "lancer/kernel/cuts.h"
#include "lancer/kernel/emitter/emitter.h"
#include "lancer/kernel/path_state.h"
#include "lancer/kernel/surface.h"
#include "lancer/kernel/tally.h"
#include "lancer/kernel/volume/passage.h"

NAMESPACE_BEGIN

// The weight of a way that found the light with density a, where another would have found it with density b.
FN Float power_heuristic(Float a, Float b) {
    Float a2 = a * a;
    return a2 / max(a2 + b * b, Float(SMALLEST));
}

// Of light that is met in a direction drawn with `density`, where asking would have found it with density `asked`.
FN Float met_weight(IN(WorldRecord) world, Float density, Float asked) {
    Float weight = power_heuristic(density, asked);
    if (world.ways == WAYS_EMITTER) {
        weight = select(asked > Float(0.0f), Float(0.0f), Float(1.0f));
    } else if (world.ways == WAYS_BSDF) {
        weight = Float(1.0f);
    }
    return weight;
}

// Of light that is asked for with density `asked`, where chance finds it with `density`; divided by the density.
FN Float asked_weight(IN(WorldRecord) world, Float asked, Float density, Mask discrete) {
    Float weight = select(discrete, Float(1.0f), power_heuristic(asked, density));
    if (world.ways == WAYS_EMITTER) {
        weight = Float(1.0f);
    }
    return weight / asked;
}

// ---- Light that a path meets by itself. -------------------------------------------------------------------------------------------------

FN void meet_surroundings(IN(WorldRecord) world, Mask missed, INOUT(PathState) path) {
    Spectrum sky = sky_radiance(world, path.direction, path.nanometres, missed);
    Float asked =
        emitter_chance(world, path.origin, path.facing, Int(world.environment), missed) * sky_density(world, path.direction, missed);
    Float weight = select(path.density > Float(0.0f), met_weight(world, path.density, asked), Float(1.0f));
    path.radiance = select(missed, path.radiance + path.throughput * sky * weight, path.radiance);
}

// `part`: the triangle of a mesh.
FN void meet_emitter(IN(WorldRecord) world, IN(PathVertex) vertex, Int part, Mask shining, INOUT(PathState) path) {
    Float weight = Float(1.0f);
    Mask compared = both(both(shining, path.density > Float(0.0f)), is_above(vertex.emitter, Int(-1)));
    if (some(compared)) {
        Float chance = emitter_chance(world, path.origin, path.facing, vertex.emitter, compared);
        Mask todo = compared;
        while (some(todo)) {
            int number = first_of(vertex.emitter, todo);
            Mask mine = both(todo, is_equal(vertex.emitter, Int(number)));
            Float asked = emitter_density(world, AT(world.emitters, number), path.origin, path.direction, vertex.point, part, mine);
            weight = select(mine, met_weight(world, path.density, asked * chance), weight);
            todo = without(todo, mine);
        }
    }
    path.radiance = select(shining, path.radiance + path.throughput * vertex.emission * weight, path.radiance);
}

// ---- Light that is asked for. ------------------------------------------------------------------------------------------------------------

// Of one emitter, at a point seen from `wo` (in `frame`). `front` and `behind`: the media on the path's side of the surface and on the other;
// `beyond`: all that one is in there.
FN void ask_emitter(IN(WorldRecord) world, int depth, IN(PathVertex) vertex, IN(Frame) frame, Vec3 normal, Vec3 facing, Vec3 wo, Int front,
                    Int behind, IN(Media) beyond, Float choice, Vec2 u, Mask asking, INOUT(PathState) path, INOUT(RayTally) tally) {
    EmitterChoice chosen = choose_emitter(world, vertex.point.position, facing, choice, asking);
    Mask going = both(both(asking, is_above(chosen.emitter, Int(-1))), chosen.chance > Float(0.0f));
    Ray shadow;
    shadow.origin = vertex.point.position;
    shadow.direction = normal;
    shadow.reach = Float(0.0f);
    Spectrum light = black();
    Float density = Float(1.0f);
    Mask discrete = without(going, going);
    Mask todo = going;
    while (some(todo)) {
        int number = first_of(chosen.emitter, todo);
        Mask mine = both(todo, is_equal(chosen.emitter, Int(number)));
        EmitterRecord emitter = AT(world.emitters, number);
        EmitterSample s = emitter_sample(world, emitter, vertex.point.position, u, mine);
        Mask good = both(mine, s.valid);
        light = select(good, emitted_light(world, emitter, s, path.nanometres, good), light);
        density = select(good, s.density, density);
        discrete = either(discrete, both(good, s.discrete));
        // From just off this surface to just before the other.
        Vec3 start = leave_surface(vertex.point.position, vertex.point.error, normal, s.direction);
        shadow = select_ray(good, ray_to_emitter(s, start), shadow);
        todo = without(todo, mine);
    }
    going = without(both(going, shadow.reach > Float(0.0f)), is_black(light));
    if (some(going)) {
        Vec3 wi = to_local(frame, shadow.direction);
        BsdfValue value = bsdf_value(world, vertex.closure, wo, wi, going);
        value.value = value.value * between_hills(vertex.hills, vertex.smooth_, shadow.direction);
        // Through a surface only where both its normals agree that it is through.
        Mask agree = (wi.z * dot(normal, shadow.direction)) > Float(0.0f);
        Mask through = wi.z < Float(0.0f);
        if (world.has_media != 0) {
            agree = either(agree, is_phase(vertex.closure));
            through = without(through, is_phase(vertex.closure));
        }
        going = without(both(going, agree), is_black(value.value));
        if (world.limits.limited != 0) {
            going = both(going, may_scatter(world, path.scattered, is_matt(vertex.closure), through));
        }
        if (some(going)) {
            tally.shadow += lanes_in(going);
            Spectrum passes = vec4_all(Float(1.0f));
            if (world.has_media != 0) {
                Media around = select_media(without(through, vertex.closure.thin), beyond, path.media);
                UInt decision = UInt(uint(DECISION_DIMMING + depth * DECISIONS_OF_DIMMING));
                light = light * passing_spectrum(world, shadow, around, path.nanometres, path.numbers, decision, going);
            } else {
                passes = passing_light(world, shadow, path.nanometres, going);
            }
            Mask lit = without(going, is_black(passes));
            if (world.has_transparency != 0 && world.has_media == 0) {
                Mask near = both(lit, shadow.reach < Float(FAR));
                Int medium = select(wi.z > Float(0.0f), front, behind);
                light = light * left_of_light(world, medium, shadow.reach, path.nanometres, near);
            }
            Float asked = density * chosen.chance;
            Float weight = asked_weight(world, asked, value.density, discrete);
            path.radiance = select(lit, path.radiance + path.throughput * value.value * light * (passes * weight), path.radiance);
        }
    }
}

NAMESPACE_END

#endif
