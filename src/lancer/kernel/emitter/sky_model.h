// A computed clear sky and the sun in it.
//
// The table holds what arrives from a direction as a share of the sun's light outside the air, which has all the fine structure of its spectrum: at
// azimuths from the sun, 0 to 180 degrees in even steps; at elevations (i / (n - 1))^2 * 90 degrees, close to one another at the horizon; at wavelengths.
// It is linear between them. Below the horizon lies the ground, the same in all directions.
#ifndef LANCER_KERNEL_EMITTER_SKY_MODEL_H
#define LANCER_KERNEL_EMITTER_SKY_MODEL_H

#include "lancer/kernel/material.h"

NAMESPACE_BEGIN

// A direction along the sky's own axes: y is up. And back.
FN Vec3 within_sky(IN(SkyRecord) sky, Vec3 direction) {
    Vec3 d = direction;
    if (sky.tilted != 0) {
        d = vec3_of(dot(direction, broadcast(sky.x_axis)), dot(direction, broadcast(sky.y_axis)), dot(direction, broadcast(sky.z_axis)));
    }
    return d;
}

FN Vec3 out_of_sky(IN(SkyRecord) sky, Vec3 direction) {
    Vec3 d = direction;
    if (sky.tilted != 0) {
        d = broadcast(sky.x_axis) * direction.x + broadcast(sky.y_axis) * direction.y + broadcast(sky.z_axis) * direction.z;
    }
    return d;
}

// All that follows is along the sky's own axes.
FN Mask is_in_sun(IN(SkyRecord) sky, Vec3 direction) {
    Vec3 off = direction - broadcast(sky.sun);
    return both(dot(off, off) <= Float(sky.sun_chord), direction.y > Float(0.0f));
}

// Uniform on the sun's disk.
FN Vec3 sun_direction(IN(SkyRecord) sky, Vec2 u) {
    Frame frame = frame_around(broadcast(sky.sun));
    Float off = Float(0.5f * sky.sun_chord) * u.x;  // 1 - cosine
    Float sine = sqrt(max(off * (Float(2.0f) - off), Float(0.0f)));
    Vec2 around = on_circle(u.y);
    return normalize(to_world(frame, vec3_of(sine * around.x, sine * around.y, Float(1.0f) - off)));
}

// Where a direction above the horizon lies in the table, and how far it is to the next entries.
struct ModelPlace {
    Int azimuth;
    Int elevation;
    Float azimuth_rest;
    Float elevation_rest;
};

FN ModelPlace model_place(IN(SkyRecord) sky, Vec3 direction) {
    ModelPlace place;
    Float ring = sqrt(max(direction.x * direction.x + direction.z * direction.z, Float(0.0f)));
    Float steep = max(angle_of(direction.y, ring), Float(0.0f)) * Float(2.0f / PI);
    Float y = sqrt(steep) * Float(float(MODEL_ELEVATIONS - 1));
    Float along = direction.x * Float(sky.sun.x) + direction.z * Float(sky.sun.z);
    Float across = direction.x * Float(sky.sun.z) - direction.z * Float(sky.sun.x);
    Float x = abs(angle_of(across, along)) * Float(1.0f / PI) * Float(float(MODEL_AZIMUTHS - 1));
    Float left = min(floor(x), Float(float(MODEL_AZIMUTHS - 2)));
    Float below = min(floor(y), Float(float(MODEL_ELEVATIONS - 2)));
    place.azimuth = round_to_int(left);
    place.elevation = round_to_int(below);
    place.azimuth_rest = min(x - left, Float(1.0f));
    place.elevation_rest = min(y - below, Float(1.0f));
    return place;
}

// Between the two wavelengths from `at` on.
FN Float model_entry(IN(WorldRecord) world, Int at, Float rest, Mask mask) {
    Float first = gather_float(world.distributions, at, mask);
    Float second = gather_float(world.distributions, at + Int(1), mask);
    return first + (second - first) * rest;
}

FN Float model_share(IN(WorldRecord) world, IN(ModelPlace) place, Float nanometres, Mask mask) {
    Float w = min(max((nanometres - Float(360.0f)) * Float(1.0f / MODEL_STEP), Float(0.0f)), Float(float(MODEL_WAVELENGTHS - 1)));
    Float shorter = min(floor(w), Float(float(MODEL_WAVELENGTHS - 2)));
    Float rest = w - shorter;
    Int at =
        (place.azimuth * Int(MODEL_ELEVATIONS) + place.elevation) * Int(MODEL_WAVELENGTHS) + round_to_int(shorter) + Int(world.sky.model);
    Int higher = Int(MODEL_WAVELENGTHS);
    Int farther = Int(MODEL_ELEVATIONS * MODEL_WAVELENGTHS);
    Float low = model_entry(world, at, rest, mask);
    Float high = model_entry(world, at + higher, rest, mask);
    Float near = low + (high - low) * place.elevation_rest;
    low = model_entry(world, at + farther, rest, mask);
    high = model_entry(world, at + farther + higher, rest, mask);
    Float far = low + (high - low) * place.elevation_rest;
    return near + (far - near) * place.azimuth_rest;
}

FN Float ground_share(IN(WorldRecord) world, Float nanometres, Mask mask) {
    Float w = min(max((nanometres - Float(360.0f)) * Float(1.0f / MODEL_STEP), Float(0.0f)), Float(float(MODEL_WAVELENGTHS - 1)));
    Float shorter = min(floor(w), Float(float(MODEL_WAVELENGTHS - 2)));
    Int at = round_to_int(shorter) + Int(world.sky.model + MODEL_AZIMUTHS * MODEL_ELEVATIONS * MODEL_WAVELENGTHS);
    return model_entry(world, at, w - shorter, mask);
}

// Without the sun itself.
FN Spectrum model_radiance(IN(WorldRecord) world, Vec3 direction, Vec4 nanometres, Mask mask) {
    Spectrum share = black();
    Mask above = both(mask, direction.y >= Float(0.0f));
    if (some(above)) {
        ModelPlace place = model_place(world.sky, direction);
        share = vec4_of(model_share(world, place, nanometres.x, above), model_share(world, place, nanometres.y, above),
                        model_share(world, place, nanometres.z, above), model_share(world, place, nanometres.w, above));
    }
    Mask below = without(mask, above);
    if (some(below)) {
        Spectrum ground = vec4_of(ground_share(world, nanometres.x, below), ground_share(world, nanometres.y, below),
                                  ground_share(world, nanometres.z, below), ground_share(world, nanometres.w, below));
        share = select(below, ground, share);
    }
    return share * curve_value(world, world.sky.horizon.curve, nanometres, mask) * Float(world.sky.horizon.scale);
}

NAMESPACE_END

#endif
