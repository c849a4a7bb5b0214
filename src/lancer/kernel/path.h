// The path tracer: light is followed backwards from the camera, from surface to surface; at each vertex one emitter is asked for its light, and
// the path goes on in a direction drawn from the material. Emitters that it meets by itself count, too; where both ways could have found the same
// light, each has the weight that the power heuristic gives it [Veach 1997]. The radiance that a path brings is an unbiased estimate.
#ifndef LANCER_KERNEL_PATH_H
#define LANCER_KERNEL_PATH_H

#include "lancer/kernel/bsdf/bsdf.h"
#include "lancer/kernel/camera.h"
#include "lancer/kernel/cuts.h"
#include "lancer/kernel/emitter/emitter.h"
#include "lancer/kernel/intersect.h"
#include "lancer/kernel/medium.h"
#include "lancer/kernel/pixel_filter.h"
#include "lancer/kernel/sampler.h"
#include "lancer/kernel/tally.h"
#include "lancer/kernel/volume/passage.h"
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
    Vec3 facing;    // normal of the surface that it left, where nothing comes through that; else 0
    Float density;  // with which `direction` was drawn; 0: it could not have been found by asking an emitter
    Float squeeze;  // product of squared indices by which radiance was squeezed together, left out of Russian roulette
    Float width;    // of the beam where it starts: a diameter, in metres
    Float spread;   // by which it grows a metre
    Sampler numbers;
    UInt scattered;  // how often, by kind: eleven bits for diffuse, eleven for glossy, ten for transmission
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
        path.nanometres = wavelengths_at(world, quartered_number(path.numbers, sample_number, UInt(uint(DECISION_WAVELENGTH))), alive);
    }
    path.facing = vec3_all(Float(0.0f));
    path.density = Float(0.0f);
    path.squeeze = Float(1.0f);
    path.scattered = UInt(0u);
    path.width = Float(0.0f);
    path.spread = Float(0.0f);
    if (world.beam > 0.0f) {
        Vec2 beam = pixel_beam(world.camera, pixel_x, pixel_y);
        path.width = beam.x * Float(world.beam);
        path.spread = beam.y * Float(world.beam);
    }
    path.media = no_media();
    if (world.has_media != 0) {
        path.media = media_of_camera(world);
        path.throughput.w = Float(world.spectral != 0 ? 1.0f : 0.0f);
    }
    path.alive = alive;
    return path;
}

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

// ---- How often paths may be scattered. ---------------------------------------------------------------------------------------------------

const uint ONE_GLOSSY = 2048u;
const uint ONE_TRANSMISSION = 4194304u;

FN Mask may_scatter(IN(WorldRecord) world, UInt scattered, Mask matt, Mask transmits) {
    Mask diffuse = is_above(Int(world.limits.diffuse), as_signed(scattered & UInt(2047u)));
    Mask glossy = is_above(Int(world.limits.glossy), as_signed((scattered >> 11) & UInt(2047u)));
    Mask through = is_above(Int(world.limits.transmission), as_signed(scattered >> 22));
    return select_mask(transmits, through, select_mask(matt, diffuse, glossy));
}

FN Vec2 decide(IN(PathState) path, int depth, int decision) {
    return sample_pair(path.numbers, UInt(uint(DECISION_BOUNCES + depth * DECISIONS_A_BOUNCE + decision)));
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
        // A ray's own rounding puts it off its line by some units for each unit of length, and so the distance to a plane.
        Vec3 end =
            leave_surface(s.point.position, s.point.error + vec3_all(s.distance * Float(8.0f * ROUNDING)), s.point.normal, -s.direction);
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

// ---- The coat. ----------------------------------------------------------------------------------------------------------------------------

// The coat's normal, in the frame of what it covers, as it is seen from `view`.
FN Vec3 seen_coat(IN(PathVertex) vertex, IN(Frame) frame, Vec3 normal, Vec3 view) {
    Vec3 own = select(vertex.inside, -vertex.coat_normal, vertex.coat_normal);
    Mask has_own = dot(own, own) > Float(0.5f);
    return select(has_own, to_local(frame, seen_normal(normal, own, view)), vertex.closure.coat_normal);
}

// ---- Borders of bodies. ------------------------------------------------------------------------------------------------------------------

// The relative index of a clear border, at each wavelength, and the media beyond.
FN void find_border(IN(WorldRecord) world, IN(PathState) path, Mask clear, Mask thin, INOUT(PathVertex) vertex, INOUT(Media) beyond) {
    beyond = select_media(vertex.inside, left(path.media, vertex.material), entered(path.media, vertex.material));
    Int front = medium_before(path.media, vertex.material, vertex.inside);
    Int behind = beyond.first;
    if (world.has_media != 0) {
        beyond = crossed(world, path.media, vertex.material, vertex.inside, clear);
        Mask found = without(vertex.inside, is_inside(path.media, vertex.material));
        front = select(found, vertex.material, bending_body(world, path.media, clear));
        behind = bending_body(world, beyond, clear);
    }
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

// A direction drawn with that density stands for its share of all directions: a cone of the solid angle 1 / density. The beam takes part of its
// width, so that distant textures are looked up in small copies, and what is lost of them is finer than the light that they scatter can show.
const float SCATTERED_SHARE = 0.125f;

FN Float scattered_spread(Float density) {
    return select(density > Float(0.0f), Float(2.0f * SCATTERED_SHARE) / sqrt(max(density, Float(1.0e-3f)) * Float(PI)), Float(0.0f));
}

// What one step met. Filled where `world.watched`.
struct Sight {
    Hit hit;
    PathVertex vertex;
    Spectrum met;  // the radiance found so far, but for light that was asked for from this vertex
};

// ---- One vertex --------------------------------------------------------------------------------------------------------------------------

// From the path's ray to the next one. `depth` counts the vertices before this one.
FN_LARGE void path_step(IN(WorldRecord) world, int depth, INOUT(PathState) path, INOUT(Sight) sight, INOUT(RayTally) tally) {
    if (depth == 0) {
        tally.camera += lanes_in(path.alive);
    } else {
        tally.secondary += lanes_in(path.alive);
    }
    Ray ray;
    ray.origin = path.origin;
    ray.direction = path.direction;
    ray.reach = Float(FAR);
    Float passed = Float(0.0f);
    Float before = Float(0.0f);
    Hit hit;
    PathVertex vertex = no_vertex();
    Mask scattered = without(path.alive, path.alive);
    if (world.has_media != 0) {
        Passage passage =
            pass_media(world, path.numbers, depth, path.origin, path.direction, path.media, path.throughput, path.nanometres, path.alive);
        ray.origin = passage.ray.origin;
        hit = passage.hit;
        passed = passage.passed;
        before = passage.before;
        scattered = passage.scattered;
        path.radiance = path.radiance + passage.emission;
        path.throughput = passage.throughput;
        path.media = passage.media;
        path.alive = without(path.alive, passage.lost);
        vertex.closure = select_closure(scattered, phase_closure(passage.phase, passage.asymmetry), vertex.closure);
        vertex.point.position = passage.position;
        vertex.point.normal = -path.direction;
        vertex.point.shading = -path.direction;
    } else {
        hit = closest_there(world, path.numbers, DECISION_LAYERS + depth * DECISIONS_OF_LAYERS, path.nanometres, path.alive, ray, passed,
                            path.throughput);
    }
    Mask met = both(path.alive, is_above(hit.object, Int(-1)));
    Mask here = both(path.alive, either(met, scattered));
    Mask missed = without(path.alive, here);
    bool seen = depth > 0 || world.sky.visible != 0;
    if (world.environment >= 0 && seen && some(missed)) {
        meet_surroundings(world, missed, path);
    }
    path.alive = here;
    if (world.watched != 0) {
        sight.hit = hit;
        sight.hit.t = before + passed + hit.t;
        sight.met = path.radiance;
    }
    if (some(here)) {
        Float distance = passed + hit.t;
        path.width = path.width + path.spread * (before + select(met, distance, Float(0.0f)));
        Float which = Float(0.0f);
        if (world.has_choices != 0) {
            Vec2 u = decide(path, depth, DECISION_SURVIVAL);
            which = u.y;
        }
        find_vertex(world, ray, hit, path.width, which, path.nanometres, met, vertex);
        Mask thin = is_equal(vertex.closure.kind, Int(BSDF_THIN_DIELECTRIC));
        Mask body = both(here, is_clear(vertex.closure));
        Int front = path.media.first;
        if (world.has_transparency != 0) {
            front = select(both(body, vertex.inside), medium_before(path.media, vertex.material, vertex.inside), front);
            Spectrum left_over = left_of_light(world, front, distance, path.nanometres, met);
            path.throughput = path.throughput * left_over;
        }
        Mask shining = without(here, is_black(vertex.emission));
        if (some(shining)) {
            meet_emitter(world, vertex, hit.part, shining, path);
        }
        if (world.watched != 0) {
            sight.vertex = vertex;
            sight.met = path.radiance;
        }

        // The surface, turned to the path's side.
        Vec3 view = -ray.direction;
        Vec3 normal = select(vertex.inside, -vertex.point.normal, vertex.point.normal);
        Vec3 shading = select(vertex.inside, -vertex.point.shading, vertex.point.shading);
        shading = select(vertex.hills < Float(0.0f), seen_normal(normal, shading, view), shading);
        Frame frame = frame_around(shading);
        if (world.has_directions != 0) {
            frame = frame_along(shading, vertex.point.along_u);
        }
        Vec3 wo = to_local(frame, view);
        if (world.has_own_coats != 0) {
            vertex.closure.coat_normal = seen_coat(vertex, frame, normal, view);
        }
        Mask clear = either(body, both(here, thin));
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
            choice.y = select(vertex.pane, Float(0.0f), choice.y);  // it would have been passed: it mirrors
            Vec3 facing = select(is_opaque(vertex.closure), normal, vec3_all(Float(0.0f)));
            Mask asking = without(going, is_smooth(vertex.closure));
            if (world.emitter_count > 0 && world.ways != WAYS_BSDF && some(asking)) {
                Int behind = select(sheet, front, beyond.first);
                ask_emitter(world, depth, vertex, frame, normal, facing, wo, front, behind, beyond, choice.x,
                            decide(path, depth, DECISION_LIGHT), asking, path, tally);
            }
            BsdfSample next = bsdf_sample(world, vertex.closure, wo, choice.y, decide(path, depth, DECISION_DIRECTION), going);
            Vec3 direction = normalize(to_world(frame, next.wi));
            next.weight = next.weight * between_hills(vertex.hills, vertex.smooth_, direction);
            Float rises = dot(direction, normal);
            Mask right_side = either(both(next.transmits, rises < Float(0.0f)), without(rises > Float(0.0f), next.transmits));
            if (world.has_media != 0) {
                right_side = either(right_side, is_phase(vertex.closure));
            }
            going = both(both(going, next.valid), right_side);
            if (world.limits.limited != 0) {
                Mask matt = is_matt(vertex.closure);
                going = both(going, may_scatter(world, path.scattered, matt, next.transmits));
                UInt one = select(next.transmits, UInt(ONE_TRANSMISSION), select(matt, UInt(1u), UInt(ONE_GLOSSY)));
                path.scattered = path.scattered + one;
            }
            path.throughput = path.throughput * next.weight;
            path.density = next.density;
            path.facing = facing;
            if (world.beam > 0.0f) {
                path.spread = max(path.spread, scattered_spread(next.density));
            }
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
