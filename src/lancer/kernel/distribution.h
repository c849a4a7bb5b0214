// Draws from tables of cumulative shares, see WorldRecord::distributions.
#ifndef LANCER_KERNEL_DISTRIBUTION_H
#define LANCER_KERNEL_DISTRIBUTION_H

#include "lancer/kernel/math.h"
#include "lancer/kernel/tables.h"

NAMESPACE_BEGIN

// The first of `count` cumulative shares (from `first` on) that is above u; the last where none is.
FN Int find_share(IN(WorldRecord) world, Int first, int count, Float u, Mask mask) {
    Int low = Int(0);
    Int high = Int(count - 1);
    for (int step = count; step > 0; step /= 2) {
        Int middle = (low + high) >> 1;
        Mask above = gather_float(world.distributions, middle + first, mask) > u;
        Mask open = is_above(high, low);
        high = select(both(open, above), middle, high);
        low = select(without(open, above), middle + Int(1), low);
    }
    return low;
}

// The share of one entry itself.
FN Float own_share(IN(WorldRecord) world, Int first, Int entry, Mask mask) {
    Float upper = gather_float(world.distributions, entry + first, mask);
    Float lower = gather_float(world.distributions, select(is_above(entry, Int(0)), entry, Int(1)) + first - Int(1), mask);
    return upper - select(is_above(entry, Int(0)), lower, Float(0.0f));
}

// From a number that fell into a share to one that is uniform in [0, 1) again.
FN Float rest_of(Float u, Float upper, Float share) {
    return min(clamp01((u - (upper - share)) / max(share, Float(SMALLEST))), Float(0.99999994f));
}

NAMESPACE_END

#endif
