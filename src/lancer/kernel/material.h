// From a material's record to what it is at a point: a closure for its BSDF, and the light it gives.
#ifndef LANCER_KERNEL_MATERIAL_H
#define LANCER_KERNEL_MATERIAL_H

#include "lancer/kernel/bsdf/visible_color.h"
#include "lancer/kernel/inputs.h"
#include "lancer/kernel/refraction.h"
#include "lancer/kernel/relief.h"
#include "lancer/kernel/upsample.h"

NAMESPACE_BEGIN

// A smooth spectrum with these coefficients at the path's wavelengths.
FN Spectrum smooth_spectrum(Vec3 coefficients, Vec4 nanometres) {
    return vec4_of(sigmoid_polynomial(coefficients, nanometres.x), sigmoid_polynomial(coefficients, nanometres.y),
                   sigmoid_polynomial(coefficients, nanometres.z), sigmoid_polynomial(coefficients, nanometres.w));
}

// Light has no most that it can be: its shape is that of a reflectance, its size stands beside it. To be multiplied by the illuminant.
FN Spectrum light_of_rgb(IN(WorldRecord) world, Vec3 rgb, Vec4 nanometres, Mask mask) {
    Spectrum light = rgb_value(rgb);
    if (world.spectral != 0) {
        Float size = emission_scale(rgb);
        Vec3 shape = rgb / max(size, Float(SMALLEST));
        light = smooth_spectrum(reflectance_coefficients(world.upsampling, shape, mask), nanometres) * size;
    }
    return light;
}

// A colour of the scene at a point of a surface. Only lanes of `mask` need an answer.
FN Spectrum color_value(IN(WorldRecord) world, IN(ColorRecord) color, IN(SurfacePoint) point, Vec4 nanometres, Mask mask) {
    Spectrum value = rgb_value(broadcast(color.rgb));
    if (color.texture >= 0) {
        TextureRecord texture = AT(world.textures, color.texture);
        Vec4 seen = texture_color(world, texture, point, mask);
        Vec3 rgb = vec3_of(seen.x, seen.y, seen.z);
        if (world.spectral != 0) {
            value = color.illuminant >= 0 ? light_of_rgb(world, rgb, nanometres, mask)
                                          : smooth_spectrum(reflectance_coefficients(world.upsampling, rgb, mask), nanometres);
            value = value * Float(color.scale);
        } else {
            value = rgb_value(rgb) * Float(color.scale);
        }
    } else if (world.spectral != 0) {
        if (color.curve >= 0) {
            value = curve_value(world, color.curve, nanometres, mask) * Float(color.scale);
        } else {
            value = smooth_spectrum(broadcast(color.coefficients), nanometres) * Float(color.scale);
        }
    }
    if (world.spectral != 0 && color.illuminant >= 0) {
        value = value * curve_value(world, color.illuminant, nanometres, mask);
    }
    return value;
}

// The geometry that a path meets, what it is made of, and the light that it gives towards the path.
struct PathVertex {
    SurfacePoint point;
    Closure closure;
    Spectrum emission;
    Int material;
    Int emitter;   // -1: none
    Mask inside;   // the path comes from within
    Mask pane;     // met only where it mirrors, see cuts.h
    Vec3 smooth_;  // the shading normal before it was bent, and how rough that made it; -1: not at all, or that is not asked for
    Float hills;
    Vec3 coat_normal;  // of a coat that has its own, outwards; else 0
    Vec3 albedo;       // linear RGB; this and `uv` where `world.watched`
    Vec2 uv;
};

FN PathVertex no_vertex() {
    PathVertex v;
    v.point = no_surface();
    v.closure = no_closure();
    v.emission = black();
    v.material = Int(-1);
    v.emitter = Int(-1);
    v.inside = Float(1.0f) < Float(0.0f);
    v.pane = v.inside;
    v.smooth_ = v.point.shading;
    v.hills = Float(-1.0f);
    v.coat_normal = vec3_all(Float(0.0f));
    v.albedo = vec3_all(Float(0.0f));
    v.uv = vec2_of(Float(0.0f), Float(0.0f));
    return v;
}

FN Closure material_closure(IN(WorldRecord) world, IN(MaterialRecord) material, IN(SurfacePoint) point, Vec4 nanometres, Mask mask) {
    Closure c = no_closure();
    c.kind = Int(material.kind);
    if ((material.flags & MATERIAL_BLENDS) != 0) {
        Spectrum first = color_value(world, AT(world.surfaces, material.mix_first - 1).color, point, nanometres, mask);
        Spectrum second = color_value(world, AT(world.surfaces, material.mix_second - 1).color, point, nanometres, mask);
        c.color = first + (second - first) * share_value(world, material.mix_share, material.mix_input, point, mask);
    } else {
        c.color = color_value(world, material.color, point, nanometres, mask);
    }
    if (material.kind == BSDF_CONDUCTOR) {
        c.index = color_value(world, material.index, point, nanometres, mask);
        c.extinction = color_value(world, material.extinction, point, nanometres, mask);
    }
    c.roughness_x = Float(material.roughness_x);
    c.roughness_y = Float(material.roughness_y);
    c.beckmann = all_or_none((material.flags & MATERIAL_BECKMANN) != 0);
    c.separate = all_or_none((material.flags & MATERIAL_SEPARATE) != 0);
    c.once = all_or_none((material.flags & MATERIAL_ONCE) != 0);
    if (material.kind == BSDF_BURLEY) {
        c.index = vec4_all(Float(material.eta));
        c.sheen = vec4_of(Float(material.sheen_tint), Float(material.specular_tint), Float(material.flatness), Float(material.brightness));
    } else if (material.kind == BSDF_PLASTIC || material.kind == BSDF_PRINCIPLED) {
        c.index = vec4_all(Float(material.eta));
        c.extinction = color_value(world, material.extinction, point, nanometres, mask);
        c.saturates = all_or_none((material.flags & MATERIAL_SATURATES) != 0);
    }
    if (material.kind == BSDF_PRINCIPLED) {
        c.sheen = color_value(world, material.index, point, nanometres, mask);
    }
    if (material.kind == BSDF_PRINCIPLED || material.kind == BSDF_BURLEY) {
        c.metalness = Float(material.metalness);
        c.transmission = Float(material.transmission);
        c.coat = Float(material.coat);
        c.coat_roughness = Float(material.coat_roughness);
        c.coat_index = Float(material.coat_index);
        c.sheen_roughness = Float(material.sheen_roughness);
        c.film_index = Float(material.film_index);
        if (material.film_thickness > 0.0f) {
            c.film = film_thickness(Float(material.film_thickness), nanometres, world.spectral != 0);
        }
        c.thin = all_or_none((material.flags & MATERIAL_THIN) != 0);
    }
    if (material.input_count > 0) {
        take_inputs(world, material, point, nanometres, mask, c);
    }
    return c;
}

// The point with everything that a material's textures may ask for. `width`: diameter of the path's beam there, in metres.
FN SurfacePoint textured_surface(IN(WorldRecord) world, IN(ObjectRecord) object, int flags, IN(Ray) ray, IN(Hit) hit, Float width,
                                 Mask mask) {
    SurfacePoint s = object_surface(world, object, ray, hit, mask);
    if (object.kind == OBJECT_SPHERE) {
        s.uv = sphere_uv(s.normal);
    }
    if ((flags & MATERIAL_MAPPED) != 0) {
        find_mapping(world, object, ray, hit, width, mask, s);
    }
    if ((flags & MATERIAL_TINTED) != 0) {
        find_mesh_colors(world, object, hit, mask, s);
    }
    return s;
}

// As seen from the other end of the ray.
FN Vec3 material_albedo(IN(WorldRecord) world, IN(MaterialRecord) material, IN(SurfacePoint) point, Vec3 direction, Vec4 nanometres,
                        Mask mask) {
    WorldRecord in_rgb = world;
    in_rgb.spectral = 0;
    Spectrum color = visible_color(material_closure(in_rgb, material, point, nanometres, mask), abs(dot(point.shading, direction)));
    return vec3_of(color.x, color.y, color.z);
}

// The point alone. Light that is met by itself must be the same as where it is asked for, whatever the width of the beam.
FN SurfacePoint without_patch(IN(SurfacePoint) point) {
    SurfacePoint s = point;
    s.across = vec2_of(Float(0.0f), Float(0.0f));
    s.down = s.across;
    s.second_across = s.across;
    s.second_down = s.across;
    s.local_across = vec3_all(Float(0.0f));
    s.local_down = s.local_across;
    return s;
}

// Colours of one smooth spectrum each: they are looked up when those of all lanes are known.
struct PlainColors {
    Vec3 coefficients;
    Float scale;
    Mask here;
};

FN PlainColors no_plain_colors() {
    PlainColors p;
    p.coefficients = vec3_all(Float(0.0f));
    p.scale = Float(0.0f);
    p.here = nowhere();
    return p;
}

FN bool is_plain(IN(WorldRecord) world, IN(ColorRecord) color) {
    return world.spectral != 0 && color.texture < 0 && color.curve < 0 && color.illuminant < 0;
}

// What the lanes of `mine` find of one material at their points.
FN void take_material(IN(WorldRecord) world, IN(MaterialRecord) material, IN(SurfacePoint) s, Vec3 direction, Mask inside, Vec4 nanometres,
                      Mask mine, INOUT(PathVertex) vertex, INOUT(PlainColors) plain) {
    if (material.kind == BSDF_DIFFUSE && material.input_count == 0 && (material.flags & MATERIAL_BLENDS) == 0) {
        // The most frequent one, and it has nothing but a colour.
        Mask shown = mine;
        if ((material.flags & MATERIAL_ONE_SIDED) != 0) {
            shown = without(mine, inside);
        }
        vertex.closure.kind = select(shown, Int(BSDF_DIFFUSE), vertex.closure.kind);
        if (is_plain(world, material.color)) {
            plain.coefficients = select(mine, broadcast(material.color.coefficients), plain.coefficients);
            plain.scale = select(mine, Float(material.color.scale), plain.scale);
            plain.here = either(plain.here, mine);
        } else {
            vertex.closure.color = select(mine, color_value(world, material.color, s, nanometres, mine), vertex.closure.color);
        }
    } else {
        Closure c = material_closure(world, material, s, nanometres, mine);
        if ((material.flags & MATERIAL_ONE_SIDED) != 0) {
            c.kind = select(inside, Int(BSDF_NONE), c.kind);
        }
        vertex.closure = select_closure(mine, c, vertex.closure);
    }
    if ((material.flags & MATERIAL_RELIEF) != 0) {
        Vec3 bent = bent_normal(world, material, s, mine);
        if ((material.flags & MATERIAL_HILLS) != 0) {
            // Seen from the same side as the surface, if turned about [Schuessler et al. 2017].
            Mask away = dot(bent, direction) * dot(s.shading, direction) <= Float(0.0f);
            bent = select(away, s.shading * (Float(2.0f) * dot(bent, s.shading)) - bent, bent);
            vertex.smooth_ = select(mine, s.shading, vertex.smooth_);
            vertex.hills = select(mine, hills_of(s.shading, bent), vertex.hills);
        }
        vertex.point.shading = select(mine, bent, vertex.point.shading);
    }
    if ((material.flags & MATERIAL_OWN_COAT) != 0) {
        Vec3 own = s.shading;
        if (material.coat_normal_map > 0) {
            own = mapped_normal(world, material.coat_normal_map - 1, material.coat_normal_scale, false, s, mine);
        }
        vertex.coat_normal = select(mine, own, vertex.coat_normal);
    }
    if ((material.flags & MATERIAL_TURNED) != 0) {
        Vec3 along = s.along_u;
        if (material.turn_map > 0 || material.turn.y < 0.0f || material.turn.y > 0.0f || material.turn.x < 0.0f) {
            along = turned_along(world, material, s, mine);
        }
        vertex.point.along_u = select(mine, along, vertex.point.along_u);
    }
    if (world.watched != 0) {
        vertex.albedo = select(mine, material_albedo(world, material, s, direction, nanometres, mine), vertex.albedo);
        vertex.uv = vec2_of(select(mine, s.uv.x, vertex.uv.x), select(mine, s.uv.y, vertex.uv.y));
    }
}

// Loose triangles of one instance are done together, too, where no texture wants to know more about each.
FN bool is_bare(IN(WorldRecord) world, IN(ObjectRecord) object, int flags) {
    return object.kind == OBJECT_TRIANGLE && AT(world.meshes, object.mesh).flags == 0 && (flags & (MATERIAL_MAPPED | MATERIAL_TINTED)) == 0;
}

// Lanes that hit the same object are done together. Indices of clear borders are not found here: they need to know what the path is inside of.
// `width`: diameter of the path's beam where it meets them, in metres. `choice` in [0, 1) chooses from mixed materials.
FN void find_vertex(IN(WorldRecord) world, IN(Ray) ray, IN(Hit) hit, Float width, Float choice, Vec4 nanometres, Mask here,
                    INOUT(PathVertex) vertex) {
    int first_triangle = world.sphere_count + world.box_count + world.plane_count + world.placed_count;
    Mask on_triangle = both(here, is_above(hit.object, Int(first_triangle - 1)));
    on_triangle = without(on_triangle, is_above(hit.object, Int(first_triangle + world.triangle_count - 1)));
    Int instance = Int(-1);
    Int emitters = Int(-1);
    if (some(on_triangle)) {
        gather_object(world, hit.object, on_triangle, instance, emitters);
    }
    PlainColors plain = no_plain_colors();
    Mask todo = here;
    while (some(todo)) {
        int number = first_of(hit.object, todo);
        Mask mine = both(todo, is_equal(hit.object, Int(number)));
        ObjectRecord object = AT(world.objects, number);
        MaterialRecord material = AT(world.surfaces, object.material);
        SurfacePoint s;
        if (is_bare(world, object, material.flags)) {
            mine = both(both(todo, on_triangle), is_equal(instance, Int(object.instance)));
            s = bare_triangle_surface(world, object.instance, hit.object - Int(first_triangle), hit, mine);
            vertex.emitter = select(mine, emitters, vertex.emitter);
        } else {
            s = textured_surface(world, object, material.flags, ray, hit, width, mine);
            vertex.emitter = select(mine, object.emitter < -1 ? Int(-2 - object.emitter) + hit.part : Int(object.emitter), vertex.emitter);
        }
        Mask inside = dot(s.normal, ray.direction) > Float(0.0f);
        vertex.point.position = select(mine, s.position, vertex.point.position);
        vertex.point.error = select(mine, s.error, vertex.point.error);
        vertex.point.normal = select(mine, s.normal, vertex.point.normal);
        vertex.point.shading = select(mine, s.shading, vertex.point.shading);
        vertex.inside = either(vertex.inside, both(mine, inside));
        vertex.material = select(mine, Int(object.material), vertex.material);
        if ((material.flags & MATERIAL_PANE) != 0) {
            vertex.pane = either(vertex.pane, mine);
        }
        if ((material.flags & MATERIAL_EMITS) != 0) {
            Mask shines = mine;
            if ((material.flags & MATERIAL_EMITS_BEHIND) == 0) {
                shines = without(mine, inside);
            }
            vertex.emission = select(shines, color_value(world, material.emission, without_patch(s), nanometres, shines), vertex.emission);
        }
        if ((material.flags & MATERIAL_CHOOSES) != 0) {
            Int chosen = choose_material(world, object.material, s, inside, choice, mine);
            Mask waiting = mine;
            while (some(waiting)) {
                int which = first_of(chosen, waiting);
                Mask these = both(waiting, is_equal(chosen, Int(which)));
                take_material(world, AT(world.surfaces, which), s, ray.direction, inside, nanometres, these, vertex, plain);
                waiting = without(waiting, these);
            }
        } else {
            take_material(world, material, s, ray.direction, inside, nanometres, mine, vertex, plain);
        }
        todo = without(todo, mine);
    }
    if (some(plain.here)) {
        vertex.closure.color = select(plain.here, smooth_spectrum(plain.coefficients, nanometres) * plain.scale, vertex.closure.color);
    }
}

NAMESPACE_END

#endif
