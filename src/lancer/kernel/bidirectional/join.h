// Joints: a vertex of the camera's half with a light, with a vertex of light's half, and that with the camera. Each brings the light of its path,
// times its weight among all the ways in which that path could have been found [Veach 1997, 10.2; Georgiev 2012].
#ifndef LANCER_KERNEL_BIDIRECTIONAL_JOIN_H
#define LANCER_KERNEL_BIDIRECTIONAL_JOIN_H

#include "lancer/kernel/bidirectional/start.h"

NAMESPACE_BEGIN

// Light that has given up all wavelengths but the first: that one stands for all four.
FN Spectrum first_alone(Spectrum light, Mask single) {
    return select(single, vec4_of(light.x * Float(4.0f), Float(0.0f), Float(0.0f), Float(0.0f)), light);
}

// What a vertex sends along `direction`.
struct Outwards {
    Spectrum value;  // the material's value times the cosine; of light's half corrected, see light_correction
    Float density;   // of going there
    Float back;      // of coming from there and going to where it came from
    Float cosine;    // to the surface's normal; 1 in a medium
    Mask single;
    Mask through;
    Mask open;
};

FN Outwards send_out(IN(WorldRecord) world, IN(BidirVertex) v, Vec3 direction, bool from_light, Mask mask) {
    Outwards o;
    Vec3 wi = to_local(v.frame, direction);
    Float rises = dot(direction, v.normal);
    o.cosine = select(v.floats, Float(1.0f), abs(rises));
    o.open = both(both(mask, v.valid), either(v.floats, wi.z * rises > Float(0.0f)));
    BsdfValue value = bsdf_value(world, v.closure, v.wo, wi, o.open);
    o.open = without(o.open, is_black(value.value));
    o.value = value.value;
    o.density = value.density;
    o.back = Float(0.0f);
    Mask through = without(wi.z < Float(0.0f), v.floats);
    o.single = both(through, v.disperses);
    o.through = through;
    if (some(o.open)) {
        o.back = density_back(world, v.closure, v.wo, wi, o.open);
        if (from_light) {
            o.value = o.value * light_correction(v, wi, direction, through);
        } else {
            o.value = o.value * between_hills(v.hills, v.smooth_, direction);
        }
    }
    return o;
}

FN Int medium_towards(IN(BidirVertex) v, Vec3 direction) { return select(dot(direction, v.normal) > Float(0.0f), v.front, v.behind); }

FN Media media_towards(IN(BidirVertex) v, IN(Outwards) o) { return select_media(o.through, v.beyond, v.around); }

// Numbers for what media leave of light between two vertices.
FN Sampler joint_numbers(IN(Sampler) numbers, int camera_vertex, int light_vertex) {
    Sampler s = numbers;
    s.key = scramble(scramble(numbers.key ^ UInt(0x4a4f494eu)) + UInt(uint(camera_vertex * 1024 + light_vertex)));
    return s;
}

// From just off one surface to just before another point.
FN Ray ray_between(IN(BidirVertex) v, Vec3 direction, Vec3 end) {
    Ray ray;
    ray.origin = leave_surface(v.position, v.error, v.normal, direction);
    Vec3 way = end - ray.origin;
    ray.reach = length(way);
    ray.direction = way / max(ray.reach, Float(SMALLEST));
    return ray;
}

// What reaches the end of a ray between two vertices.
struct Passing {
    Spectrum share;
    Spectrum thinned;  // of a path that flies there
    Mask lit;
};

// `medium`, `distance`: where nothing scatters. Numbers from `decision` on.
FN Passing pass_between(IN(WorldRecord) world, IN(Ray) shadow, IN(Media) around, Int medium, Float distance, Vec4 nanometres,
                        IN(Sampler) numbers, UInt decision, Mask going) {
    Passing p;
    p.thinned = vec4_all(Float(1.0f));
    if (world.has_media != 0) {
        p.share = passing_thinned(world, shadow, around, nanometres, numbers, decision, going, p.thinned);
        p.lit = without(going, is_black(p.share));
    } else {
        p.share = passing_light(world, shadow, nanometres, going);
        p.lit = without(going, is_black(p.share));
        if (world.has_transparency != 0) {
            Mask near = both(p.lit, shadow.reach < Float(FAR));
            p.share = p.share * left_of_light(world, medium, distance, nanometres, near);
        }
    }
    return p;
}

// The density of vertices at `v` of paths that come along that way, over their density per solid angle and the distance's square.
FN Float arrival(IN(WorldRecord) world, IN(BidirVertex) v, Float cosine, Spectrum thinned) {
    Float a = cosine;
    if (world.has_media != 0) {
        a = cosine * thinning(world, v.thick * thinned);
    }
    return a;
}

FN Float flown(IN(WorldRecord) world, Spectrum thinned) {
    Float f = Float(1.0f);
    if (world.has_media != 0) {
        f = thinning(world, thinned);
    }
    return f;
}

// ---- The camera's half and a light that is asked. -------------------------------------------------------------------------------------------

FN_LARGE Spectrum join_emitter(IN(WorldRecord) world, int depth, IN(BidirVertex) v, IN(Subpath) sub, Float choice, Vec2 u, Mask asking,
                               IN(MergeWeights) merging, INOUT(RayTally) tally) {
    Spectrum found = black();
    Vec3 facing = select(is_opaque(v.closure), v.normal, vec3_all(Float(0.0f)));
    EmitterChoice chosen = choose_emitter(world, v.position, facing, choice, asking);
    Mask going = both(both(asking, is_above(chosen.emitter, Int(-1))), chosen.chance > Float(0.0f));
    Ray shadow;
    shadow.origin = v.position;
    shadow.direction = v.normal;
    shadow.reach = Float(0.0f);
    Spectrum light = black();
    Float density = Float(1.0f);
    Float sent = Float(0.0f);  // how often a path of light comes this way, over how often it is asked for
    Mask discrete = nowhere();
    Mask todo = going;
    while (some(todo)) {
        int number = first_of(chosen.emitter, todo);
        Mask mine = both(todo, is_equal(chosen.emitter, Int(number)));
        EmitterRecord emitter = AT(world.emitters, number);
        EmitterSample s = emitter_sample(world, emitter, v.position, u, mine);
        Mask good = both(mine, s.valid);
        light = select(good, emitted_light(world, emitter, s, sub.path.nanometres, good), light);
        density = select(good, s.density, density);
        discrete = either(discrete, both(good, s.discrete));
        EmissionDensity back = emission_density(world, emitter, s.point, -s.direction, v.position, s.place, good);
        Mask far = s.distance >= Float(FAR);
        Float slant = select(s.discrete, s.distance * s.distance, abs(dot(s.direction, s.point.normal)));
        slant = select(far, Float(1.0f), slant);
        Float ratio = back.place * back.direction * emission_chance(world, number, good) / max(s.density * slant, Float(SMALLEST));
        sent = select(good, ratio, sent);
        Vec3 start = leave_surface(v.position, v.error, v.normal, s.direction);
        shadow = select_ray(good, ray_to_emitter(s, start), shadow);
        todo = without(todo, mine);
    }
    going = without(both(going, shadow.reach > Float(0.0f)), is_black(light));
    if (some(going)) {
        Outwards forth = send_out(world, v, shadow.direction, false, going);
        going = forth.open;
        if (some(going)) {
            tally.shadow += lanes_in(going);
            UInt decision = UInt(uint(DECISION_DIMMING + depth * DECISIONS_OF_DIMMING));
            Passing passing = pass_between(world, shadow, media_towards(v, forth), medium_towards(v, shadow.direction), shadow.reach,
                                           sub.path.nanometres, sub.path.numbers, decision, going);
            Float asked = density * chosen.chance;
            Float by_chance = select(discrete, Float(0.0f), square_of_density(forth.density * flown(world, passing.thinned) / asked));
            Float by_light = square_of_density(sent * arrival(world, v, forth.cosine, passing.thinned) / chosen.chance) *
                             (merging_at(merging, v.floats).merge + v.ways.meet + v.ways.join * square_of_density(forth.back));
            Float weight = Float(1.0f) / (asked * (Float(1.0f) + by_chance + by_light));
            Spectrum brought = v.throughput * forth.value * light * passing.share * weight;
            found = select(passing.lit, first_alone(brought, either(v.single, forth.single)), found);
        }
    }
    return found;
}

// ---- The camera's half and light's. ---------------------------------------------------------------------------------------------------------

// `numbers`: for this pair.
FN_LARGE Spectrum join_vertices(IN(WorldRecord) world, IN(BidirVertex) v, IN(BidirVertex) l, Vec4 nanometres, IN(Sampler) numbers,
                                Mask asking, IN(MergeWeights) merging, INOUT(RayTally) tally) {
    Spectrum found = black();
    Vec3 way = l.position - v.position;
    Float distance_2 = dot(way, way);
    Mask going = both(both(asking, both(v.valid, l.valid)), distance_2 > Float(0.0f));
    Float distance = sqrt(max(distance_2, Float(SMALLEST)));
    Vec3 direction = way / distance;
    going = both(going, either(v.floats, abs(dot(direction, v.normal)) > Float(0.0f)));
    if (some(going)) {
        Outwards forth = send_out(world, v, direction, false, going);
        going = forth.open;
        if (some(going)) {
            Outwards into = send_out(world, l, -direction, true, going);
            going = into.open;
            Spectrum brought = v.throughput * forth.value * (l.throughput * into.value) / max(distance_2, Float(SMALLEST));
            going = without(going, is_black(brought));
            if (some(going)) {
                tally.shadow += lanes_in(going);
                Ray shadow = ray_between(v, direction, before_surface(l.position, l.error, l.normal, distance, -direction));
                Passing passing = pass_between(world, shadow, media_towards(v, forth), medium_towards(v, direction), distance, nanometres,
                                               numbers, UInt(0u), going);
                Float by_camera = square_of_density(forth.density * arrival(world, l, into.cosine, passing.thinned) / distance_2) *
                                  (merging_at(merging, l.floats).merge + l.ways.meet + l.ways.join * square_of_density(into.back));
                Float by_light = square_of_density(into.density * arrival(world, v, forth.cosine, passing.thinned) / distance_2) *
                                 (merging_at(merging, v.floats).merge + v.ways.meet + v.ways.join * square_of_density(forth.back));
                Float weight = Float(1.0f) / (Float(1.0f) + by_camera + by_light);
                Mask single = either(either(v.single, l.single), either(forth.single, into.single));
                found = select(passing.lit, first_alone(brought * passing.share * weight, single), found);
            }
        }
    }
    return found;
}

// ---- Light's half and the camera. -----------------------------------------------------------------------------------------------------------

// Light for the film, wherever it falls.
struct FilmSplat {
    Vec2 film;       // pixels from the upper left corner
    Spectrum light;  // to be weighed by each pixel's filter; a pixel is the mean over all paths of light of `light_paths` times that
    Mask valid;
};

FN FilmSplat no_splat() {
    FilmSplat s;
    s.film = vec2_of(Float(0.0f), Float(0.0f));
    s.light = black();
    s.valid = nowhere();
    return s;
}

FN Vec2 lens_of_light(IN(WorldRecord) world, IN(Sampler) numbers) {
    Vec2 lens = vec2_of(Float(0.0f), Float(0.0f));
    if (world.camera.lens_radius > 0.0f) {
        lens = on_disk(sample_pair(numbers, UInt(uint(DECISION_EMISSION_LENS))));
    }
    return lens;
}

// `weighed`: false where no other way is tried.
FN_LARGE FilmSplat join_camera(IN(WorldRecord) world, int depth, IN(BidirVertex) l, IN(Subpath) sub, Float light_paths, bool weighed,
                               Mask asking, IN(MergeWeights) merging, INOUT(RayTally) tally) {
    FilmSplat splat = no_splat();
    CameraSight sight = see_point(world.camera, l.position, lens_of_light(world, sub.path.numbers), Float(world.filter_record.radius));
    Mask going = both(both(asking, l.valid), sight.valid);
    if (some(going)) {
        // A camera that looks from below the shading normal bends it, as paths do.
        BidirVertex seen = l;
        Vec3 bent = select(dot(sight.direction, l.normal) > Float(0.0f), seen_normal(l.normal, l.frame.z, sight.direction), l.frame.z);
        bent = select(l.hills < Float(0.0f), bent, l.frame.z);
        Vec3 by = bent - l.frame.z;
        Mask turned = both(going, dot(by, by) > Float(0.0f));
        if (some(turned)) {
            Frame frame = frame_along(bent, l.frame.x);
            Vec3 wo = to_local(frame, to_world(l.frame, l.wo));
            seen.frame.x = select(turned, frame.x, l.frame.x);
            seen.frame.y = select(turned, frame.y, l.frame.y);
            seen.frame.z = select(turned, frame.z, l.frame.z);
            seen.wo = select(turned, wo, l.wo);
            going = both(going, either(seen.floats, seen.wo.z > Float(0.0f)));
        }
        Outwards forth = send_out(world, seen, sight.direction, true, going);
        going = forth.open;
        if (some(going)) {
            tally.shadow += lanes_in(going);
            Ray shadow = ray_between(l, sight.direction, l.position + sight.direction * sight.distance);
            UInt decision = UInt(uint(DECISION_DIMMING + depth * DECISIONS_OF_DIMMING));
            Passing passing = pass_between(world, shadow, media_towards(l, forth), medium_towards(l, sight.direction), sight.distance,
                                           sub.path.nanometres, sub.path.numbers, decision, going);
            Mask lit = passing.lit;
            Spectrum brought = l.throughput * forth.value * passing.share * (sight.density / light_paths);
            if (weighed) {
                Float by_camera = square_of_density(sight.density * arrival(world, l, forth.cosine, passing.thinned) / light_paths) *
                                  (merging_at(merging, l.floats).merge + l.ways.meet + l.ways.join * square_of_density(forth.back));
                brought = brought / (Float(1.0f) + by_camera);
            }
            splat.film = sight.film;
            splat.light = select(lit, first_alone(brought, either(l.single, forth.single)), splat.light);
            splat.valid = without(lit, is_black(splat.light));
        }
    }
    return splat;
}

// Rays that look for lamps which are seen at once, for each sample: see glance_step.
const int GLANCES = 4;

// The light itself, seen by the camera. `weighed`: glances look for lamps, too, and for the sky alone.
FN_LARGE FilmSplat join_light_to_camera(IN(WorldRecord) world, IN(LightStart) start, IN(Subpath) sub, Float light_paths, bool weighed,
                                        INOUT(RayTally) tally) {
    FilmSplat splat = no_splat();
    Mask asking = without(start.emission.valid, start.emission.discrete);
    Vec2 lens = lens_of_light(world, sub.path.numbers);
    Float margin = Float(world.filter_record.radius);
    Mask far = start.emission.far;
    CameraSight sight = see_point(world.camera, start.emission.point.position, lens, margin);
    CameraSight sky = see_point(world.camera, broadcast(world.camera.position) - start.emission.direction, lens, margin);
    Mask faces = dot(sight.direction, start.emission.point.normal) > Float(0.0f);
    Float cosine = dot(sight.direction, start.emission.point.normal);
    Mask seen = select_mask(far, both(sky.valid, all_or_none(world.sky.visible != 0 && world.camera.kind != CAMERA_ORTHOGRAPHIC)),
                            both(sight.valid, faces));
    Mask going = both(asking, seen);
    if (weighed) {
        going = without(going, far);
    }
    if (some(going)) {
        // Radiance is even over all directions of a lamp: what was drawn for one serves for another.
        Float undone = start.emission.density.place * start.emission.density.direction / max(start.emission.cosine, Float(SMALLEST));
        Spectrum radiance = start.emission.light * (undone / start.chance);
        // Of lamps with two sides only one was drawn: 2 there, else 1.
        Float sides = start.emission.cosine * Float(1.0f / PI) / max(start.emission.density.direction, Float(SMALLEST));
        Float of_lamp = cosine * sides * sight.density / start.emission.density.place;
        Float of_sky = camera_density(world.camera, -start.emission.direction) / start.emission.density.direction;
        Ray shadow;
        shadow.origin =
            leave_surface(start.emission.point.position, start.emission.point.error, start.emission.point.normal, sight.direction);
        Vec3 way = start.emission.point.position + sight.direction * sight.distance - shadow.origin;
        shadow.reach = length(way);
        shadow.direction = way / max(shadow.reach, Float(SMALLEST));
        shadow.origin = select(far, broadcast(world.camera.position), shadow.origin);
        shadow.direction = select(far, -start.emission.direction, shadow.direction);
        shadow.reach = select(far, Float(FAR), shadow.reach);
        tally.shadow += lanes_in(going);
        Media around = sub.path.media;
        if (world.has_media != 0) {
            around = select_media(far, media_of_camera(world), around);
        }
        Passing passing = pass_between(world, shadow, around, Int(-1), shadow.reach, sub.path.nanometres, sub.path.numbers,
                                       UInt(uint(DECISION_DIMMING_BEFORE)), going);
        Mask lit = passing.lit;
        Float weight = select(far, of_sky, of_lamp) / light_paths;
        if (weighed) {
            Float by_glance = Float(float(GLANCES)) * of_lamp * flown(world, passing.thinned) / (light_paths * start.chance);
            weight = weight / (Float(1.0f) + square_of_density(by_glance));
        }
        splat.film = vec2_of(select(far, sky.film.x, sight.film.x), select(far, sky.film.y, sight.film.y));
        splat.light = select(lit, radiance * passing.share * weight, splat.light);
        splat.valid = without(lit, is_black(splat.light));
    }
    return splat;
}

NAMESPACE_END

#endif
