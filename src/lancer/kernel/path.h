// The path tracer: light is followed backwards from the camera, from surface to surface; at each vertex one emitter is asked for its light, and
// the path goes on in a direction drawn from the material. Emitters that it meets by itself count, too; where both ways could have found the same
// light, each has the weight that the power heuristic gives it [Veach 1997]. The radiance that a path brings is an unbiased estimate.
#ifndef LANCER_KERNEL_PATH_H
#define LANCER_KERNEL_PATH_H

#include "lancer/kernel/path_border.h"
#include "lancer/kernel/path_light.h"

NAMESPACE_BEGIN

const int ROULETTE_FROM = 3;  // vertices that are never ended by chance

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
