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

NAMESPACE_END

#endif
