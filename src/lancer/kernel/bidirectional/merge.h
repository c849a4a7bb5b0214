// Photons: vertices of paths of light that end near a vertex of the camera's half, as if both were the same. That finds what no joint can, light
// that smooth surfaces throw and that is seen through smooth surfaces; for the price of a picture that is a little too smooth, less and less so with
// every sample, since the photons of each are gathered from a smaller disk [Hachisuka et al. 2008; Georgiev et al. 2012].
#ifndef LANCER_KERNEL_BIDIRECTIONAL_MERGE_H
#define LANCER_KERNEL_BIDIRECTIONAL_MERGE_H

#include "lancer/kernel/bidirectional/join.h"
#include "lancer/kernel/bidirectional/start.h"

NAMESPACE_BEGIN

const float SHRINKING = 0.125f;     // the radius falls with this power of the sample's number: (1 - 3/4) / 2
const float PHOTON_REACH = 0.004f;  // radius for the first sample, over that of a sphere around the scene
const float LEAST_LIKENESS = 0.7f;  // cosine between the normals of two places that are taken for one

struct Photon {
    Vec3 position;
    Vec3 normal;  // of the surface, on the side that it came from
    Vec3 from;    // direction to where it came from
    Spectrum light;
    Ways ways;
    Int depth;  // vertices of its path before it
    Mask single;
};

// The device gathers the photons within `radius` of each lane's place, and tells how many there are; then one after another.
FN Int gather_photons(IN(WorldRecord) world, Vec3 position, Float radius, Mask mask);
FN Photon gathered_photon(IN(WorldRecord) world, int number, Mask mask);

// The photons that belong to one sample of all pixels.
struct PhotonField {
    Float radius;
    Float paths;
};

FN PhotonField photon_field(IN(WorldRecord) world, int sample_number) {
    PhotonField f;
    f.radius = Float(PHOTON_REACH * world.scene_radius) * power(Float(float(sample_number + 1)), Float(-SHRINKING));
    f.paths = Float(float(PHOTON_PATHS));
    return f;
}

// How many photons a disk of that radius gathers of a path that is sure to end on one square metre.
FN Float gathering(IN(PhotonField) field) { return Float(PI) * field.radius * field.radius * field.paths; }

// Photons are many, but those of one disk err together: where joints do as well they are to be preferred. So merging counts as if it had only so many
// of them. Where nothing else finds the path it has all the weight whatever it counts.
const float PHOTON_TRUST = 0.02f;

FN MergeWeights merge_weights(IN(PhotonField) field) {
    MergeWeights w;
    w.merge = square(gathering(field) * Float(PHOTON_TRUST));
    w.join = Float(1.0f) / w.merge;
    return w;
}

// All pixels share a sample's wavelengths, so that all photons of that sample have them, too.
FN Vec4 photon_wavelengths(IN(WorldRecord) world, int sample_number, Mask mask) {
    Vec4 nanometres = vec4_all(Float(D_LINE));
    if (world.spectral != 0) {
        Sampler numbers = start_sampler(scramble(scramble(UInt(uint(world.seed))) ^ UInt(0x50484f54u)), UInt(uint(sample_number)));
        nanometres = wavelengths_at(world, quartered_number(numbers, UInt(uint(sample_number)), UInt(uint(DECISION_WAVELENGTH))), mask);
    }
    return nanometres;
}

// The number of a path of light that leaves photons for a sample; apart from those that are joined.
FN UInt number_of_photons(int sample_number, UInt path) {
    return UInt(uint(sample_number) * uint(PHOTON_PATHS)) + path + UInt(0x80000000u);
}

// The photon that the vertex of a path of light after `depth` others leaves there. Only where `v.valid`.
FN_LARGE void photon_step(IN(WorldRecord) world, int depth, IN(LightStart) start, IN(MergeWeights) merging, INOUT(Subpath) sub,
                          INOUT(BidirVertex) v) {
    Meeting met;
    meet_vertex(world, depth, true, sub, met, v);
    if (depth >= world.max_depth) {
        v.valid = nowhere();
        sub.path.alive = nowhere();
    }
    if (some(sub.path.alive)) {
        if (depth == 0) {
            sub.ways = ways_of_first_light(world, start, met, v, merging);
            v.ways = sub.ways;
        }
        Vec2 choice = decide(sub.path, depth, DECISION_CHOICE);
        scatter_subpath(world, depth, true, choice.y, v, merging, sub);
        v.valid = without(v.valid, v.floats);
    } else {
        v.valid = nowhere();
    }
}

// What the photons around a vertex of the camera's half bring.
FN_LARGE Spectrum merge_photons(IN(WorldRecord) world, int depth, IN(BidirVertex) v, IN(PhotonField) field, IN(MergeWeights) merging,
                                Mask asking) {
    Spectrum found = black();
    Int count = gather_photons(world, v.position, field.radius, asking);
    Float share = Float(1.0f) / gathering(field);
    Mask left_over = both(asking, is_above(count, Int(0)));
    for (int i = 0; some(left_over); ++i) {
        Photon p = gathered_photon(world, i, left_over);
        Vec3 wi = to_local(v.frame, p.from);
        Float rises = dot(p.from, v.normal);
        Mask alike = abs(dot(p.normal, v.normal)) > Float(LEAST_LIKENESS);
        Mask good = both(both(left_over, alike), both(wi.z * rises > Float(0.0f), is_above(Int(world.max_depth - depth), p.depth)));
        if (some(good)) {
            BsdfValue value = bsdf_value(world, v.closure, v.wo, wi, good);
            good = without(good, is_black(value.value));
            Float back = density_back(world, v.closure, v.wo, wi, good);
            Float by_light = p.ways.meet * merging.join + p.ways.merge * square_of_density(value.density);
            Float by_camera = v.ways.meet * merging.join + v.ways.merge * square_of_density(back);
            Float weight = share / ((Float(1.0f) + by_light + by_camera) * max(abs(rises), Float(1.0e-6f)));
            Mask single = either(either(v.single, p.single), both(wi.z < Float(0.0f), v.disperses));
            weight = weight * between_hills(v.hills, v.smooth_, p.from);
            Spectrum brought = first_alone(v.throughput * value.value * p.light * weight, single);
            found = select(good, found + brought, found);
        }
        left_over = both(left_over, is_above(count, Int(i + 1)));
    }
    return found;
}

NAMESPACE_END

#endif
