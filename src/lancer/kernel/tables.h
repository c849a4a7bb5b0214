// Look-ups in tables at a different place in each lane. Lanes that are off read nothing and hold zeros.
#ifndef LANCER_KERNEL_TABLES_H
#define LANCER_KERNEL_TABLES_H

#include "lancer/kernel/records.h"

NAMESPACE_BEGIN

#ifdef LANCER_ISA

FN Int gather_int(IntTable table, Int index, Mask mask) {
    alignas(64) std::int32_t at[LANES];
    alignas(64) std::int32_t out[LANES] = {};
    index.store_aligned(at);
    for (unsigned left = mask_bits(mask); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        out[lane] = table[at[lane]];
    }
    return Int::load_aligned(out);
}

FN Float gather_float(FloatTable table, Int index, Mask mask) {
    alignas(64) std::int32_t at[LANES];
    alignas(64) float out[LANES] = {};
    index.store_aligned(at);
    for (unsigned left = mask_bits(mask); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        out[lane] = table[at[lane]];
    }
    return Float::load_aligned(out);
}

FN Vec2 gather_vec2(Vec2Table table, Int index, Mask mask) {
    alignas(64) std::int32_t at[LANES];
    alignas(64) float x[LANES] = {};
    alignas(64) float y[LANES] = {};
    index.store_aligned(at);
    for (unsigned left = mask_bits(mask); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        x[lane] = table[at[lane]].x;
        y[lane] = table[at[lane]].y;
    }
    return vec2_of(Float::load_aligned(x), Float::load_aligned(y));
}

FN Vec3 gather_vec3(Vec3Table table, Int index, Mask mask) {
    alignas(64) std::int32_t at[LANES];
    alignas(64) float x[LANES] = {};
    alignas(64) float y[LANES] = {};
    alignas(64) float z[LANES] = {};
    index.store_aligned(at);
    for (unsigned left = mask_bits(mask); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        x[lane] = table[at[lane]].x;
        y[lane] = table[at[lane]].y;
        z[lane] = table[at[lane]].z;
    }
    return vec3_of(Float::load_aligned(x), Float::load_aligned(y), Float::load_aligned(z));
}

#else

FN Int gather_int(IntTable table, Int index, Mask mask) {
    Int value = 0;
    if (mask) {
        value = AT(table, index);
    }
    return value;
}

FN Float gather_float(FloatTable table, Int index, Mask mask) {
    Float value = Float(0.0f);
    if (mask) {
        value = Float(AT(table, index));
    }
    return value;
}

FN Vec2 gather_vec2(Vec2Table table, Int index, Mask mask) {
    Vec2 value = vec2_of(Float(0.0f), Float(0.0f));
    if (mask) {
        value = vec2_of(Float(AT(table, index).x), Float(AT(table, index).y));
    }
    return value;
}

FN Vec3 gather_vec3(Vec3Table table, Int index, Mask mask) {
    Vec3 value = vec3_all(Float(0.0f));
    if (mask) {
        value = broadcast(AT(table, index));
    }
    return value;
}

#endif

NAMESPACE_END

#endif
