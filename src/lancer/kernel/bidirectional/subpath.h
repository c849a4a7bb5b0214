// One half of a path, from the camera or from a light, vertex by vertex.
//
// What a light's half carries is power: where it passes into a denser medium it is not squeezed together as radiance is, and where shading normals
// are not those of the surface it is weighed so that both halves see the same material [Veach 1997, 5.2, 5.3].
#ifndef LANCER_KERNEL_BIDIRECTIONAL_SUBPATH_H
#define LANCER_KERNEL_BIDIRECTIONAL_SUBPATH_H

#include "lancer/kernel/bidirectional/around.h"
#include "lancer/kernel/bidirectional/vertex.h"
#include "lancer/kernel/emitter/emission.h"
#include "lancer/kernel/importance.h"

NAMESPACE_BEGIN

const float MOST_WAYS = 1.0e18f;    // sums of squares are cut off here: the way at hand counts nothing then
const float MOST_DENSITY = 1.0e8f;  // and densities here, so that no product is infinite

// What photons that are merged add to the weights: squares of how many times more often than one joint a merged pair is found; 0: none is merged.
struct MergeWeights {
    Float merge;  // pi r^2 times the number of photons, squared
    Float join;   // its reciprocal
};

FN MergeWeights no_merging() {
    MergeWeights w;
    w.merge = Float(0.0f);
    w.join = Float(0.0f);
    return w;
}

struct Subpath {
    PathState path;
    Ways ways;
    Spectrum thick;  // `thick` of the vertex that it left
    Float start;     // largest part of the throughput where it began
    Mask single;     // has given up all wavelengths but the first
    Mask parallel;   // its density does not fall with the distance to the next vertex
    Mask straight;   // all its vertices have been mirrors and smooth borders
};

FN Float square_of_density(Float density) { return square(min(density, Float(MOST_DENSITY))); }

FN Ways limited_ways(IN(Ways) ways) {
    Ways w;
    w.meet = min(ways.meet, Float(MOST_WAYS));
    w.join = min(ways.join, Float(MOST_WAYS));
    w.merge = min(ways.merge, Float(MOST_WAYS));
    return w;
}

FN Ways no_ways() {
    Ways w;
    w.meet = Float(0.0f);
    w.join = Float(0.0f);
    w.merge = Float(0.0f);
    return w;
}

// ---- Densities of going the other way. -----------------------------------------------------------------------------------------------------

// The same border, met from the other side.
FN Closure seen_from_behind(IN(Closure) c) {
    Closure other = c;
    Mask turned = without(is_clear(c), c.thin);
    other.index = select(turned, vec4_all(Float(1.0f)) / c.index, c.index);
    return other;
}

FN Vec3 turned_over(Vec3 w) { return vec3_of(w.x, w.y, -w.z); }

// With which `wo` would have been drawn by who comes from `wi`.
FN Float density_back(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Vec3 wi, Mask mask) {
    Float density = Float(0.0f);
    Mask above = both(mask, wi.z > Float(0.0f));
    Mask below = both(mask, wi.z < Float(0.0f));
    if (some(above)) {
        BsdfValue v = bsdf_value(world, c, wi, wo, above);
        density = select(above, v.density, density);
    }
    if (some(below)) {
        BsdfValue v = bsdf_value(world, seen_from_behind(c), turned_over(wi), turned_over(wo), below);
        density = select(below, v.density, density);
    }
    return density;
}

// The chance that a path flies the whole way to a vertex, but for what is the same for every path of this shape: the mean over its wavelengths.
FN Float thinning(IN(WorldRecord) world, Spectrum thinned) {
    Float mean = Float(1.0f);
    if (world.spectral != 0) {
        mean = sum_of(thinned) * Float(0.25f);
    } else {
        mean = ((thinned.x + thinned.y) + thinned.z) * Float(1.0f / 3.0f);
    }
    return max(mean, Float(1.0e-12f));
}

// Photons are kept on surfaces only.
FN MergeWeights merging_at(IN(MergeWeights) merging, Mask floats) {
    MergeWeights w;
    w.merge = select(floats, Float(0.0f), merging.merge);
    w.join = merging.join;
    return w;
}

// What makes the material's value for radiance along wo, with light from wi, that for light from wo which goes on along wi.
FN Float light_correction(IN(BidirVertex) v, Vec3 wi, Vec3 direction, Mask through) {
    Float leaves = abs(dot(direction, v.normal));
    Float into = abs(dot(to_world(v.frame, v.wo), v.normal));
    Float correction = abs(v.wo.z) * leaves / max(into * abs(wi.z), Float(SMALLEST));
    Float eta = v.closure.index.x;
    Mask bends = without(both(through, is_clear(v.closure)), v.sheet);
    return select(v.floats, Float(1.0f), correction * select(bends, eta * eta, Float(1.0f)));
}

// ---- The next vertex. -----------------------------------------------------------------------------------------------------------------------

struct Meeting {
    PathVertex surface;
    Int part;  // the triangle of a mesh
    Float distance;
    Float cosine;   // of the ray and the surface's normal, times the thinning of media; that alone where nothing was met
    Float thinned;  // the chance to fly to what was met, and back
    Float leaves;   // back to the vertex before: per metre where that floats
    Spectrum glow;  // what media have added
    Mask here;
    Mask missed;
};

// From the subpath's ray to the vertex `v`. `depth` counts the vertices before it, the camera or the light not among them.
FN_LARGE void meet_vertex(IN(WorldRecord) world, int depth, bool from_light, INOUT(Subpath) sub, INOUT(Meeting) met, INOUT(BidirVertex) v) {
    Ray ray;
    ray.origin = sub.path.origin;
    ray.direction = sub.path.direction;
    ray.reach = Float(FAR);
    Float passed = Float(0.0f);
    Hit hit;
    met.surface = no_vertex();
    met.thinned = Float(1.0f);
    met.leaves = Float(1.0f);
    met.glow = black();
    Spectrum passed_media = vec4_all(Float(1.0f));
    v.thick = vec4_all(Float(1.0f));
    v.floats = nowhere();
    if (world.has_media != 0) {
        // Who has given up all wavelengths but the first flies as that one does.
        Vec4 carried = sub.path.throughput;
        carried = select(sub.single, vec4_of(carried.x, Float(0.0f), Float(0.0f), Float(0.0f)), carried);
        Passage passage = pass_media(world, sub.path.numbers, depth, sub.path.origin, sub.path.direction, sub.path.media, carried,
                                     sub.path.nanometres, sub.path.alive);
        ray.origin = passage.ray.origin;
        hit = passage.hit;
        passed = passage.passed;
        v.floats = passage.scattered;
        v.thick = select(v.floats, passage.extinction, v.thick);
        sub.path.throughput = passage.throughput;
        sub.path.media = passage.media;
        sub.path.alive = without(sub.path.alive, passage.lost);
        met.surface.closure = select_closure(v.floats, phase_closure(passage.phase, passage.asymmetry), met.surface.closure);
        met.surface.point.position = passage.position;
        met.surface.point.normal = -sub.path.direction;
        met.surface.point.shading = -sub.path.direction;
        passed_media = passage.thinned;
        met.thinned = thinning(world, passed_media);
        met.leaves = thinning(world, sub.thick * passed_media);
        met.glow = passage.emission;
        met.distance = passage.before + select(v.floats, Float(0.0f), passed + hit.t);
    } else {
        hit = closest_there(world, sub.path.numbers, DECISION_LAYERS + depth * DECISIONS_OF_LAYERS, sub.path.nanometres, sub.path.alive,
                            ray, passed, sub.path.throughput);
        met.distance = passed + hit.t;
    }
    Mask struck = both(sub.path.alive, is_above(hit.object, Int(-1)));
    Mask here = both(sub.path.alive, either(struck, v.floats));
    met.here = here;
    met.missed = without(sub.path.alive, here);
    met.part = hit.part;
    met.cosine = met.thinned;
    v.valid = here;
    sub.path.alive = here;
    if (some(here)) {
        sub.path.width = sub.path.width + sub.path.spread * met.distance;
        Float which = Float(0.0f);
        if (world.has_choices != 0) {
            Vec2 u = decide(sub.path, depth, DECISION_SURVIVAL);
            which = u.y;
        }
        find_vertex(world, ray, hit, sub.path.width, which, sub.path.nanometres, struck, met.surface);
        Mask inside = met.surface.inside;
        Mask thin = is_equal(met.surface.closure.kind, Int(BSDF_THIN_DIELECTRIC));
        Mask body = both(here, is_clear(met.surface.closure));
        Int front = sub.path.media.first;
        if (world.has_transparency != 0) {
            front = select(both(body, inside), medium_before(sub.path.media, met.surface.material, inside), front);
            sub.path.throughput = sub.path.throughput * left_of_light(world, front, passed + hit.t, sub.path.nanometres, struck);
        }
        Vec3 view = -ray.direction;
        v.position = met.surface.point.position;
        v.error = met.surface.point.error;
        v.normal = select(inside, -met.surface.point.normal, met.surface.point.normal);
        Vec3 shading = select(inside, -met.surface.point.shading, met.surface.point.shading);
        v.smooth_ = met.surface.smooth_;
        v.hills = met.surface.hills;
        if (!from_light) {
            shading = select(v.hills < Float(0.0f), seen_normal(v.normal, shading, view), shading);
        }
        v.frame = frame_around(shading);
        if (world.has_directions != 0) {
            v.frame = frame_along(shading, met.surface.point.along_u);
        }
        v.wo = to_local(v.frame, view);
        if (world.has_own_coats != 0) {
            met.surface.closure.coat_normal = seen_coat(met.surface, v.frame, v.normal, view);
        }
        met.cosine = select(here, max(abs(dot(view, v.normal)), Float(1.0e-12f)), met.cosine);
        Mask clear = either(body, both(here, thin));
        Media beyond = sub.path.media;
        if (some(clear)) {
            find_border(world, sub.path, clear, thin, met.surface, beyond);
        }
        v.closure = met.surface.closure;
        v.disperses = v.closure.disperses;
        v.closure.disperses = nowhere();  // both halves must agree on who gives up which wavelengths: see `single`
        v.sheet = either(thin, v.closure.thin);
        v.pane = met.surface.pane;
        v.front = front;
        v.behind = select(v.sheet, front, beyond.first);
        v.around = sub.path.media;
        v.beyond = select_media(v.sheet, sub.path.media, beyond);
        if (from_light) {
            // What hills hide of the light is known as soon as it arrives.
            sub.path.throughput = sub.path.throughput * between_hills(v.hills, v.smooth_, view);
        }
        v.throughput = sub.path.throughput;
        v.single = sub.single;
        if (world.has_media != 0) {
            Float through = thinning(world, v.thick * passed_media);
            met.cosine = select(v.floats, through, select(here, met.cosine * met.thinned, met.cosine));
        }
        // Through the distance, and onto the surface.
        Float distance_2 = min(met.distance * met.distance, Float(1.0e18f));
        Float grown = select(sub.parallel, Float(1.0f), square(distance_2));
        Float cosine_2 = square(met.cosine);
        Float leaves_2 = square(met.leaves);
        sub.ways.meet = sub.ways.meet * grown / cosine_2;
        sub.ways.join = sub.ways.join * leaves_2 / cosine_2;
        sub.ways.merge = sub.ways.merge * leaves_2 / cosine_2;
        sub.ways = limited_ways(sub.ways);
        sub.parallel = nowhere();
        v.ways = sub.ways;
        Mask scatters = without(here, is_equal(v.closure.kind, Int(BSDF_NONE)));
        if (from_light) {
            // A camera on this side would not see light that comes from below the shading normal.
            scatters = both(scatters, v.wo.z > Float(0.0f));
        }
        v.valid = without(scatters, is_smooth(v.closure));
        sub.path.alive = scatters;
    }
}

// ---- And the ray onwards. -------------------------------------------------------------------------------------------------------------------

// `part`: in [0, 1), which part of the material sends it on.
FN_LARGE void scatter_subpath(IN(WorldRecord) world, int depth, bool from_light, Float part, IN(BidirVertex) v, IN(MergeWeights) merging,
                              INOUT(Subpath) sub) {
    Mask going = sub.path.alive;
    Float chosen = select(v.pane, Float(0.0f), part);  // a pane that is met mirrors: else it would have been passed
    BsdfSample next = bsdf_sample(world, v.closure, v.wo, chosen, decide(sub.path, depth, DECISION_DIRECTION), going);
    Vec3 direction = normalize(to_world(v.frame, next.wi));
    Float rises = dot(direction, v.normal);
    Mask right_side = either(both(next.transmits, rises < Float(0.0f)), without(rises > Float(0.0f), next.transmits));
    right_side = either(right_side, v.floats);
    going = both(both(going, next.valid), right_side);
    sub.path.throughput = sub.path.throughput * next.weight;
    Mask through = both(going, next.transmits);
    if (from_light) {
        sub.path.throughput = sub.path.throughput * light_correction(v, next.wi, direction, through);
    } else {
        sub.path.throughput = sub.path.throughput * between_hills(v.hills, v.smooth_, direction);
    }
    sub.single = either(sub.single, both(through, v.disperses));
    sub.straight = both(sub.straight, next.discrete);

    // The other ways to what comes after. Smooth surfaces have none: what they pass on can't be joined.
    Float out_2 = select(v.floats, Float(1.0f), square(abs(rises)));
    Float merges = select(v.floats, Float(0.0f), Float(1.0f));
    Float back = density_back(world, v.closure, v.wo, next.wi, without(going, next.discrete));
    Float there_2 = square_of_density(max(next.density, Float(1.0e-8f)));
    Float back_2 = square_of_density(back);
    Ways rough;
    rough.meet = Float(1.0f) / there_2;
    rough.join = out_2 / there_2 * (sub.ways.join * back_2 + sub.ways.meet + merges * merging.merge);
    rough.merge = out_2 / there_2 * (sub.ways.merge * back_2 + sub.ways.meet * merging.join + merges);
    sub.ways.meet = select(next.discrete, Float(0.0f), rough.meet);
    sub.ways.join = select(next.discrete, sub.ways.join * out_2, rough.join);
    sub.ways.merge = select(next.discrete, sub.ways.merge * out_2, rough.merge);
    sub.ways = limited_ways(sub.ways);

    sub.path.density = next.density;
    sub.path.facing = select(is_opaque(v.closure), v.normal, vec3_all(Float(0.0f)));
    if (world.beam > 0.0f && !from_light) {
        sub.path.spread = max(sub.path.spread, scattered_spread(next.density));
    }
    sub.path.origin = leave_surface(v.position, v.error, v.normal, direction);
    sub.path.direction = direction;
    Mask crosses = without(through, v.sheet);
    sub.path.media = select_media(crosses, v.beyond, sub.path.media);
    sub.thick = v.thick;
    Float eta = v.closure.index.x;
    if (!from_light) {
        sub.path.squeeze = select(crosses, sub.path.squeeze * eta * eta, sub.path.squeeze);
    }
    going = without(going, is_black(sub.path.throughput));
    if (depth >= ROULETTE_FROM) {
        Float survives = min(largest(sub.path.throughput) * sub.path.squeeze / max(sub.start, Float(SMALLEST)), Float(0.95f));
        Vec2 u = decide(sub.path, depth, DECISION_SURVIVAL);
        going = both(going, u.x < survives);
        sub.path.throughput = sub.path.throughput / max(survives, Float(SMALLEST));
    }
    sub.path.alive = going;
}

NAMESPACE_END

#endif
