// Where in its pixel a path begins: a point drawn from the pixel's filter.
#ifndef LANCER_KERNEL_PIXEL_FILTER_H
#define LANCER_KERNEL_PIXEL_FILTER_H

#include "lancer/kernel/math.h"
#include "lancer/kernel/tables.h"

NAMESPACE_BEGIN

// Each sample counts the same but for its sign [Ernst et al. 2006].
struct FilterSample {
    Float place;  // pixels from the pixel's middle
    Float weight;
};

FN FilterSample sample_filter(IN(WorldRecord) world, Float u, Mask mask) {
    Float at = to_even_ends(u) * Float(float(FILTER_STEPS));
    Int step = to_int(at);
    Float low = gather_float(world.filter_places, step, mask);
    Float high = gather_float(world.filter_places, step + Int(1), mask);
    FilterSample s;
    s.place = low + (high - low) * (at - to_float(step));
    Float weight = Float(world.filter_record.weight);
    s.weight = select(abs(s.place) > Float(world.filter_record.negative_from), -weight, weight);
    return s;
}

// The filter itself, per pixel, at a distance in pixels from the pixel's middle.
FN Float filter_value(IN(WorldRecord) world, Float distance, Mask mask) {
    Float place = abs(distance) * Float(float(FILTER_VALUES) / world.filter_record.radius);
    Float below = floor(place);
    Mask within = both(mask, below < Float(float(FILTER_VALUES)));
    Int entry = to_int(select(within, below, Float(0.0f)));
    Float low = gather_float(world.filter_values, entry, within);
    Float high = gather_float(world.filter_values, entry + Int(1), within);
    return select(within, low + (high - low) * (place - below), Float(0.0f));
}

NAMESPACE_END

#endif
