// Any BSDF: lanes of the same kind are done together.
#ifndef LANCER_KERNEL_BSDF_BSDF_H
#define LANCER_KERNEL_BSDF_BSDF_H

#include "lancer/kernel/bsdf/burley.h"
#include "lancer/kernel/bsdf/conductor.h"
#include "lancer/kernel/bsdf/dielectric.h"
#include "lancer/kernel/bsdf/diffuse.h"
#include "lancer/kernel/bsdf/plastic.h"
#include "lancer/kernel/bsdf/principled.h"
#include "lancer/kernel/volume/phase.h"

NAMESPACE_BEGIN

// Whether all that the surface does is mirror and let through: no direction that was drawn elsewhere can be right.
FN Mask is_smooth(IN(Closure) c) {
    Mask mirror = without(is_equal(c.kind, Int(BSDF_CONDUCTOR)), is_rough(c));
    Mask glass = without(is_equal(c.kind, Int(BSDF_DIELECTRIC)), is_rough_border(c));
    Mask only = both(c.metalness + (Float(1.0f) - c.metalness) * c.transmission >= Float(1.0f), is_black(c.sheen));
    Mask coat = both(c.coat > Float(0.0f), c.coat_roughness >= Float(SMOOTH));
    Mask principled = without(without(both(is_equal(c.kind, Int(BSDF_PRINCIPLED)), only), coat), is_rough(c));
    return either(either(either(mirror, glass), principled), is_equal(c.kind, Int(BSDF_THIN_DIELECTRIC)));
}

// Whether what goes through is bent by the border of two media: the path has to know which.
FN Mask is_clear(IN(Closure) c) {
    Mask layered = either(is_equal(c.kind, Int(BSDF_PRINCIPLED)), is_equal(c.kind, Int(BSDF_BURLEY)));
    Mask principled = both(layered, without(c.transmission > Float(0.0f), c.thin));
    return either(is_equal(c.kind, Int(BSDF_DIELECTRIC)), principled);
}

// Whether nothing at all comes through it.
FN Mask is_opaque(IN(Closure) c) {
    Mask diffuse = either(is_equal(c.kind, Int(BSDF_DIFFUSE)), is_equal(c.kind, Int(BSDF_ROUGH_DIFFUSE)));
    Mask coated = either(is_equal(c.kind, Int(BSDF_CONDUCTOR)), is_equal(c.kind, Int(BSDF_PLASTIC)));
    Mask principled = without(is_equal(c.kind, Int(BSDF_PRINCIPLED)), c.transmission > Float(0.0f));
    Mask lets_through = either(c.transmission > Float(0.0f), both(c.thin, c.film_index > Float(0.0f)));
    Mask burley = without(is_equal(c.kind, Int(BSDF_BURLEY)), lets_through);
    return either(either(diffuse, coated), either(principled, burley));
}

// Whether what the surface sends back counts as diffuse, and not as glossy, where bounces are limited by kind. Media scatter as matt surfaces do.
FN Mask is_matt(IN(Closure) c) {
    Mask body =
        either(is_equal(c.kind, Int(BSDF_DIFFUSE)), either(is_equal(c.kind, Int(BSDF_ROUGH_DIFFUSE)), is_equal(c.kind, Int(BSDF_PLASTIC))));
    Float other = c.metalness + (Float(1.0f) - c.metalness) * c.transmission;
    Mask layered = either(is_equal(c.kind, Int(BSDF_PRINCIPLED)), is_equal(c.kind, Int(BSDF_BURLEY)));
    return either(either(body, is_phase(c)), both(layered, other < Float(0.5f)));
}

// Value and density of a direction that was drawn elsewhere; smooth surfaces have none. Media come without a cosine.
FN BsdfValue bsdf_value(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Vec3 wi, Mask mask) {
    BsdfValue value = no_value();
    Mask todo = mask;
    while (some(todo)) {
        int kind = first_of(c.kind, todo);
        Mask mine = both(todo, is_equal(c.kind, Int(kind)));
        if (kind == BSDF_DIFFUSE) {
            value = select_value(mine, diffuse_value(c, wi), value);
        } else if (kind == BSDF_ROUGH_DIFFUSE) {
            value = select_value(mine, rough_diffuse_value(c, wo, wi), value);
        } else if (kind == BSDF_CONDUCTOR) {
            value = select_value(mine, conductor_value(world, c, wo, wi, mine), value);
        } else if (kind == BSDF_DIELECTRIC) {
            value = select_value(mine, dielectric_value(world, c, wo, wi, mine), value);
        } else if (kind == BSDF_PLASTIC) {
            value = select_value(mine, plastic_value(world, c, wo, wi, mine), value);
        } else if (kind == BSDF_PRINCIPLED) {
            value = select_value(mine, principled_value(world, c, wo, wi, mine), value);
        } else if (kind == BSDF_BURLEY) {
            value = select_value(mine, burley_value(c, wo, wi, mine), value);
        } else if (kind >= PHASE_HENYEY_GREENSTEIN) {
            value = select_value(mine, phase_value(c, wo, wi), value);
        }
        todo = without(todo, mine);
    }
    return value;
}

// A direction for the path to go on, by three numbers in [0, 1).
FN BsdfSample bsdf_sample(IN(WorldRecord) world, IN(Closure) c, Vec3 wo, Float choice, Vec2 u, Mask mask) {
    BsdfSample drawn = no_sample();
    Mask todo = mask;
    while (some(todo)) {
        int kind = first_of(c.kind, todo);
        Mask mine = both(todo, is_equal(c.kind, Int(kind)));
        if (kind == BSDF_DIFFUSE) {
            drawn = select_sample(mine, diffuse_sample(c, u), drawn);
        } else if (kind == BSDF_ROUGH_DIFFUSE) {
            drawn = select_sample(mine, rough_diffuse_sample(c, wo, u), drawn);
        } else if (kind == BSDF_CONDUCTOR) {
            drawn = select_sample(mine, conductor_sample(world, c, wo, choice, u, mine), drawn);
        } else if (kind == BSDF_DIELECTRIC) {
            drawn = select_sample(mine, dielectric_sample(world, c, wo, choice, u, mine), drawn);
        } else if (kind == BSDF_THIN_DIELECTRIC) {
            drawn = select_sample(mine, thin_dielectric_sample(c, wo, choice), drawn);
        } else if (kind == BSDF_PLASTIC) {
            drawn = select_sample(mine, plastic_sample(world, c, wo, choice, u, mine), drawn);
        } else if (kind == BSDF_PRINCIPLED) {
            drawn = select_sample(mine, principled_sample(world, c, wo, choice, u, mine), drawn);
        } else if (kind == BSDF_BURLEY) {
            drawn = select_sample(mine, burley_sample(c, wo, choice, u, mine), drawn);
        } else if (kind >= PHASE_HENYEY_GREENSTEIN) {
            drawn = select_sample(mine, phase_sample(c, wo, u), drawn);
        }
        todo = without(todo, mine);
    }
    return drawn;
}

NAMESPACE_END

#endif
