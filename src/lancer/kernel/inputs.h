// Numbers of materials that textures give.
#ifndef LANCER_KERNEL_INPUTS_H
#define LANCER_KERNEL_INPUTS_H

#include "lancer/kernel/bsdf/closure.h"
#include "lancer/kernel/mapping.h"

NAMESPACE_BEGIN

FN Float input_value(IN(WorldRecord) world, IN(InputRecord) source, IN(SurfacePoint) point, Mask mask) {
    Vec4 color = texture_color(world, AT(world.textures, source.texture), point, mask);
    return Float(source.offset) + Float(source.scale) * channel_of(color, source.channel);
}

// A share from 0 to 1; `input_number` is 0 where it is the same everywhere, else 1 + an input.
FN Float share_value(IN(WorldRecord) world, float everywhere, int input_number, IN(SurfacePoint) point, Mask mask) {
    Float share = Float(everywhere);
    if (input_number > 0) {
        share = clamp01(input_value(world, AT(world.inputs, input_number - 1), point, mask));
    }
    return share;
}

// Of a film on the surface, over the wavelength; red, green and blue stand for one wavelength each.
FN Spectrum film_thickness(Float thickness, Vec4 nanometres, bool spectral) {
    Vec4 at = nanometres;
    if (!spectral) {
        at = vec4_of(Float(611.0f), Float(549.0f), Float(464.0f), Float(549.0f));
    }
    return vec4_all(thickness) / at;
}

// Numbers that textures give. Those of a kind come after those that it builds upon.
FN void take_inputs(IN(WorldRecord) world, IN(MaterialRecord) material, IN(SurfacePoint) point, Vec4 nanometres, Mask mask,
                    INOUT(Closure) c) {
    for (int i = 0; i < material.input_count; ++i) {
        InputRecord source = AT(world.inputs, material.first_input + i);
        Float x = input_value(world, source, point, mask);
        Float share = clamp01(x);
        if (source.kind == INPUT_ROUGHNESS) {
            // The record holds the roughness of 1, stretched as the material is.
            Float alpha = material.kind == BSDF_ROUGH_DIFFUSE ? share : share * share;
            c.roughness_x = min(alpha * Float(material.roughness_x), Float(1.0f));
            c.roughness_y = min(alpha * Float(material.roughness_y), Float(1.0f));
        } else if (source.kind == INPUT_ANISOTROPY) {
            Float aspect = sqrt(Float(1.0f) - Float(0.9f) * share);
            c.roughness_x = min(c.roughness_x * aspect, Float(1.0f));
            c.roughness_y = min(c.roughness_y / aspect, Float(1.0f));
        } else if (source.kind == INPUT_METALNESS) {
            c.metalness = share;
        } else if (source.kind == INPUT_TRANSMISSION) {
            c.transmission = share;
        } else if (source.kind == INPUT_COAT) {
            c.coat = share;
        } else if (source.kind == INPUT_COAT_ROUGHNESS) {
            c.coat_roughness = share * share;
        } else if (source.kind == INPUT_SHEEN_ROUGHNESS) {
            c.sheen_roughness = share;
        } else if (source.kind == INPUT_FILM) {
            c.film = film_thickness(max(x, Float(0.0f)), nanometres, world.spectral != 0);
        } else if (source.kind == INPUT_PASSES) {
            c.film_index = share;
        }
    }
}

// ---- Which material -------------------------------------------------------------------------------------------------------------------

// Follows mixes, and materials that have another one behind, down to one that scatters light. One child of a mix is drawn for each vertex: that is
// right in the mean, costs one evaluation however deep mixes are nested, and the same number serves all of them, stretched anew each time.
FN Int choose_material(IN(WorldRecord) world, int start, IN(SurfacePoint) point, Mask inside, Float choice, Mask mask) {
    Int chosen = Int(start);
    Float u = choice;
    Mask turned = without(mask, mask);
    Mask todo = mask;
    while (some(todo)) {
        int number = first_of(chosen, todo);
        Mask mine = both(todo, is_equal(chosen, Int(number)));
        MaterialRecord material = AT(world.surfaces, number);
        Mask staying = mine;
        if (material.behind > 0) {
            // Turned over once only: what stands behind has no other side.
            Mask behind = both(without(mine, turned), inside);
            chosen = select(behind, Int(material.behind - 1), chosen);
            turned = either(turned, behind);
            staying = without(mine, behind);
        }
        if (material.mix_first > 0 && (material.flags & MATERIAL_BLENDS) == 0) {
            Float share = share_value(world, material.mix_share, material.mix_input, point, staying);
            Mask second = u < share;
            Float rest = select(second, u / max(share, Float(SMALLEST)), (u - share) / max(Float(1.0f) - share, Float(SMALLEST)));
            u = select(staying, min(rest, Float(0.99999994f)), u);
            chosen = select(staying, select(second, Int(material.mix_second - 1), Int(material.mix_first - 1)), chosen);
        } else {
            todo = without(todo, staying);
        }
    }
    return chosen;
}

NAMESPACE_END

#endif
