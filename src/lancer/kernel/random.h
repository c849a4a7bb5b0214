// Random numbers as a pure function of (seed, pixel, sample, dimension): no generator has a state, so any order of work gives the same numbers.
#ifndef LANCER_KERNEL_RANDOM_H
#define LANCER_KERNEL_RANDOM_H

#include "lancer/kernel/language.h"

#ifndef __cplusplus
#define UINT uint
#else
#define UINT std::uint32_t
#endif

NAMESPACE_BEGIN

// A permutation of the 32-bit numbers that leaves no visible pattern [Jarzynski and Olano 2020: PCG's output function].
FN UINT scramble(UINT x) {
    UINT state = x * 747796405u + 2891336453u;
    UINT word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

FN UINT random_bits(UINT seed, UINT pixel, UINT sample_number, UINT dimension) {
    return scramble(dimension + scramble(sample_number + scramble(pixel + scramble(seed))));
}

// Uniform in [0, 1): the upper 24 bits, so that every value is a float and 1 is never reached.
FN float random_number(UINT seed, UINT pixel, UINT sample_number, UINT dimension) {
    return float(random_bits(seed, pixel, sample_number, dimension) >> 8u) * 5.9604644775390625e-8f;
}

NAMESPACE_END

#endif
