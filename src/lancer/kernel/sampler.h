// Sample points: Owen-scrambled Sobol numbers, two at a time, one pair for each decision of a path.
//
// A point is a pure function of (pixel key, sample number, decision). Each decision has its own pair of Sobol coordinates with its own random
// scrambling and its own random order of the samples, so that decisions are independent of one another and each is evenly spread over a
// pixel's samples: over any aligned power of two of them best of all. [Burley 2020; Owen 1995]
#ifndef LANCER_KERNEL_SAMPLER_H
#define LANCER_KERNEL_SAMPLER_H

#include "lancer/kernel/language.h"

NAMESPACE_BEGIN

// ---- The decisions of a path. ------------------------------------------------------------------------------------------------------

const int DECISION_FILM = 0;        // place within the pixel's filter
const int DECISION_LENS = 1;        // place on the lens
const int DECISION_WAVELENGTH = 2;  // a quartered number
const int DECISION_BOUNCES = 4;     // from here on, so many for each vertex of the path:
const int DECISIONS_A_BOUNCE = 4;
const int DECISION_CHOICE = 0;      // which light, which part of the material
const int DECISION_LIGHT = 1;       // point on the light
const int DECISION_DIRECTION = 2;   // direction of the next ray
const int DECISION_SURVIVAL = 3;    // Russian roulette; second: which of mixed materials
const int DECISION_LAYERS = 65536;  // from here on, so many for each vertex: passing through a surface that is not there everywhere
const int DECISIONS_OF_LAYERS = 256;
const int DECISION_FLIGHT = 1 << 28;  // and so many: how far light flies through media; the second half: layers behind a null border
const int DECISIONS_OF_FLIGHT = 1 << 18;
const int DECISION_DIMMING = 1 << 29;  // and so many: what media leave of light that is asked for
const int DECISIONS_OF_DIMMING = 1 << 18;
const int DECISION_DIMMING_BEFORE = (1 << 29) + (1 << 28);  // the same before the first vertex of a path of light

// Of a path of light, which has a key of its own, before its vertices:
const int DECISION_EMISSION = 0;        // which emitter; second: which side of it
const int DECISION_EMISSION_PLACE = 1;  // point on it
const int DECISION_EMISSION_WAY = 2;    // direction
const int DECISION_EMISSION_LENS = 3;   // place on the lens that its vertices are joined to

// ---- One pixel's sample in each lane. ----------------------------------------------------------------------------------------------

struct Sampler {
    UInt key;       // of the pixel and the seed
    UInt reversed;  // the sample's number, its bits in reverse order
};

// A permutation of the 32-bit numbers that leaves no visible pattern [Jarzynski and Olano 2020: PCG's output function].
FN UInt scramble(UInt x) {
    UInt state = x * UInt(747796405u) + UInt(2891336453u);
    // The shift differs from lane to lane: made of four fixed ones.
    UInt amount = (state >> 28) + UInt(4u);
    UInt word = state;
    word = select(is_equal(as_signed(amount & UInt(1u)), Int(0)), word, word >> 1);
    word = select(is_equal(as_signed(amount & UInt(2u)), Int(0)), word, word >> 2);
    word = select(is_equal(as_signed(amount & UInt(4u)), Int(0)), word, word >> 4);
    word = select(is_equal(as_signed(amount & UInt(8u)), Int(0)), word, word >> 8);
    word = select(is_equal(as_signed(amount & UInt(16u)), Int(0)), word, word >> 16);
    word = (word ^ state) * UInt(277803737u);
    return (word >> 22) ^ word;
}

FN UInt reverse_bits(UInt x) {
    UInt y = x;
    y = ((y >> 1) & UInt(0x55555555u)) | ((y & UInt(0x55555555u)) << 1);
    y = ((y >> 2) & UInt(0x33333333u)) | ((y & UInt(0x33333333u)) << 2);
    y = ((y >> 4) & UInt(0x0f0f0f0fu)) | ((y & UInt(0x0f0f0f0fu)) << 4);
    y = ((y >> 8) & UInt(0x00ff00ffu)) | ((y & UInt(0x00ff00ffu)) << 8);
    return (y >> 16) | (y << 16);
}

// Each bit is flipped by a hash of the bits below it: Owen's scrambling of a number whose bits stand in reverse order. [Laine and Karras 2011,
// with the constants of Vegdahl 2021]
FN UInt scramble_upwards(UInt x, UInt key) {
    UInt y = x;
    y = y ^ (y * UInt(0x3d20adeau));
    y = y + key;
    y = y * ((key >> 16) | UInt(1u));
    y = y ^ (y * UInt(0x05526c56u));
    y = y ^ (y * UInt(0x53a22864u));
    return y;
}

// Sobol's second coordinate of the sample number x, its bits in reverse order: Pascal's triangle modulo 2 applied to the bits, as five
// exchanges [differs from tables of direction numbers: (1 + X)^k over the field of two elements, doubled in each step].
FN UInt sobol_second(UInt x) {
    UInt y = x;
    y = y ^ ((y & UInt(0xaaaaaaaau)) >> 1);
    y = y ^ ((y & UInt(0xccccccccu)) >> 2);
    y = y ^ ((y & UInt(0xf0f0f0f0u)) >> 4);
    y = y ^ ((y & UInt(0xff00ff00u)) >> 8);
    y = y ^ ((y & UInt(0xffff0000u)) >> 16);
    return y;
}

// Uniform in [0, 1): the upper 24 bits.
FN Float unit_interval(UInt bits) { return to_float(as_signed(bits >> 8)) * Float(5.9604644775390625e-8f); }

// The key of a pixel. Mixed twice, so that another seed is not the same noise elsewhere in the picture.
FN UInt pixel_key(UInt column, UInt row, UInt seed) { return scramble(scramble(column + (row << 16)) + scramble(seed)); }

FN Sampler start_sampler(UInt key, UInt sample_number) {
    Sampler s;
    s.key = key;
    s.reversed = reverse_bits(sample_number);
    return s;
}

// The pair of numbers for a decision, each uniform in [0, 1).
FN Vec2 sample_pair(IN(Sampler) start, UInt decision) {
    UInt key = scramble(start.key + decision);
    UInt order = reverse_bits(scramble_upwards(start.reversed, key));
    UInt first = reverse_bits(scramble_upwards(order, key * UInt(0x9e3779b1u) + UInt(0x7f4a7c15u)));
    UInt second = reverse_bits(scramble_upwards(sobol_second(order), key * UInt(0x85ebca77u) + UInt(0xc2b2ae3du)));
    return vec2_of(unit_interval(first), unit_interval(second));
}

// One number for a decision, uniform in [0, 1), of which the path uses those a quarter, a half and three quarters away, too: so they are put on a
// lattice within a quarter, evenly spaced for any power of two of samples, that all of a pixel's samples shift alike. What is smooth and goes
// round, as the light over a path's wavelengths does, it sums up with far less error than scattered points [Cranley and Patterson 1976]. Which of
// the four quarters comes first is told by Sobol's second coordinate: each four samples begin in all quarters, and together with the place within
// the quarter it fills [0, 1) evenly, for paths that keep their first wavelength only.
FN Float quartered_number(IN(Sampler) start, UInt sample_number, UInt decision) {
    UInt shift = scramble(start.key + decision);
    Float within = unit_interval(start.reversed + shift);
    UInt quarter = (sobol_second(sample_number) ^ scramble(shift)) & UInt(3u);
    return min((within + to_float(as_signed(quarter))) * Float(0.25f), Float(0.99999994f));
}

NAMESPACE_END

#endif
