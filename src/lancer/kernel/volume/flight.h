// How far light flies through a medium, and how much of it arrives.
//
// A medium may scatter each wavelength differently, and a path carries four. How far it flies is drawn for one of them; each is chosen as
// often as it has a share in what the path still carries, and the weights are those of all four together: the balance heuristic. So the sum of
// what is carried does not change by flying, whatever wavelength was chosen [Wilkie et al. 2014; Miller et al. 2019].
//
// In grids a ray meets as much everywhere as the block that it is in has at most. What is not there is met in vain, and it flies on
// [Woodcock et al. 1965]; light to lamps is dimmed a little by each such meeting instead [Novák et al. 2014].
//
// Numbers are drawn from `number` on, one pair for each meeting; the caller gives them a range of their own.
#ifndef LANCER_KERNEL_VOLUME_FLIGHT_H
#define LANCER_KERNEL_VOLUME_FLIGHT_H

#include "lancer/kernel/sampler.h"
#include "lancer/kernel/volume/volume.h"

NAMESPACE_BEGIN

const int MOST_MEETINGS = 65536;  // in one flight through a grid; what is thicker lets nothing through

struct Flight {
    Mask scattered;       // within reach
    Float distance;       // to where it is, in metres
    Spectrum weight;      // of the path from there on, or from the end of its reach on
    Spectrum emission;    // radiance that the medium adds, to be multiplied by what the path carried at the start
    Spectrum extinction;  // per metre, where it scattered
    Spectrum thinned;     // by which the chance to come so far fell with the distance, as far as that is known: 1 for grids
    Int phase;            // PHASE_*
    Float asymmetry;
};

FN Flight no_flight() {
    Flight f;
    f.scattered = nowhere();
    f.distance = Float(0.0f);
    f.weight = vec4_all(Float(1.0f));
    f.emission = black();
    f.extinction = vec4_all(Float(1.0f));
    f.thinned = vec4_all(Float(1.0f));
    f.phase = Int(PHASE_HENYEY_GREENSTEIN);
    f.asymmetry = Float(0.0f);
    return f;
}

FN Spectrum exponentials(Spectrum s) { return vec4_of(exponential(s.x), exponential(s.y), exponential(s.z), exponential(s.w)); }

FN Float sum_of(Spectrum s) { return (s.x + s.y) + (s.z + s.w); }

// With which chance each wavelength decides.
FN Spectrum wavelength_chances(IN(WorldRecord) world, Spectrum carried) {
    Spectrum c = max(carried, black());
    if (world.spectral == 0) {
        c.w = Float(0.0f);
    }
    return c / max(sum_of(c), Float(SMALLEST));
}

// The value of the wavelength that u in [0, 1) chooses; u becomes another such number.
FN Float chosen_value(Spectrum values, Spectrum chances, INOUT(Float) u) {
    Float value = values.x;
    Float low = Float(0.0f);
    Float width = chances.x;
    Float next = chances.x;
    Mask on = both(u >= next, chances.y > Float(0.0f));
    value = select(on, values.y, value);
    low = select(on, next, low);
    width = select(on, chances.y, width);
    next = next + chances.y;
    on = both(u >= next, chances.z > Float(0.0f));
    value = select(on, values.z, value);
    low = select(on, next, low);
    width = select(on, chances.z, width);
    next = next + chances.z;
    on = both(u >= next, chances.w > Float(0.0f));
    value = select(on, values.w, value);
    low = select(on, next, low);
    width = select(on, chances.w, width);
    u = min(max((u - low) / max(width, Float(SMALLEST)), Float(0.0f)), Float(1.0f - 2.0f * ROUNDING));
    return value;
}

// A number with the density exp(-x), for u in [0, 1).
FN Float drawn_depth(Float u) { return -natural_log(Float(1.0f) - u); }

FN Float per(Float depth, Float extinction) {
    return select(extinction > Float(0.0f), depth / max(extinction, Float(SMALLEST)), Float(FAR));
}

FN Flight fly_evenly(IN(WorldRecord) world, IN(VolumeRecord) volume, Float reach, Spectrum carried, Vec4 nanometres, IN(Sampler) numbers,
                     UInt number, Mask mask) {
    Flight f = no_flight();
    Coefficients c = volume_coefficients(world, volume, nanometres, mask);
    Spectrum all_through = exponentials(c.extinction * -reach);
    if ((volume.flags & VOLUME_EMITS) != 0) {
        f.emission = c.emission * (vec4_all(Float(1.0f)) - c.albedo) * (vec4_all(Float(1.0f)) - all_through);
    }
    f.weight = all_through;
    if ((volume.flags & VOLUME_SCATTERS) != 0) {
        Vec2 u = sample_pair(numbers, number);
        Spectrum chances = wavelength_chances(world, carried);
        Float chosen = chosen_value(c.extinction, chances, u.x);
        f.distance = per(drawn_depth(u.y), chosen);
        f.scattered = both(mask, f.distance < reach);
        Spectrum there = exponentials(c.extinction * -min(f.distance, reach));
        Spectrum lost = there * c.extinction;
        Spectrum turned = lost * c.albedo / max(sum_of(chances * lost), Float(SMALLEST));
        f.weight = select(f.scattered, turned, there / max(sum_of(chances * there), Float(SMALLEST)));
        f.extinction = c.extinction;
        f.thinned = there;
    }
    return f;
}

FN Flight fly_through_grid(IN(WorldRecord) world, IN(VolumeRecord) volume, Vec3 origin, Vec3 direction, Float reach, Spectrum carried,
                           Vec4 nanometres, IN(Sampler) numbers, Mask mask, INOUT(UInt) number) {
    Flight f = no_flight();
    GridRecord grid = AT(world.grids, volume.grid);
    Coefficients c = volume_coefficients(world, volume, nanometres, mask);
    March m = start_march(world, grid, origin, direction, reach, mask);
    Mask todo = m.inside;
    for (int i = 0; i < MOST_MEETINGS && some(todo); ++i) {
        Vec2 u = sample_pair(numbers, number);
        number = number + select(todo, UInt(1u), UInt(0u));
        Spectrum chances = wavelength_chances(world, carried * f.weight);
        Float chosen = chosen_value(c.extinction, chances, u.x);
        Float left_over = per(drawn_depth(u.y), chosen);
        Float passed = Float(0.0f);
        Mask met = march_on(world, grid, todo, m, left_over, passed);
        Spectrum through = exponentials(c.extinction * -passed);
        Spectrum gone = f.weight * through / max(sum_of(chances * through), Float(SMALLEST));
        f.weight = select(without(todo, met), gone, f.weight);
        todo = met;
        if (some(met)) {
            Spectrum lost = through * c.extinction;
            Spectrum weight = f.weight * lost / max(sum_of(chances * lost), Float(SMALLEST));
            Vec3 position = origin + direction * m.t;
            Spectrum density = density_at(world, grid, apply_affine(grid.to_grid, position), nanometres, met);
            Spectrum there = min(density / max(m.largest, Float(SMALLEST)), vec4_all(Float(1.0f)));
            Spectrum albedo = albedo_at(world, volume, position, nanometres, c, met);
            if ((volume.flags & VOLUME_EMITS) != 0) {
                Spectrum emission = emission_at(world, volume, position, nanometres, c, met);
                Spectrum glow = weight * there * (vec4_all(Float(1.0f)) - albedo) * emission;
                f.emission = select(met, f.emission + glow, f.emission);
            }
            Float turns = Float(0.0f);
            if ((volume.flags & VOLUME_SCATTERS) != 0) {
                turns = min(sum_of(wavelength_chances(world, carried * weight) * there), Float(1.0f));
            }
            Mask scatters = both(met, u.x < turns);
            Spectrum turned = weight * there * albedo / max(turns, Float(SMALLEST));
            Spectrum on = weight * (vec4_all(Float(1.0f)) - there) / max(Float(1.0f) - turns, Float(ROUNDING));
            f.weight = select(scatters, turned, select(met, on, f.weight));
            f.distance = select(scatters, m.t, f.distance);
            f.extinction = select(scatters, density * c.extinction, f.extinction);
            f.scattered = either(f.scattered, scatters);
            todo = without(without(met, scatters), is_black(f.weight));
        }
    }
    f.weight = select(todo, black(), f.weight);
    return f;
}

// From `origin` at most `reach` metres through each lane's volume. `carried`: by the path.
FN_LARGE Flight fly(IN(WorldRecord) world, Int volume, Vec3 origin, Vec3 direction, Float reach, Spectrum carried, Vec4 nanometres,
                    IN(Sampler) numbers, Mask mask, INOUT(UInt) number) {
    Flight f = no_flight();
    Mask todo = both(mask, is_above(volume, Int(-1)));
    while (some(todo)) {
        int which = first_of(volume, todo);
        Mask mine = both(todo, is_equal(volume, Int(which)));
        VolumeRecord record = AT(world.volumes, which);
        Flight own = no_flight();
        if (record.grid >= 0) {
            own = fly_through_grid(world, record, origin, direction, reach, carried, nanometres, numbers, mine, number);
        } else {
            own = fly_evenly(world, record, reach, carried, nanometres, numbers, number, mine);
            number = number + select(mine, UInt(1u), UInt(0u));
        }
        if (world.spectral == 0) {
            own.weight.w = Float(0.0f);
        }
        f.scattered = either(f.scattered, both(mine, own.scattered));
        f.distance = select(mine, own.distance, f.distance);
        f.weight = select(mine, own.weight, f.weight);
        f.emission = select(mine, own.emission, f.emission);
        f.extinction = select(mine, own.extinction, f.extinction);
        f.thinned = select(mine, own.thinned, f.thinned);
        f.phase = select(mine, Int(record.phase), f.phase);
        f.asymmetry = select(mine, Float(record.asymmetry), f.asymmetry);
        todo = without(todo, mine);
    }
    return f;
}

// ---- What arrives -------------------------------------------------------------------------------------------------------------------------

const float WORTH_FOLLOWING = 0.03125f;  // light that is fainter than this is followed by chance

// The densest wavelength says where it meets; each is dimmed by what it would lose there. Between 0 and 1, and right in the mean.
FN Spectrum grid_transmittance(IN(WorldRecord) world, IN(VolumeRecord) volume, Vec3 origin, Vec3 direction, Float reach, Vec4 nanometres,
                               IN(Sampler) numbers, Mask mask, INOUT(UInt) number) {
    Spectrum left_over = vec4_all(Float(1.0f));
    GridRecord grid = AT(world.grids, volume.grid);
    Coefficients c = volume_coefficients(world, volume, nanometres, mask);
    Float densest = largest(c.extinction);
    Spectrum share = c.extinction / max(densest, Float(SMALLEST));
    March m = start_march(world, grid, origin, direction, reach, mask);
    Mask todo = both(m.inside, densest > Float(0.0f));
    for (int i = 0; i < MOST_MEETINGS && some(todo); ++i) {
        Vec2 u = sample_pair(numbers, number);
        number = number + select(todo, UInt(1u), UInt(0u));
        Float depth = per(drawn_depth(u.y), densest);
        Float passed = Float(0.0f);
        todo = march_on(world, grid, todo, m, depth, passed);
        if (some(todo)) {
            Vec3 place = apply_affine(grid.to_grid, origin + direction * m.t);
            Spectrum there = density_at(world, grid, place, nanometres, todo) / max(m.largest, Float(SMALLEST));
            Spectrum dimmed = left_over * max(vec4_all(Float(1.0f)) - there * share, black());
            Float most = largest(dimmed);
            Float survives = select(most < Float(WORTH_FOLLOWING), Float(0.5f), Float(1.0f));
            dimmed = select(u.x < survives, dimmed / survives, black());
            left_over = select(todo, dimmed, left_over);
            todo = without(todo, is_black(left_over));
        }
    }
    return select(todo, black(), left_over);
}

// The share of light that is neither absorbed nor scattered in `reach` metres through each lane's volume: exact where it is even, else right in the
// mean. `thinned` is multiplied by what the chance to fly so far is known to fall to, as of a Flight.
FN_LARGE Spectrum transmittance_of_volume(IN(WorldRecord) world, Int volume, Vec3 origin, Vec3 direction, Float reach, Vec4 nanometres,
                                          IN(Sampler) numbers, Mask mask, INOUT(UInt) number, INOUT(Spectrum) thinned) {
    Spectrum left_over = vec4_all(Float(1.0f));
    Mask todo = both(mask, is_above(volume, Int(-1)));
    while (some(todo)) {
        int which = first_of(volume, todo);
        Mask mine = both(todo, is_equal(volume, Int(which)));
        VolumeRecord record = AT(world.volumes, which);
        Spectrum own = vec4_all(Float(1.0f));
        if (record.grid >= 0) {
            own = grid_transmittance(world, record, origin, direction, reach, nanometres, numbers, mine, number);
        } else {
            own = exponentials(volume_coefficients(world, record, nanometres, mine).extinction * -reach);
            if ((record.flags & VOLUME_SCATTERS) != 0) {
                thinned = select(mine, thinned * own, thinned);
            }
        }
        left_over = select(mine, own, left_over);
        todo = without(todo, mine);
    }
    return left_over;
}

NAMESPACE_END

#endif
