// What fills bodies: how much light it swallows, and whether it spreads colours.
#ifndef LANCER_KERNEL_MEDIUM_H
#define LANCER_KERNEL_MEDIUM_H

#include "lancer/kernel/material.h"

NAMESPACE_BEGIN

FN Float raised(Float clearness, Float exponent) { return power(max(clearness, Float(0.0f)), exponent); }

// What bodies swallow along a way through them.
FN Spectrum left_of_light(IN(WorldRecord) world, Int material, Float distance, Vec4 nanometres, Mask alive) {
    Spectrum left_over = vec4_all(Float(1.0f));
    Mask todo = both(alive, is_above(material, Int(-1)));
    while (some(todo)) {
        int number = first_of(material, todo);
        Mask mine = both(todo, is_equal(material, Int(number)));
        MaterialRecord body = AT(world.surfaces, number);
        if (body.clear_distance > 0.0f) {
            SurfacePoint nowhere = no_surface();
            Spectrum clear = color_value(world, body.clearness, nowhere, nanometres, mine);
            Float exponent = distance * Float(1.0f / body.clear_distance);
            Spectrum passes =
                vec4_of(raised(clear.x, exponent), raised(clear.y, exponent), raised(clear.z, exponent), raised(clear.w, exponent));
            left_over = select(mine, passes, left_over);
        }
        todo = without(todo, mine);
    }
    return left_over;
}

FN Mask is_dispersive(IN(WorldRecord) world, Int material, Mask alive) {
    Mask disperses = without(alive, alive);
    Mask todo = both(alive, is_above(material, Int(-1)));
    while (some(todo)) {
        int number = first_of(material, todo);
        Mask mine = both(todo, is_equal(material, Int(number)));
        if (AT(world.media, number).dispersive != 0) {
            disperses = either(disperses, mine);
        }
        todo = without(todo, mine);
    }
    return disperses;
}

// At each wavelength; 1 outside of all bodies.
FN Spectrum refractive_indices(IN(WorldRecord) world, Int material, Vec4 nanometres, Mask alive) {
    Spectrum n = vec4_all(refractive_index(world, material, nanometres.x, alive));
    if (world.spectral != 0 && some(is_dispersive(world, material, alive))) {
        n.y = refractive_index(world, material, nanometres.y, alive);
        n.z = refractive_index(world, material, nanometres.z, alive);
        n.w = refractive_index(world, material, nanometres.w, alive);
    }
    return n;
}

NAMESPACE_END

#endif
