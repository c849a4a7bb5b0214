// Normals that differ from the surface's: maps of normals and of heights, and what is done where they and the surface disagree.
#ifndef LANCER_KERNEL_RELIEF_H
#define LANCER_KERNEL_RELIEF_H

#include "lancer/kernel/inputs.h"

NAMESPACE_BEGIN

// The slopes of a height that a texture gives, for u and for v: differences across a texel of a picture, as large as that looks through the path's
// beam. Of a picture without mipmaps they are those of the straight lines between its texels.
FN Vec2 height_slopes(IN(WorldRecord) world, IN(InputRecord) source, IN(SurfacePoint) s, Mask mask) {
    TextureRecord texture = AT(world.textures, source.texture);
    Float step_u = Float(1.0f / 1024.0f);
    Float step_v = step_u;
    if (texture.kind == TEXTURE_IMAGE) {
        // Of uv, whichever way the picture is turned and stretched on it.
        Float width = Float(float(AT(world.levels, 3 * texture.first_level + 1)));
        Float height = Float(float(AT(world.levels, 3 * texture.first_level + 2)));
        Float least = Float(1.0e-6f);
        step_u = Float(1.0f) / max(max(abs(Float(texture.row_u.x)) * width, abs(Float(texture.row_v.x)) * height), least);
        step_v = Float(1.0f) / max(max(abs(Float(texture.row_u.y)) * width, abs(Float(texture.row_v.y)) * height), least);
    }
    if (texture.kind == TEXTURE_IMAGE && texture.look == LOOK_BILINEAR) {
        step_u = step_u * Float(1.0f / 16.0f);
        step_v = step_v * Float(1.0f / 16.0f);
    } else {
        step_u = max(step_u, (abs(s.across.x) + abs(s.down.x)) * Float(0.5f));
        step_v = max(step_v, (abs(s.across.y) + abs(s.down.y)) * Float(0.5f));
    }
    Vec2 slopes = vec2_of(Float(0.0f), Float(0.0f));
    SurfacePoint there = s;
    Vec2 half_u = vec2_of(step_u * Float(0.5f), Float(0.0f));
    Vec2 half_v = vec2_of(Float(0.0f), step_v * Float(0.5f));
    there.uv = vec2_of(s.uv.x + half_u.x, s.uv.y);
    there.second_uv = vec2_of(s.second_uv.x + half_u.x, s.second_uv.y);
    Float high = input_value(world, source, there, mask);
    there.uv = vec2_of(s.uv.x - half_u.x, s.uv.y);
    there.second_uv = vec2_of(s.second_uv.x - half_u.x, s.second_uv.y);
    Float low = input_value(world, source, there, mask);
    slopes.x = (high - low) / step_u;
    there.uv = vec2_of(s.uv.x, s.uv.y + half_v.y);
    there.second_uv = vec2_of(s.second_uv.x, s.second_uv.y + half_v.y);
    high = input_value(world, source, there, mask);
    there.uv = vec2_of(s.uv.x, s.uv.y - half_v.y);
    there.second_uv = vec2_of(s.second_uv.x, s.second_uv.y - half_v.y);
    low = input_value(world, source, there, mask);
    slopes.y = (high - low) / step_v;
    return slopes;
}

// A direction in the plane of a surface, x along u and y to the side where v grows; `crosswise`: along the cross product of the normal and u.
FN Vec3 across_surface(IN(SurfacePoint) s, Float x, Float y, bool crosswise) {
    Frame frame = frame_along(s.shading, s.along_u);
    Mask mirrored = without(dot(frame.y, s.along_v) < Float(0.0f), all_or_none(crosswise));
    return frame.x * x + frame.y * select(mirrored, -y, y);
}

// The normal that a map has there, outwards.
FN Vec3 mapped_normal(IN(WorldRecord) world, int texture, vec2 scale, bool crosswise, IN(SurfacePoint) s, Mask mask) {
    Vec4 color = texture_color(world, AT(world.textures, texture), s, mask);
    Float x = (color.x * Float(2.0f) - Float(1.0f)) * Float(scale.x);
    Float y = (color.y * Float(2.0f) - Float(1.0f)) * Float(scale.y);
    Float z = max(color.z * Float(2.0f) - Float(1.0f), Float(1.0f / 255.0f));
    return normalize(across_surface(s, x, y, crosswise) + s.shading * z);
}

// The way in which a surface is smooth.
FN Vec3 turned_along(IN(WorldRecord) world, IN(MaterialRecord) material, IN(SurfacePoint) s, Mask mask) {
    Float x = Float(1.0f);
    Float y = Float(0.0f);
    if (material.turn_map > 0) {
        Vec4 color = texture_color(world, AT(world.textures, material.turn_map - 1), s, mask);
        x = color.x * Float(2.0f) - Float(1.0f);
        y = color.y * Float(2.0f) - Float(1.0f);
    }
    Float cosine = Float(material.turn.x);
    Float sine = Float(material.turn.y);
    Vec3 way = across_surface(s, x * cosine - y * sine, x * sine + y * cosine, false);
    Float size = dot(way, way);
    return select(size > Float(1.0e-6f), way / sqrt(max(size, Float(SMALLEST))), s.along_u);
}

// The shading normal, outwards, as the material's relief bends it.
FN Vec3 bent_normal(IN(WorldRecord) world, IN(MaterialRecord) material, IN(SurfacePoint) s, Mask mask) {
    Vec3 n = s.shading;
    if (material.normal_map > 0) {
        n = mapped_normal(world, material.normal_map - 1, material.normal_scale, (material.flags & MATERIAL_CROSSWISE) != 0, s, mask);
    }
    if (material.height_input > 0) {
        // The surface raised along its normal [Blinn 1978].
        Vec2 slopes = height_slopes(world, AT(world.inputs, material.height_input - 1), s, mask);
        Vec3 along_u = s.along_u - n * dot(n, s.along_u) + n * slopes.x;
        Vec3 along_v = s.along_v - n * dot(n, s.along_v) + n * slopes.y;
        Vec3 raised = cross(along_u, along_v);
        raised = select(dot(raised, n) < Float(0.0f), -raised, raised);
        Float size = dot(raised, raised);
        n = select(size > Float(SMALLEST), raised / sqrt(max(size, Float(SMALLEST))), n);
    }
    return n;
}

// How rough the relief looks, for the share of light that it hides from itself: normals that lean as this one does, as facets
// [Estevez et al. 2019]. `smooth_`: the normal before it was bent.
FN Float hills_of(Vec3 smooth_, Vec3 bent) {
    Float cosine = dot(smooth_, bent);
    Float c2 = max(cosine * cosine, Float(1.0e-12f));
    return min(Float(0.125f) * (Float(1.0f) - min(c2, Float(1.0f))) / c2, Float(1.0f));
}

FN Float between_hills(Float hills, Vec3 smooth_, Vec3 direction) {
    Float cosine = dot(smooth_, direction);
    Float c2 = max(cosine * cosine, Float(1.0e-12f));
    Float steep = (Float(1.0f) - min(c2, Float(1.0f))) / c2;
    return Float(2.0f) / (Float(1.0f) + sqrt(Float(1.0f) + max(hills, Float(0.0f)) * steep));
}

// The nearest normal to `shading`, towards the surface's own `normal`, under which `view` is seen from above and mirrored to above the surface: else
// a mirror would be black there. All have length 1; `view` is above the surface.
//
// In the plane of both normals, with an angle a from `normal` and the view's part (x, z) in it, the mirrored view rises by x sin 2a + z cos 2a; it
// shall not be less than `least`.
FN Vec3 seen_normal(Vec3 normal, Vec3 shading, Vec3 view) {
    Float z = dot(view, normal);
    Float least = min(z * Float(0.9f), Float(0.01f));
    Float up = dot(view, shading);
    Mask bad = either(up <= Float(0.0f), Float(2.0f) * up * dot(shading, normal) - z < least);
    Vec3 result = shading;
    if (some(bad)) {
        Vec3 off = shading - normal * dot(shading, normal);
        Float size = length(off);
        Vec3 side = off / max(size, Float(1.0e-6f));
        Float x = dot(view, side);
        Float radius = sqrt(max(x * x + z * z, Float(1.0e-12f)));
        Float c = min(least / radius, Float(1.0f));
        Float s = sqrt(max(Float(1.0f) - c * c, Float(0.0f)));
        // Cosine and sine of 2a = (angle of the view) + acos c; the larger of those of a by a root, the other by division, which does not cancel.
        Float cosine_2 = (z * c - x * s) / radius;
        Float sine_2 = (x * c + z * s) / radius;
        Float larger = sqrt(max(Float(0.5f) + Float(0.5f) * abs(cosine_2), Float(0.5f)));
        Float smaller = Float(0.5f) * sine_2 / larger;
        Mask steep = cosine_2 < Float(0.0f);
        Float cosine = select(steep, smaller, larger);
        Float sine = select(steep, larger, smaller);
        Vec3 bent = select(size > Float(1.0e-6f), normalize(normal * cosine + side * sine), normal);
        result = select(bad, bent, result);
    }
    return result;
}

NAMESPACE_END

#endif
