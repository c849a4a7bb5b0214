// What colour a surface has at a point.
#ifndef LANCER_KERNEL_TEXTURE_H
#define LANCER_KERNEL_TEXTURE_H

#include "lancer/kernel/math.h"
#include "lancer/kernel/tables.h"

NAMESPACE_BEGIN

// 0 or 1: whether the cell of a coordinate is odd.
FN Float parity(Float x) {
    Float cell = floor(x);
    return cell - Float(2.0f) * floor(cell * Float(0.5f));
}

FN Vec3 checker(IN(TextureRecord) texture, Float sum_of_parities) {
    Float odd = parity(sum_of_parities);
    return select(odd > Float(0.5f), broadcast(texture.second), broadcast(texture.first));
}

// An integer-valued texel coordinate brought into [0, size).
FN Float wrap_texel(Float x, int size, int wrap) {
    Float n = Float(float(size));
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

FN Vec3 texel(IN(WorldRecord) world, IN(TextureRecord) texture, Float x, Float y, Mask mask) {
    Int column = round_to_int(wrap_texel(x, texture.width, texture.wrap));
    Int row = round_to_int(wrap_texel(y, texture.height, texture.wrap));
    return gather_vec3(world.texels, row * Int(texture.width) + column + Int(texture.first_texel), mask);
}

// uv (0, 0) is the picture's lower left corner; texel centres lie at half-integers.
FN Vec3 image_color(IN(WorldRecord) world, IN(TextureRecord) texture, Vec2 uv, Mask mask) {
    Float x = (uv.x * Float(texture.scale.x) + Float(texture.offset.x)) * Float(float(texture.width));
    Float y = (Float(1.0f) - (uv.y * Float(texture.scale.y) + Float(texture.offset.y))) * Float(float(texture.height));
    Vec3 color = vec3_all(Float(0.0f));
    if (texture.nearest != 0) {
        color = texel(world, texture, floor(x), floor(y), mask);
    } else {
        Float left = floor(x - Float(0.5f));
        Float top = floor(y - Float(0.5f));
        Float fx = x - Float(0.5f) - left;
        Float fy = y - Float(0.5f) - top;
        Float one = Float(1.0f);
        Vec3 upper = texel(world, texture, left, top, mask) * (one - fx) + texel(world, texture, left + one, top, mask) * fx;
        Vec3 lower = texel(world, texture, left, top + one, mask) * (one - fx) + texel(world, texture, left + one, top + one, mask) * fx;
        color = upper * (one - fy) + lower * fy;
    }
    return color;
}

// `local` is the point in the object's own space, in metres as the author wrote them, `local_in` the direction into the body there.
FN Vec3 texture_color(IN(WorldRecord) world, IN(TextureRecord) texture, Vec3 local, Vec3 local_in, Vec2 uv, Mask mask) {
    Vec3 color = broadcast(texture.first);
    Float cell = Float(1.0f / texture.size);
    if (texture.kind == TEXTURE_CHECKER_SOLID) {
        // A hair under the surface, so that a face that lies on a border of cells shows those inside the body and does not flicker.
        Vec3 p = local * cell + local_in * Float(1.0f / 1024.0f);
        color = checker(texture, floor(p.x) + floor(p.y) + floor(p.z));
    } else if (texture.kind == TEXTURE_CHECKER_UV) {
        color = checker(texture, floor(uv.x * cell) + floor(uv.y * cell));
    } else if (texture.kind == TEXTURE_IMAGE) {
        color = image_color(world, texture, uv, mask);
    }
    return color;
}

NAMESPACE_END

#endif
