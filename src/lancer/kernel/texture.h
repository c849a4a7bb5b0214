// What colour a surface has at a point, and over the patch around it that a path's beam covers.
#ifndef LANCER_KERNEL_TEXTURE_H
#define LANCER_KERNEL_TEXTURE_H

#include "lancer/kernel/math.h"
#include "lancer/kernel/ray.h"
#include "lancer/kernel/tables.h"

NAMESPACE_BEGIN

// ---- Checkers --------------------------------------------------------------------------------------------------------------------------

// A square wave of period 2, 1 in even cells and -1 in odd ones: its mean over `width` around x. Its integral from 0 is a triangle wave.
FN Float triangle_wave(Float x) {
    Float y = x - Float(2.0f) * floor(x * Float(0.5f));
    return min(y, Float(2.0f) - y);
}

FN Float square_wave(Float x, Float width) {
    Float cell = floor(x);
    Float odd = cell - Float(2.0f) * floor(cell * Float(0.5f));
    Float sharp = Float(1.0f) - Float(2.0f) * odd;
    Float reach = width * Float(0.5f);
    Float mean_ = (triangle_wave(x + reach) - triangle_wave(x - reach)) / max(width, Float(SMALLEST));
    // A patch much smaller than rounding of its place tells nothing.
    return select(width > max(abs(x), Float(1.0f)) * Float(64.0f * ROUNDING), mean_, sharp);
}

// `even`: from -1, all second, to 1, all first.
FN Vec4 checker(IN(TextureRecord) texture, Float even) {
    Float share = Float(0.5f) + Float(0.5f) * even;
    Vec3 color = broadcast(texture.first) * share + broadcast(texture.second) * (Float(1.0f) - share);
    return vec4_of(color.x, color.y, color.z, Float(1.0f));
}

// ---- Pictures --------------------------------------------------------------------------------------------------------------------------

// An integer-valued texel coordinate brought into [0, n).
FN Float wrap_texel(Float x, Float n, int wrap) {
    Float clamped = min(max(x, Float(0.0f)), n - Float(1.0f));
    Float result = clamped;
    if (wrap == WRAP_REPEAT) {
        result = x - n * floor(x / n);
    } else if (wrap == WRAP_MIRROR) {
        Float period = n * Float(2.0f);
        Float m = x - period * floor(x / period);
        result = select(m < n, m, period - Float(1.0f) - m);
    }
    return min(max(result, Float(0.0f)), n - Float(1.0f));
}

struct TextureLevel {
    Int first;
    Float width;
    Float height;
};

FN TextureLevel texture_level(IN(WorldRecord) world, IN(TextureRecord) texture, Int level, Mask mask) {
    Int at = (Int(texture.first_level) + level) * Int(3);
    TextureLevel found;
    found.first = gather_int(world.levels, at, mask);
    found.width = to_float(gather_int(world.levels, at + Int(1), mask));
    found.height = to_float(gather_int(world.levels, at + Int(2), mask));
    return found;
}

FN Vec4 texel(IN(WorldRecord) world, IN(TextureRecord) texture, IN(TextureLevel) level, Float x, Float y, Mask mask) {
    Int column = round_to_int(wrap_texel(x, level.width, texture.wrap_u));
    Int row = round_to_int(wrap_texel(y, level.height, texture.wrap_v));
    return gather_texel(world, texture, row * round_to_int(level.width) + column + level.first, mask);
}

// (0, 0) is the picture's lower left corner; texel centres lie at half-integers.
FN Vec4 bilinear_color(IN(WorldRecord) world, IN(TextureRecord) texture, IN(TextureLevel) level, Vec2 place, Mask mask) {
    Float one = Float(1.0f);
    Float x = place.x * level.width - Float(0.5f);
    Float y = (one - place.y) * level.height - Float(0.5f);
    Float left = floor(x);
    Float top = floor(y);
    Float fx = x - left;
    Float fy = y - top;
    Vec4 upper = texel(world, texture, level, left, top, mask) * (one - fx) + texel(world, texture, level, left + one, top, mask) * fx;
    Vec4 lower =
        texel(world, texture, level, left, top + one, mask) * (one - fx) + texel(world, texture, level, left + one, top + one, mask) * fx;
    return upper * (one - fy) + lower * fy;
}

FN Vec4 trilinear_color(IN(WorldRecord) world, IN(TextureRecord) texture, Vec2 place, Float level, Mask mask) {
    Float below = floor(level);
    Float part = level - below;
    Vec4 color = bilinear_color(world, texture, texture_level(world, texture, round_to_int(below), mask), place, mask);
    Mask between_levels = both(mask, part > Float(0.0f));
    if (some(between_levels)) {
        TextureLevel next = texture_level(world, texture, round_to_int(below) + Int(1), between_levels);
        Vec4 smaller = bilinear_color(world, texture, next, place, between_levels);
        color = select(between_levels, color + (smaller - color) * part, color);
    }
    return color;
}

const int MOST_PROBES = 8;

// The mean over a patch with the diameters `one` and `other`: along the longer, as many looks at copies of the picture whose texels are as wide as
// the shorter one [Heckbert 1989; differs: a line of boxes for the ellipse].
FN Vec4 mipmapped_color(IN(WorldRecord) world, IN(TextureRecord) texture, Vec2 place, Vec2 one, Vec2 other, Mask mask) {
    TextureLevel whole = texture_level(world, texture, Int(0), mask);
    Vec2 a = vec2_of(one.x * whole.width, one.y * whole.height);
    Vec2 b = vec2_of(other.x * whole.width, other.y * whole.height);
    Float length_a = sqrt(a.x * a.x + a.y * a.y);
    Float length_b = sqrt(b.x * b.x + b.y * b.y);
    Mask a_longer = length_a > length_b;
    Float longer = select(a_longer, length_a, length_b);
    Float shorter = max(select(a_longer, length_b, length_a), longer * Float(1.0f / float(MOST_PROBES)));
    // No finer than the picture itself.
    shorter = max(shorter, Float(1.0f));
    Float most = Float(float(texture.level_count - 1));
    Float level = min(max(log_2(shorter), Float(0.0f)), most);
    Float probes = min(max(floor(longer / shorter + Float(0.5f)), Float(1.0f)), Float(float(MOST_PROBES)));
    Float step_x = select(a_longer, one.x, other.x);
    Float step_y = select(a_longer, one.y, other.y);
    Vec4 sum = vec4_all(Float(0.0f));
    Mask todo = mask;
    for (int i = 0; i < MOST_PROBES && some(todo); ++i) {
        Float off = (Float(float(i)) + Float(0.5f)) / probes - Float(0.5f);
        Vec2 at = vec2_of(place.x + step_x * off, place.y + step_y * off);
        sum = select(todo, sum + trilinear_color(world, texture, at, level, todo), sum);
        todo = both(todo, Float(float(i + 1)) < probes);
    }
    return sum / probes;
}

FN Vec4 image_color(IN(WorldRecord) world, IN(TextureRecord) texture, Vec2 place, Vec2 across, Vec2 down, Mask mask) {
    Vec4 color = vec4_all(Float(0.0f));
    if (texture.look == LOOK_NEAREST) {
        TextureLevel whole = texture_level(world, texture, Int(0), mask);
        Float y = (Float(1.0f) - place.y) * whole.height;
        color = texel(world, texture, whole, floor(place.x * whole.width), floor(y), mask);
    } else if (texture.look == LOOK_BILINEAR) {
        color = bilinear_color(world, texture, texture_level(world, texture, Int(0), mask), place, mask);
    } else {
        color = mipmapped_color(world, texture, place, across, down, mask);
    }
    return color;
}

// ---- Any texture -----------------------------------------------------------------------------------------------------------------------

FN Vec2 turned_uv(IN(TextureRecord) texture, Vec2 way) {
    return vec2_of(way.x * Float(texture.row_u.x) + way.y * Float(texture.row_u.y),
                   way.x * Float(texture.row_v.x) + way.y * Float(texture.row_v.y));
}

// Linear RGB and alpha. Where the point knows what a beam covers, the mean over that.
FN Vec4 texture_color(IN(WorldRecord) world, IN(TextureRecord) texture, IN(SurfacePoint) point, Mask mask) {
    Vec4 color = vec4_all(Float(1.0f));
    if (texture.kind == TEXTURE_CHECKER_SOLID) {
        Float cell = Float(1.0f / texture.size);
        // A hair under the surface, so that a face that lies on a border of cells shows those inside the body and does not flicker.
        Vec3 p = point.local * cell + point.local_in * Float(1.0f / 1024.0f);
        Vec3 width = (abs(point.local_across) + abs(point.local_down)) * cell;
        color = checker(texture, square_wave(p.x, width.x) * square_wave(p.y, width.y) * square_wave(p.z, width.z));
    } else if (texture.kind == TEXTURE_VERTEX_COLOR) {
        color = point.vertex_color;
    } else if (texture.kind == TEXTURE_FACE_COLOR) {
        color = point.face_color;
    } else if (texture.kind == TEXTURE_CHECKER_UV || texture.kind == TEXTURE_IMAGE) {
        Vec2 uv = point.uv;
        Vec2 across = point.across;
        Vec2 down = point.down;
        if (texture.uv_set != 0) {
            uv = point.second_uv;
            across = point.second_across;
            down = point.second_down;
        }
        Vec2 place = turned_uv(texture, uv);
        place = vec2_of(place.x + Float(texture.row_u.z), place.y + Float(texture.row_v.z));
        across = turned_uv(texture, across);
        down = turned_uv(texture, down);
        if (texture.kind == TEXTURE_IMAGE) {
            color = image_color(world, texture, place, across, down, mask);
        } else {
            Float cell = Float(1.0f / texture.size);
            Float wide = (abs(across.x) + abs(down.x)) * cell;
            Float high = (abs(across.y) + abs(down.y)) * cell;
            color = checker(texture, square_wave(place.x * cell, wide) * square_wave(place.y * cell, high));
        }
    }
    return color;
}

FN Float channel_of(Vec4 color, int channel) {
    return channel == 0 ? color.x : (channel == 1 ? color.y : (channel == 2 ? color.z : color.w));
}

NAMESPACE_END

#endif
