// Look-ups in tables at a different place in each lane. Lanes that are off read nothing and hold zeros.
#ifndef LANCER_KERNEL_TABLES_H
#define LANCER_KERNEL_TABLES_H

#include "lancer/kernel/records.h"

NAMESPACE_BEGIN

// One texel as it is stored, linear; what has no alpha has 1.
FN vec4 stored_texel(IN(WorldRecord) world, IN(TextureRecord) texture, int at) {
    vec4 color = vec4(1.0f);
    if (texture.storage == TEXELS_GREY8) {
        int byte = (AT(world.texels, at >> 2) >> (8 * (at & 3))) & 255;
        float grey = texture.encoded != 0 ? AT(world.decoding, byte) : float(byte) * (1.0f / 255.0f);
        color = vec4(grey, grey, grey, 1.0f);
    } else if (texture.storage == TEXELS_RGBA8) {
        int bytes = AT(world.texels, at);
        int r = bytes & 255;
        int g = (bytes >> 8) & 255;
        int b = (bytes >> 16) & 255;
        float alpha = float((bytes >> 24) & 255) * (1.0f / 255.0f);
        if (texture.encoded != 0) {
            color = vec4(AT(world.decoding, r), AT(world.decoding, g), AT(world.decoding, b), alpha);
        } else {
            color = vec4(float(r) * (1.0f / 255.0f), float(g) * (1.0f / 255.0f), float(b) * (1.0f / 255.0f), alpha);
        }
    } else if (texture.storage == TEXELS_GREY_FLOAT) {
        float grey = AT(world.float_texels, at);
        color = vec4(grey, grey, grey, 1.0f);
    } else {
        color = vec4(AT(world.float_texels, 4 * at), AT(world.float_texels, 4 * at + 1), AT(world.float_texels, 4 * at + 2),
                     AT(world.float_texels, 4 * at + 3));
    }
    return color;
}

#ifdef LANCER_ISA

#if defined(__AVX512F__)

FN Int gather_int(IntTable table, Int index, Mask mask) {
    return _mm512_mask_i32gather_epi32(_mm512_setzero_si512(), static_cast<__mmask16>(mask_bits(mask)), index, table, 4);
}

FN Float gather_step(const float* table, Int index, Mask mask) {
    return _mm512_mask_i32gather_ps(_mm512_setzero_ps(), static_cast<__mmask16>(mask_bits(mask)), index, table, 4);
}

FN Float gather_float(FloatTable table, Int index, Mask mask) { return gather_step(table, index, mask); }

FN Vec2 gather_vec2(Vec2Table table, Int index, Mask mask) {
    const float* x = &table->x;
    const Int at = index + index;
    return vec2_of(gather_step(x, at, mask), gather_step(x + 1, at, mask));
}

FN Vec3 gather_vec3(Vec3Table table, Int index, Mask mask) {
    const float* x = &table->x;
    const Int at = index + index + index;
    return vec3_of(gather_step(x, at, mask), gather_step(x + 1, at, mask), gather_step(x + 2, at, mask));
}

#else

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

#endif

// Of each lane's object: the instance that it is a triangle of, and the emitter.
FN void gather_object(IN(WorldRecord) world, Int number, Mask mask, INOUT(Int) instance, INOUT(Int) emitter) {
    alignas(64) std::int32_t at[LANES];
    alignas(64) std::int32_t out[2][LANES] = {};
    number.store_aligned(at);
    for (unsigned left = mask_bits(mask); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        out[0][lane] = world.objects[at[lane]].instance;
        out[1][lane] = world.objects[at[lane]].emitter;
    }
    instance = Int::load_aligned(out[0]);
    emitter = Int::load_aligned(out[1]);
}

FN void gather_triangle(IN(WorldRecord) world, Int index, Mask mask, INOUT(Vec3) a, INOUT(Vec3) b, INOUT(Vec3) c) {
    const vec3* corners = &world.triangles->a;
    const Int first = index + index + index;
    a = gather_vec3(corners, first, mask);
    b = gather_vec3(corners + 1, first, mask);
    c = gather_vec3(corners + 2, first, mask);
}

FN Vec4 load_rows(const float* x, const float* y, const float* z, const float* w) {
    return vec4_of(Float::load_aligned(x), Float::load_aligned(y), Float::load_aligned(z), Float::load_aligned(w));
}

FN Vec4 gather_vec4(Vec4Table table, Int index, Mask mask) {
    alignas(64) std::int32_t at[LANES];
    alignas(64) float out[4][LANES] = {};
    index.store_aligned(at);
    for (unsigned left = mask_bits(mask); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        const vec4 value = table[at[lane]];
        out[0][lane] = value.x;
        out[1][lane] = value.y;
        out[2][lane] = value.z;
        out[3][lane] = value.w;
    }
    return load_rows(out[0], out[1], out[2], out[3]);
}

FN Vec4 gather_texel(IN(WorldRecord) world, IN(TextureRecord) texture, Int index, Mask mask) {
    alignas(64) std::int32_t at[LANES];
    alignas(64) float out[4][LANES] = {};
    index.store_aligned(at);
    for (unsigned left = mask_bits(mask); left != 0; left &= left - 1) {
        const int lane = __builtin_ctz(left);
        const vec4 value = stored_texel(world, texture, at[lane]);
        out[0][lane] = value.x;
        out[1][lane] = value.y;
        out[2][lane] = value.z;
        out[3][lane] = value.w;
    }
    return load_rows(out[0], out[1], out[2], out[3]);
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

FN Vec4 gather_vec4(Vec4Table table, Int index, Mask mask) {
    Vec4 value = vec4_all(Float(0.0f));
    if (mask) {
        value = broadcast(AT(table, index));
    }
    return value;
}

FN Vec4 gather_texel(IN(WorldRecord) world, IN(TextureRecord) texture, Int index, Mask mask) {
    Vec4 value = vec4_all(Float(0.0f));
    if (mask) {
        value = broadcast(stored_texel(world, texture, index));
    }
    return value;
}

FN void gather_object(IN(WorldRecord) world, Int number, Mask mask, INOUT(Int) instance, INOUT(Int) emitter) {
    instance = 0;
    emitter = 0;
    if (mask) {
        ObjectRecord object = AT(world.objects, number);
        instance = object.instance;
        emitter = object.emitter;
    }
}

FN void gather_triangle(IN(WorldRecord) world, Int index, Mask mask, INOUT(Vec3) a, INOUT(Vec3) b, INOUT(Vec3) c) {
    a = vec3_all(Float(0.0f));
    b = a;
    c = a;
    if (mask) {
        TriangleRecord triangle = AT(world.triangles, index);
        a = broadcast(triangle.a);
        b = broadcast(triangle.b);
        c = broadcast(triangle.c);
    }
}

#endif

NAMESPACE_END

#endif
