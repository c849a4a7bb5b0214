// The path tracer: light is followed backwards from the camera, from surface to surface; at each vertex one emitter is asked for its light, and
// the path goes on in a direction drawn from the material. Emitters that it meets by itself count, too; where both ways could have found the same
// light, each has the weight that the power heuristic gives it [Veach 1997]. The radiance that a path brings is an unbiased estimate.
#ifndef LANCER_KERNEL_PATH_H
#define LANCER_KERNEL_PATH_H

#include "lancer/kernel/bsdf/bsdf.h"
#include "lancer/kernel/camera.h"
#include "lancer/kernel/emitter.h"
#include "lancer/kernel/intersect.h"
#include "lancer/kernel/lighting.h"
#include "lancer/kernel/pixel_filter.h"
#include "lancer/kernel/sampler.h"
#include "lancer/kernel/warp.h"

NAMESPACE_BEGIN

const int ROULETTE_FROM = 3;  // vertices that are never ended by chance

struct PathState {
    Vec3 origin;
    Vec3 direction;
    Spectrum throughput;
    Spectrum radiance;  // found so far
    Float weight;       // of it in the pixel: of the filter, and so maybe negative
    Vec4 nanometres;
    Float density;  // with which `direction` was drawn; 0: it could not have been found by asking an emitter
    Float squeeze;  // product of squared indices by which radiance was squeezed together, left out of Russian roulette
    Sampler numbers;
    Media media;
    Mask alive;
};

FN PathState start_path(IN(WorldRecord) world, Float pixel_x, Float pixel_y, UInt key, UInt sample_number, Mask alive) {
    PathState path;
    path.numbers = start_sampler(key, sample_number);
    Vec2 film = sample_pair(path.numbers, UInt(uint(DECISION_FILM)));
    FilterSample across = sample_filter(world, film.x, alive);
    FilterSample down = sample_filter(world, film.y, alive);
    Vec2 lens = vec2_of(Float(0.0f), Float(0.0f));
    if (world.camera.lens_radius > 0.0f) {
        lens = on_disk(sample_pair(path.numbers, UInt(uint(DECISION_LENS))));
    }
    Ray ray = lens_ray(world.camera, pixel_x + Float(0.5f) + across.place, pixel_y + Float(0.5f) + down.place, lens);
    path.origin = ray.origin;
    path.direction = ray.direction;
    path.throughput = vec4_all(Float(1.0f));
    path.weight = across.weight * down.weight;
    path.radiance = black();
    path.nanometres = vec4_all(Float(D_LINE));
    if (world.spectral != 0) {
        Vec2 u = sample_pair(path.numbers, UInt(uint(DECISION_WAVELENGTH)));
        path.nanometres = wavelengths_at(world, u.x, alive);
    }
    path.density = Float(0.0f);
    path.squeeze = Float(1.0f);
    path.media = no_media();
    path.alive = alive;
    return path;
}

// The weight of a way that found the light with density a, where another would have found it with density b.
FN Float power_heuristic(Float a, Float b) {
    Float a2 = a * a;
    return a2 / max(a2 + b * b, Float(SMALLEST));
}

FN Vec2 decide(IN(PathState) path, int depth, int decision) {
    return sample_pair(path.numbers, UInt(uint(DECISION_BOUNCES + depth * DECISIONS_A_BOUNCE + decision)));
}

// ---- Light that a path meets by itself. -------------------------------------------------------------------------------------------------

FN void meet_surroundings(IN(WorldRecord) world, Mask missed, INOUT(PathState) path) {
    Spectrum sky = environment_radiance(world, path.direction, path.nanometres, missed);
    Float asked = emitter_chance(world, path.origin, Int(world.environment), missed) * Float(0.25f / PI);
    Float weight = select(path.density > Float(0.0f), power_heuristic(path.density, asked), Float(1.0f));
    path.radiance = select(missed, path.radiance + path.throughput * sky * weight, path.radiance);
}

FN void meet_emitter(IN(WorldRecord) world, IN(PathVertex) vertex, Mask shining, INOUT(PathState) path) {
    Float weight = Float(1.0f);
    Mask compared = both(both(shining, path.density > Float(0.0f)), is_above(vertex.emitter, Int(-1)));
    if (some(compared)) {
        Float chance = emitter_chance(world, path.origin, vertex.emitter, compared);
        Mask todo = compared;
        while (some(todo)) {
            int number = first_of(vertex.emitter, todo);
            Mask mine = both(todo, is_equal(vertex.emitter, Int(number)));
            Float asked = emitter_density(world, AT(world.emitters, number), path.origin, path.direction, vertex.point);
            weight = select(mine, power_heuristic(path.density, asked * chance), weight);
            todo = without(todo, mine);
        }
    }
    path.radiance = select(shining, path.radiance + path.throughput * vertex.emission * weight, path.radiance);
}

// ---- Light that is asked for. ------------------------------------------------------------------------------------------------------------

// Of one emitter, at a point seen from `wo` (in `frame`).
FN void ask_emitter(IN(WorldRecord) world, IN(PathVertex) vertex, IN(Frame) frame, Vec3 normal, Vec3 wo, Float choice, Vec2 u, Mask asking,
                    INOUT(PathState) path, INOUT(RayTally) tally) {
    EmitterChoice chosen = choose_emitter(world, vertex.point.position, choice, asking);
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
        // A ray's own rounding puts it off its line by some units for each unit of length, and so the distance to a plane.
        Vec3 end = leave_surface(s.target, s.error + vec3_all(s.distance * Float(8.0f * ROUNDING)), s.normal, -s.direction);
        Vec3 way = end - start;
        Float reach = length(way);
        Mask far = s.distance >= Float(FAR);
        shadow.origin = select(good, start, shadow.origin);
        shadow.direction = select(good, select(far, s.direction, way / max(reach, Float(SMALLEST))), shadow.direction);
        shadow.reach = select(good, select(far, Float(FAR), reach), shadow.reach);
        todo = without(todo, mine);
    }
    going = without(both(going, shadow.reach > Float(0.0f)), is_black(light));
    if (some(going)) {
        Vec3 wi = to_local(frame, shadow.direction);
        BsdfValue value = bsdf_value(world, vertex.closure, wo, wi, going);
        // Through a surface only where both its normals agree that it is through.
        Mask agree = (wi.z * dot(normal, shadow.direction)) > Float(0.0f);
        going = without(both(going, agree), is_black(value.value));
        if (some(going)) {
            tally.shadow += lanes_in(going);
            Mask hidden = occluded(world, shadow, going);
            Mask lit = without(going, hidden);
            Float asked = density * chosen.chance;
            Float weight = select(discrete, Float(1.0f), power_heuristic(asked, value.density)) / asked;
            path.radiance = select(lit, path.radiance + path.throughput * value.value * light * weight, path.radiance);
        }
    }
}

// ---- Inside of bodies. -------------------------------------------------------------------------------------------------------------------

FN Float raised(Float clearness, Float exponent) { return power(max(clearness, Float(0.0f)), exponent); }

// What bodies swallow along a way through them.
FN Spectrum left_of_light(IN(WorldRecord) world, Int material, Float distance, Vec4 nanometres, Mask alive) {
    Spectrum left_over = vec4_all(Float(1.0f));
    Mask todo = both(alive, is_above(material, Int(-1)));
    while (some(todo)) {
        int number = first_of(material, todo);
        Mask mine = both(todo, is_equal(material, Int(number)));
        MaterialRecord body = AT(world.surfaces, number);
        if (body.clear_distance > 0.0f) {
            SurfacePoint nowhere = no_surface();
            Spectrum clear = color_value(world, body.clearness, nowhere, nanometres, mine);
            Float exponent = distance * Float(1.0f / body.clear_distance);
            Spectrum passes =
                vec4_of(raised(clear.x, exponent), raised(clear.y, exponent), raised(clear.z, exponent), raised(clear.w, exponent));
            left_over = select(mine, passes, left_over);
        }
        todo = without(todo, mine);
    }
    return left_over;
}

FN Mask is_dispersive(IN(WorldRecord) world, Int material, Mask alive) {
    Mask disperses = without(alive, alive);
    Mask todo = both(alive, is_above(material, Int(-1)));
    while (some(todo)) {
        int number = first_of(material, todo);
        Mask mine = both(todo, is_equal(material, Int(number)));
        if (AT(world.media, number).dispersive != 0) {
            disperses = either(disperses, mine);
        }
        todo = without(todo, mine);
    }
    return disperses;
}

// The relative index of a clear border, at each wavelength, and the media beyond.
FN void find_border(IN(WorldRecord) world, IN(PathState) path, Mask clear, Mask thin, INOUT(PathVertex) vertex, INOUT(Media) beyond) {
    beyond = select_media(vertex.inside, left(path.media, vertex.material), entered(path.media, vertex.material));
    Int front = medium_before(path.media, vertex.material, vertex.inside);
    Int behind = beyond.first;
    // A pane has air on both sides; what bends is its own material.
    front = select(thin, Int(-1), front);
    behind = select(thin, vertex.material, behind);
    Float first = refractive_index(world, behind, path.nanometres.x, clear) / refractive_index(world, front, path.nanometres.x, clear);
    Spectrum eta = vec4_all(first);
    if (world.spectral != 0) {
        Mask disperses = either(is_dispersive(world, front, clear), is_dispersive(world, behind, clear));
        if (some(disperses)) {
            eta.y = refractive_index(world, behind, path.nanometres.y, clear) / refractive_index(world, front, path.nanometres.y, clear);
            eta.z = refractive_index(world, behind, path.nanometres.z, clear) / refractive_index(world, front, path.nanometres.z, clear);
            eta.w = refractive_index(world, behind, path.nanometres.w, clear) / refractive_index(world, front, path.nanometres.w, clear);
            // A path that has given up its other wavelengths has none to give up again.
            Mask several = max(max(path.throughput.y, path.throughput.z), path.throughput.w) > Float(0.0f);
            vertex.closure.disperses = both(without(disperses, thin), several);
        }
    }
    vertex.closure.index = select(clear, eta, vertex.closure.index);
}

// ---- One vertex --------------------------------------------------------------------------------------------------------------------------

// From the path's ray to the next one. `depth` counts the vertices before this one.
FN_LARGE void path_step(IN(WorldRecord) world, int depth, INOUT(PathState) path, INOUT(RayTally) tally) {
    if (depth == 0) {
        tally.camera += lanes_in(path.alive);
    } else {
        tally.secondary += lanes_in(path.alive);
    }
    Ray ray;
    ray.origin = path.origin;
    ray.direction = path.direction;
    ray.reach = Float(FAR);
    Hit hit = closest_hit(world, ray, path.alive);
    Mask here = both(path.alive, is_above(hit.object, Int(-1)));
    Mask missed = without(path.alive, here);
    if (world.environment >= 0 && some(missed)) {
        meet_surroundings(world, missed, path);
    }
    path.alive = here;
    if (some(here)) {
        PathVertex vertex = no_vertex();
        find_vertex(world, ray, hit, path.nanometres, here, vertex);
        if (world.has_transparency != 0) {
            Int medium = medium_before(path.media, vertex.material, vertex.inside);
            Spectrum left_over = left_of_light(world, select(vertex.inside, medium, path.media.first), hit.t, path.nanometres, here);
            path.throughput = path.throughput * left_over;
        }
        Mask shining = without(here, is_black(vertex.emission));
        if (some(shining)) {
            meet_emitter(world, vertex, shining, path);
        }

        // The surface, turned to the path's side.
        Vec3 view = -ray.direction;
        Vec3 normal = select(vertex.inside, -vertex.point.normal, vertex.point.normal);
        Vec3 shading = select(vertex.inside, -vertex.point.shading, vertex.point.shading);
        shading = select(dot(shading, view) > Float(0.0f), shading, normal);
        Frame frame = frame_around(shading);
        Vec3 wo = to_local(frame, view);
        Mask thin = is_equal(vertex.closure.kind, Int(BSDF_THIN_DIELECTRIC));
        Mask clear = both(here, either(is_clear(vertex.closure), thin));
        Mask sheet = either(thin, vertex.closure.thin);
        Media beyond = path.media;
        if (some(clear)) {
            find_border(world, path, clear, thin, vertex, beyond);
        }

        Mask going = without(here, is_equal(vertex.closure.kind, Int(BSDF_NONE)));
        if (depth >= world.max_depth) {
            going = without(here, here);
        }
        if (some(going)) {
            Vec2 choice = decide(path, depth, DECISION_CHOICE);
            Mask asking = without(going, is_smooth(vertex.closure));
            if (world.emitter_count > 0 && some(asking)) {
                ask_emitter(world, vertex, frame, normal, wo, choice.x, decide(path, depth, DECISION_LIGHT), asking, path, tally);
            }
            BsdfSample next = bsdf_sample(world, vertex.closure, wo, choice.y, decide(path, depth, DECISION_DIRECTION), going);
            Vec3 direction = normalize(to_world(frame, next.wi));
            Float rises = dot(direction, normal);
            Mask right_side = either(both(next.transmits, rises < Float(0.0f)), without(rises > Float(0.0f), next.transmits));
            going = both(both(going, next.valid), right_side);
            path.throughput = path.throughput * next.weight;
            path.density = next.density;
            path.origin = leave_surface(vertex.point.position, vertex.point.error, normal, direction);
            path.direction = direction;
            Mask crosses = without(both(going, next.transmits), sheet);
            path.media = select_media(crosses, beyond, path.media);
            Float eta = vertex.closure.index.x;
            path.squeeze = select(crosses, path.squeeze * eta * eta, path.squeeze);
            going = without(going, is_black(path.throughput));
            if (depth >= ROULETTE_FROM) {
                Float survives = min(largest(path.throughput) * path.squeeze, Float(0.95f));
                Vec2 u = decide(path, depth, DECISION_SURVIVAL);
                going = both(going, u.x < survives);
                path.throughput = path.throughput / max(survives, Float(SMALLEST));
            }
        }
        path.alive = going;
    }
}

NAMESPACE_END

#endif
