// What a medium does to light at a point, at each of the path's wavelengths.
#ifndef LANCER_KERNEL_VOLUME_VOLUME_H
#define LANCER_KERNEL_VOLUME_VOLUME_H

#include "lancer/kernel/material.h"
#include "lancer/kernel/volume/grid.h"

NAMESPACE_BEGIN

// Where the density is 1.
struct Coefficients {
    Spectrum extinction;  // per metre
    Spectrum albedo;      // the share of it that is scattering
    Spectrum emission;    // radiance where nothing shines through
};

FN Float share_of(Float part, Float whole) { return select(whole > Float(0.0f), part / max(whole, Float(SMALLEST)), Float(0.0f)); }

FN Spectrum shares_of(Spectrum part, Spectrum whole) {
    return vec4_of(share_of(part.x, whole.x), share_of(part.y, whole.y), share_of(part.z, whole.z), share_of(part.w, whole.w));
}

FN Coefficients volume_coefficients(IN(WorldRecord) world, IN(VolumeRecord) volume, Vec4 nanometres, Mask mask) {
    SurfacePoint nowhere_near = no_surface();
    Coefficients c;
    Spectrum first = color_value(world, volume.first, nowhere_near, nanometres, mask);
    Spectrum second = color_value(world, volume.second, nowhere_near, nanometres, mask);
    if ((volume.flags & VOLUME_HAS_ALBEDO) != 0) {
        c.extinction = first;
        c.albedo = second;
    } else {
        c.extinction = first + second;
        c.albedo = shares_of(second, c.extinction);
    }
    c.emission = black();
    if ((volume.flags & VOLUME_EMITS) != 0) {
        c.emission = color_value(world, volume.emission, nowhere_near, nanometres, mask);
    }
    return c;
}

// Of linear RGB that is no share of light, such as a density.
FN Spectrum spectrum_of_rgb(IN(WorldRecord) world, Vec3 rgb, Vec4 nanometres, Mask mask) {
    return light_of_rgb(world, rgb, nanometres, mask);
}

// What the coefficients are multiplied by at a place of the unit cube; never more than its block says.
FN Spectrum density_at(IN(WorldRecord) world, IN(GridRecord) grid, Vec3 place, Vec4 nanometres, Mask mask) {
    GridPlace at = grid_place(grid, place);
    Spectrum density = black();
    if (grid.channels == 1) {
        density = vec4_all(grid_channel(world, grid, at, 0, mask));
    } else {
        density = spectrum_of_rgb(world, grid_color(world, grid, at, mask), nanometres, mask);
    }
    return density;
}

// The albedo at a point in space, where a grid gives it; 0 outside of the grid.
FN Spectrum albedo_at(IN(WorldRecord) world, IN(VolumeRecord) volume, Vec3 position, Vec4 nanometres, IN(Coefficients) c, Mask mask) {
    Spectrum albedo = c.albedo;
    if (volume.albedo_grid >= 0) {
        GridRecord grid = AT(world.grids, volume.albedo_grid);
        Vec3 place = apply_affine(grid.to_grid, position);
        Mask within = both(mask, is_in_grid(place));
        GridPlace at = grid_place(grid, place);
        Spectrum found = black();
        if (grid.channels == 1) {
            found = vec4_all(clamp01(grid_channel(world, grid, at, 0, within)));
        } else {
            Vec3 rgb = grid_color(world, grid, at, within);
            found = rgb_value(rgb);
            if (world.spectral != 0) {
                found = smooth_spectrum(reflectance_coefficients(world.upsampling, rgb, within), nanometres);
            }
        }
        albedo = select(within, found, black());
    }
    return albedo;
}

// The radiance that it would have at a point in space if nothing shone through: of a black body where a grid gives temperatures.
FN Spectrum emission_at(IN(WorldRecord) world, IN(VolumeRecord) volume, Vec3 position, Vec4 nanometres, IN(Coefficients) c, Mask mask) {
    Spectrum emission = c.emission;
    if (volume.temperature_grid >= 0) {
        GridRecord grid = AT(world.grids, volume.temperature_grid);
        Vec3 place = apply_affine(grid.to_grid, position);
        Mask within = both(mask, is_in_grid(place));
        Float kelvin = grid_channel(world, grid, grid_place(grid, place), 0, within);
        Float entry = min(max(kelvin * Float(volume.heat_steps), Float(0.0f)), Float(float(HEAT_ENTRIES - 1)));
        Float below = min(floor(entry), Float(float(HEAT_ENTRIES - 2)));
        Float share = entry - below;
        Int row = round_to_int(below);
        Spectrum glow = black();
        if (world.spectral != 0) {
            Int first = (row + Int(volume.heat)) * Int(WAVELENGTH_COUNT);
            Int second = first + Int(WAVELENGTH_COUNT);
            Int x = wavelength_entry(nanometres.x);
            Int y = wavelength_entry(nanometres.y);
            Int z = wavelength_entry(nanometres.z);
            Int w = wavelength_entry(nanometres.w);
            Spectrum colder = vec4_of(gather_float(world.curves, first + x, within), gather_float(world.curves, first + y, within),
                                      gather_float(world.curves, first + z, within), gather_float(world.curves, first + w, within));
            Spectrum hotter = vec4_of(gather_float(world.curves, second + x, within), gather_float(world.curves, second + y, within),
                                      gather_float(world.curves, second + z, within), gather_float(world.curves, second + w, within));
            glow = colder + (hotter - colder) * share;
        } else {
            Int first = row * Int(3) + Int(volume.heat);
            Vec3 colder = vec3_of(gather_float(world.voxels, first, within), gather_float(world.voxels, first + Int(1), within),
                                  gather_float(world.voxels, first + Int(2), within));
            Vec3 hotter = vec3_of(gather_float(world.voxels, first + Int(3), within), gather_float(world.voxels, first + Int(4), within),
                                  gather_float(world.voxels, first + Int(5), within));
            glow = rgb_value(colder + (hotter - colder) * share);
        }
        emission = select(within, emission * glow, black());
    }
    return emission;
}

// What fills the space in a body of `material`; of -1, around all bodies. -1: nothing.
FN Int volume_of(IN(WorldRecord) world, Int material, Mask mask) {
    Int volume = Int(world.surrounding_volume);
    Mask todo = both(mask, is_above(material, Int(-1)));
    while (some(todo)) {
        int number = first_of(material, todo);
        Mask mine = both(todo, is_equal(material, Int(number)));
        volume = select(mine, Int(AT(world.media, number).volume), volume);
        todo = without(todo, mine);
    }
    return volume;
}

NAMESPACE_END

#endif
