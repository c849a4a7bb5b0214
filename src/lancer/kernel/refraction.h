// Light at the border of two transparent media: which are there, how they bend it, how much they let through.
#ifndef LANCER_KERNEL_REFRACTION_H
#define LANCER_KERNEL_REFRACTION_H

#include "lancer/kernel/ray.h"
#include "lancer/kernel/spectrum.h"

NAMESPACE_BEGIN

const float D_LINE = 587.5618f;  // nanometres; white light is bent as this one

// The materials that the ray is inside of, the last one entered first; -1 = none. Bodies may be nested four deep.
struct Media {
    Int first;
    Int second;
    Int third;
    Int fourth;
};

FN Media no_media() {
    Media m;
    m.first = Int(-1);
    m.second = Int(-1);
    m.third = Int(-1);
    m.fourth = Int(-1);
    return m;
}

FN Media entered(IN(Media) media, Int material) {
    Media m;
    m.first = material;
    m.second = media.first;
    m.third = media.second;
    m.fourth = media.third;
    return m;
}

// Takes the material's last entry out; leaving a body that was never entered changes nothing.
FN Media left(IN(Media) media, Int material) {
    Mask at_first = is_equal(media.first, material);
    Mask at_second = either(at_first, is_equal(media.second, material));
    Mask at_third = either(at_second, is_equal(media.third, material));
    Mask at_fourth = either(at_third, is_equal(media.fourth, material));
    Media m;
    m.first = select(at_first, media.second, media.first);
    m.second = select(at_second, media.third, media.second);
    m.third = select(at_third, media.fourth, media.third);
    m.fourth = select(at_fourth, Int(-1), media.fourth);
    return m;
}

FN Mask is_inside(IN(Media) media, Int material) {
    return either(either(is_equal(media.first, material), is_equal(media.second, material)),
                  either(is_equal(media.third, material), is_equal(media.fourth, material)));
}

// What fills the way to a border of `material`; `inside`: the border is met from within. A body that is left without having been entered was
// there all along. Where bodies overlap, the one entered last fills the overlap, so that a ray is in one medium from border to border.
FN Int medium_before(IN(Media) media, Int material, Mask inside) {
    return select(without(inside, is_inside(media, material)), material, media.first);
}

FN Media select_media(Mask mask, IN(Media) a, IN(Media) b) {
    Media m;
    m.first = select(mask, a.first, b.first);
    m.second = select(mask, a.second, b.second);
    m.third = select(mask, a.third, b.third);
    m.fourth = select(mask, a.fourth, b.fourth);
    return m;
}

FN Float medium_index(IN(MediumRecord) medium, Float nanometres) {
    Float n = Float(1.0f);
    if (medium.refraction == REFRACTION_SELLMEIER) {
        Float micrometres_2 = nanometres * nanometres * Float(1.0e-6f);
        Float sum = Float(medium.refraction_a.x) * micrometres_2 / (micrometres_2 - Float(medium.refraction_b.x)) +
                    Float(medium.refraction_a.y) * micrometres_2 / (micrometres_2 - Float(medium.refraction_b.y)) +
                    Float(medium.refraction_a.z) * micrometres_2 / (micrometres_2 - Float(medium.refraction_b.z));
        n = sqrt(Float(1.0f) + sum);
    } else {
        n = Float(medium.refraction_a.x) + Float(medium.refraction_a.y) / (nanometres * nanometres);
    }
    return n;
}

// Straight lines between the entries of a curve.
FN Float curve_between(FloatTable curves, int curve, Float nanometres, Mask mask) {
    Float place = min(max(nanometres - Float(FIRST_WAVELENGTH), Float(0.0f)), Float(LAST_WAVELENGTH - FIRST_WAVELENGTH));
    Float below = min(floor(place), Float(LAST_WAVELENGTH - FIRST_WAVELENGTH - 1.0f));
    Int entry = Int(curve * WAVELENGTH_COUNT) + round_to_int(below);
    Float a = gather_float(curves, entry, mask);
    Float b = gather_float(curves, entry + Int(1), mask);
    return a + (b - a) * (place - below);
}

// Of whatever material each lane is in; 1 outside of all.
FN Float refractive_index(IN(WorldRecord) world, Int material, Float nanometres, Mask alive) {
    Float n = Float(1.0f);
    Mask todo = both(alive, is_above(material, Int(-1)));
    while (some(todo)) {
        int number = first_of(material, todo);
        Mask mine = both(todo, is_equal(material, Int(number)));
        MediumRecord medium = AT(world.media, number);
        Float index = Float(1.0f);
        if (medium.refraction == REFRACTION_CURVE) {
            index = curve_between(world.curves, medium.curve, nanometres, mine);
        } else {
            index = medium_index(medium, nanometres);
        }
        n = select(mine, index, n);
        todo = without(todo, mine);
    }
    return n;
}

// What is left of light after a distance inside each lane's medium [Bouguer 1729].
FN Vec3 transmittance(IN(WorldRecord) world, Int material, Float distance, Mask alive) {
    Vec3 left_over = vec3_all(Float(1.0f));
    Mask todo = both(alive, is_above(material, Int(-1)));
    while (some(todo)) {
        int number = first_of(material, todo);
        Mask mine = both(todo, is_equal(material, Int(number)));
        vec3 absorption = AT(world.media, number).absorption;
        Vec3 passes = vec3_of(exponential(Float(-absorption.x) * distance), exponential(Float(-absorption.y) * distance),
                              exponential(Float(-absorption.z) * distance));
        left_over = select(mine, passes, left_over);
        todo = without(todo, mine);
    }
    return left_over;
}

// The square of the refracted ray's cosine by Snell's law: 1 - sin^2 / eta^2, without cancellation where eta is near 1 or the angle near the
// critical one, and negative beyond that.
FN Float squared_cos_t(Float cos_i, Float eta) { return ((eta - Float(1.0f)) * (eta + Float(1.0f)) + cos_i * cos_i) / (eta * eta); }

// Share of unpolarised light that a smooth border reflects [Fresnel 1823]; `eta` is the index behind over the one in front. Also gives the
// cosine of the refracted ray; all is reflected, and that cosine 0, beyond the critical angle.
FN Float fresnel(Float cos_i, Float eta, INOUT(Float) cos_t) {
    Float cos_t_2 = squared_cos_t(cos_i, eta);
    Mask total = cos_t_2 <= Float(0.0f);
    cos_t = sqrt(max(cos_t_2, Float(0.0f)));
    Float parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    Float perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    Float share = (parallel * parallel + perpendicular * perpendicular) * Float(0.5f);
    return select(total, Float(1.0f), share);
}

// What the border of a transparent body does to a ray that meets it.
struct Border {
    Media beyond;  // the media on its far side
    Float eta;     // index behind over index in front
    Float cos_t;   // of the refracted ray
    Float share;   // reflected
};

// `inside`: the ray meets the body's border from within.
FN Border border_at(IN(WorldRecord) world, IN(Media) media, Int material, Mask inside, Float cos_i, Float nanometres, Mask alive) {
    Border border;
    border.beyond = select_media(inside, left(media, material), entered(media, material));
    Int front = medium_before(media, material, inside);
    border.eta = refractive_index(world, border.beyond.first, nanometres, alive) / refractive_index(world, front, nanometres, alive);
    border.cos_t = Float(0.0f);
    border.share = fresnel(cos_i, border.eta, border.cos_t);
    return border;
}

FN Border select_border(Mask mask, IN(Border) a, IN(Border) b) {
    Border border;
    border.beyond = select_media(mask, a.beyond, b.beyond);
    border.eta = select(mask, a.eta, b.eta);
    border.cos_t = select(mask, a.cos_t, b.cos_t);
    border.share = select(mask, a.share, b.share);
    return border;
}

// Snell's law for a ray along `direction` against a normal that faces it.
FN Vec3 refracted(Vec3 direction, Vec3 normal, Float cos_i, Float cos_t, Float eta) {
    return normalize(direction / eta + normal * (cos_i / eta - cos_t));
}

// As above for a smooth normal `shading`; where that would send the ray out over the surface itself, its true normal, `normal`, bends it, at
// most to along the surface.
FN Vec3 refracted_below(Vec3 direction, Vec3 shading, Vec3 normal, Float cos_i, IN(Border) border) {
    Vec3 below = refracted(direction, shading, cos_i, border.cos_t, border.eta);
    Mask outside = dot(below, normal) >= Float(0.0f);
    if (some(outside)) {
        Float true_cos_i = -dot(direction, normal);
        Float true_cos_t = sqrt(max(squared_cos_t(true_cos_i, border.eta), Float(0.0f)));
        below = select(outside, refracted(direction, normal, true_cos_i, true_cos_t, border.eta), below);
    }
    return below;
}

NAMESPACE_END

#endif
