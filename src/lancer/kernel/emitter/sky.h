// The surroundings: a gradient, or a latitude-longitude image that is drawn from by its brightness.
//
// The image's middle column lies along -z, where a camera looks that is not turned, its right half towards +x; its top is +y. Turned by an
// angle, it moves counter-clockwise as seen from above. It may be tilted besides.
#ifndef LANCER_KERNEL_EMITTER_SKY_H
#define LANCER_KERNEL_EMITTER_SKY_H

#include "lancer/kernel/distribution.h"
#include "lancer/kernel/emitter/sky_model.h"
#include "lancer/kernel/warp.h"

NAMESPACE_BEGIN

// Where a direction lies in the image: x from the left, 0 to 1, y from the top.
FN Vec2 sky_place(IN(SkyRecord) sky, Vec3 direction) {
    Vec3 d = within_sky(sky, direction);
    Float x = fraction(angle_of(d.x, -d.z) * Float(0.5f / PI) + Float(sky.turn) + Float(0.5f));
    Float ring = sqrt(max(d.x * d.x + d.z * d.z, Float(0.0f)));
    return vec2_of(x, Float(0.5f) - angle_of(d.y, ring) * Float(1.0f / PI));
}

FN Vec3 sky_texel(IN(WorldRecord) world, Float x, Float y, Mask mask) {
    Float width = Float(float(world.sky.width));
    Float column = select(x < Float(0.0f), x + width, select(x < width, x, x - width));
    Float row = min(max(y, Float(0.0f)), Float(float(world.sky.height - 1)));
    return gather_vec3(world.sky_texels, round_to_int(row) * Int(world.sky.width) + round_to_int(column), mask);
}

// Linear RGB; between the middles of texels bilinear.
FN Vec3 sky_color(IN(WorldRecord) world, Vec3 direction, Mask mask) {
    Vec2 place = sky_place(world.sky, direction);
    Float x = place.x * Float(float(world.sky.width)) - Float(0.5f);
    Float y = (place.y * Float(world.sky.stretch) + Float(world.sky.shift)) * Float(float(world.sky.height)) - Float(0.5f);
    Float left = floor(x);
    Float top = floor(y);
    Float one = Float(1.0f);
    Float fx = x - left;
    Float fy = y - top;
    Vec3 upper = sky_texel(world, left, top, mask) * (one - fx) + sky_texel(world, left + one, top, mask) * fx;
    Vec3 lower = sky_texel(world, left, top + one, mask) * (one - fx) + sky_texel(world, left + one, top + one, mask) * fx;
    return (upper * (one - fy) + lower * fy) * Float(world.sky.scale);
}

// The radiance that arrives from where nothing is.
FN Spectrum sky_radiance(IN(WorldRecord) world, Vec3 direction, Vec4 nanometres, Mask mask) {
    Spectrum radiance = black();
    SurfacePoint nowhere = no_surface();
    if (world.sky.kind == SKY_IMAGE) {
        radiance = light_of_rgb(world, sky_color(world, direction, mask), nanometres, mask);
        if (world.spectral != 0) {
            radiance = radiance * curve_value(world, world.sky.horizon.illuminant, nanometres, mask);
        }
    } else if (world.sky.kind == SKY_EVEN) {
        radiance = color_value(world, world.sky.horizon, nowhere, nanometres, mask);
    } else if (world.sky.kind == SKY_GRADIENT) {
        Spectrum horizon = color_value(world, world.sky.horizon, nowhere, nanometres, mask);
        Spectrum zenith = color_value(world, world.sky.zenith, nowhere, nanometres, mask);
        Spectrum nadir = color_value(world, world.sky.nadir, nowhere, nanometres, mask);
        radiance = horizon + (select(direction.y < Float(0.0f), nadir, zenith) - horizon) * abs(direction.y);
    } else if (world.sky.kind == SKY_MODEL) {
        Vec3 own = within_sky(world.sky, direction);
        radiance = world.spectral != 0 ? model_radiance(world, own, nanometres, mask) : rgb_value(sky_color(world, direction, mask));
        if (world.sky.sun_chord > 0.0f) {
            Spectrum sun = color_value(world, world.sky.sun_light, nowhere, nanometres, mask);
            radiance = select(is_in_sun(world.sky, own), radiance + sun, radiance);
        }
    }
    return radiance;
}

// ---- Drawing from it -----------------------------------------------------------------------------------------------------------------

struct SkySample {
    Vec3 direction;
    Float density;  // per solid angle
};

// Cosines of the angle from +y of the upper and the lower edge of a row.
FN Vec2 row_edges(IN(SkyRecord) sky, Int row) {
    Float step = Float(0.5f / float(sky.height));
    return vec2_of(on_circle(to_float(row) * step).x, on_circle(to_float(row + Int(1)) * step).x);
}

// The density on a texel: that of its row, and of its place in the row.
FN Float texel_density(IN(WorldRecord) world, Int row, Int column, Mask mask) {
    Float row_share = own_share(world, Int(world.sky.first_share), row, mask);
    Float share = own_share(world, row * Int(world.sky.width) + Int(world.sky.first_share + world.sky.height), column, mask);
    Vec2 edges = row_edges(world.sky, row);
    return row_share * share * Float(float(world.sky.width)) * Float(0.5f / PI) / max(edges.x - edges.y, Float(SMALLEST));
}

// Of an image.
FN SkySample texel_sample(IN(WorldRecord) world, Vec2 u, Mask mask) {
    SkySample s;
    if (world.sky.kind == SKY_IMAGE || world.sky.kind == SKY_MODEL) {
        Int rows = Int(world.sky.first_share);
        Int row = find_share(world, rows, world.sky.height, u.y, mask);
        Float down = rest_of(u.y, gather_float(world.distributions, row + rows, mask), own_share(world, rows, row, mask));
        Int columns = row * Int(world.sky.width) + Int(world.sky.first_share + world.sky.height);
        Int column = find_share(world, columns, world.sky.width, u.x, mask);
        Float along = rest_of(u.x, gather_float(world.distributions, column + columns, mask), own_share(world, columns, column, mask));
        Vec2 edges = row_edges(world.sky, row);
        Float cosine = edges.x + (edges.y - edges.x) * down;
        Float sine = sqrt(max(Float(1.0f) - cosine * cosine, Float(0.0f)));
        Float x = (to_float(column) + along) * Float(1.0f / float(world.sky.width));
        Vec2 around = on_circle(fraction(x - Float(world.sky.turn) + Float(0.5f)));
        s.direction = out_of_sky(world.sky, vec3_of(around.y * sine, cosine, -around.x * sine));
        s.density = texel_density(world, row, column, mask);
    } else {
        s.direction = on_sphere(u);
        s.density = Float(0.25f / PI);
    }
    return s;
}

FN Float sky_density(IN(WorldRecord) world, Vec3 direction, Mask mask) {
    Float density = Float(0.25f / PI);
    if (world.sky.kind == SKY_IMAGE || world.sky.kind == SKY_MODEL) {
        Vec2 place = sky_place(world.sky, direction);
        Float column = min(floor(place.x * Float(float(world.sky.width))), Float(float(world.sky.width - 1)));
        Float row = min(max(floor(place.y * Float(float(world.sky.height))), Float(0.0f)), Float(float(world.sky.height - 1)));
        density = texel_density(world, round_to_int(row), round_to_int(column), mask);
    }
    if (world.sky.sun_share > 0.0f) {
        Float sun =
            select(is_in_sun(world.sky, within_sky(world.sky, direction)), Float(1.0f / PI) / Float(world.sky.sun_chord), Float(0.0f));
        density = density + (sun - density) * Float(world.sky.sun_share);
    }
    return density;
}

// From the whole of it: the sun, too.
FN SkySample sky_sample(IN(WorldRecord) world, Vec2 u, Mask mask) {
    SkySample s;
    if (world.sky.sun_share > 0.0f) {
        Float share = Float(world.sky.sun_share);
        Mask on_sun = u.x < share;
        Float rest = select(on_sun, u.x / share, (u.x - share) / (Float(1.0f) - share));
        Vec2 left = vec2_of(min(clamp01(rest), Float(0.99999994f)), u.y);
        s = texel_sample(world, left, mask);
        s.direction = select(on_sun, out_of_sky(world.sky, sun_direction(world.sky, left)), s.direction);
        s.density = sky_density(world, s.direction, mask);
    } else {
        s = texel_sample(world, u, mask);
    }
    return s;
}

NAMESPACE_END

#endif
