// What leaves a path: its light as linear RGB or at its wavelengths, what it saw first, and whether it is sound.
#ifndef LANCER_KERNEL_OUTCOME_H
#define LANCER_KERNEL_OUTCOME_H

#include "lancer/kernel/path.h"

NAMESPACE_BEGIN

// Light is a number, finite, and not negative. Its RGB may well be negative: that of single wavelengths is.
FN Mask is_sound(Spectrum light) {
    Mask low = both(both(light.x >= Float(0.0f), light.y >= Float(0.0f)), both(light.z >= Float(0.0f), light.w >= Float(0.0f)));
    Mask high = both(both(light.x <= Float(FAR), light.y <= Float(FAR)), both(light.z <= Float(FAR), light.w <= Float(FAR)));
    return both(low, high);
}

FN Vec3 light_in_pixel(IN(WorldRecord) world, IN(PathState) path, Spectrum light, Mask mask) {
    return spectrum_to_rgb(world, light, path.nanometres, mask) * path.weight;
}

// What each wavelength adds to the integral over all of them.
FN Spectrum power_in_pixel(IN(WorldRecord) world, IN(PathState) path, Mask mask) {
    Vec4 density = vec4_all(Float(1.0f));
    if (world.spectral != 0) {
        density = wavelength_densities(world, path.nanometres, mask);
    }
    return path.radiance / density * (path.weight * Float(0.25f));
}

// Metres along the view; of a panorama, which has no one view, from the camera.
FN Float depth_of(IN(CameraRecord) camera, Vec3 position) {
    Vec3 way = position - broadcast(camera.position);
    return camera.kind == CAMERA_PANORAMA ? length(way) : dot(way, broadcast(camera.forward));
}

NAMESPACE_END

#endif
