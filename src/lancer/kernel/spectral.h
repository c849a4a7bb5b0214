// The wavelengths that carry light through dispersive glass.
#ifndef LANCER_KERNEL_SPECTRAL_H
#define LANCER_KERNEL_SPECTRAL_H

#include "lancer/kernel/refraction.h"

NAMESPACE_BEGIN

// The wavelength of each lane's band; the d line for white light.
FN Float band_wavelength(IN(WorldRecord) world, Int band, Mask alive) {
    Float nanometres = Float(D_LINE);
    Mask todo = both(alive, is_above(band, Int(-1)));
    while (some(todo)) {
        int number = first_of(band, todo);
        Mask mine = both(todo, is_equal(band, Int(number)));
        nanometres = select(mine, Float(AT(world.bands, number).nanometres), nanometres);
        todo = without(todo, mine);
    }
    return nanometres;
}

FN Vec3 band_weight(IN(WorldRecord) world, Int band, Mask alive) {
    Vec3 weight = vec3_all(Float(1.0f));
    Mask todo = both(alive, is_above(band, Int(-1)));
    while (some(todo)) {
        int number = first_of(band, todo);
        Mask mine = both(todo, is_equal(band, Int(number)));
        weight = select(mine, broadcast(AT(world.bands, number).weight), weight);
        todo = without(todo, mine);
    }
    return weight;
}

NAMESPACE_END

#endif
