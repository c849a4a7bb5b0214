// A path on its way: what it carries, where it goes on, and which numbers decide.
#ifndef LANCER_KERNEL_PATH_STATE_H
#define LANCER_KERNEL_PATH_STATE_H

#include "lancer/kernel/camera.h"
#include "lancer/kernel/medium.h"
#include "lancer/kernel/pixel_filter.h"
#include "lancer/kernel/sampler.h"
#include "lancer/kernel/spectral.h"
#include "lancer/kernel/volume/bodies.h"
#include "lancer/kernel/warp.h"

NAMESPACE_BEGIN

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

NAMESPACE_END

#endif
