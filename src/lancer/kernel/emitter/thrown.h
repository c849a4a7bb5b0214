// Lights without size that throw a picture: a projector through its lens, a goniometric light in all directions, and a lamp with the intensities of a
// photometric file.
//
// A direction has its place (u, v) in the picture, from its lower left corner. Projectors: on a plane at right angles to `direction`. The others: u is
// the angle about an axis in full turns and v the angle from the axis's far end, in half turns; the middle of a goniometric picture lies along
// `direction`, and its axis is `upwards`. Those of photometric files start at `across`, and v = 0 lies along `direction`.
#ifndef LANCER_KERNEL_EMITTER_THROWN_H
#define LANCER_KERNEL_EMITTER_THROWN_H

#include "lancer/kernel/distribution.h"
#include "lancer/kernel/spectrum.h"

NAMESPACE_BEGIN

FN bool is_thrown(IN(EmitterRecord) emitter) {
    return emitter.kind == EMITTER_PROJECTOR || emitter.kind == EMITTER_GONIOMETRIC || emitter.kind == EMITTER_IES;
}

struct ThrownPlace {
    Vec2 uv;
    Float depth;  // cosine of the angle from the axis
    Mask inside;  // of the picture
};

// Of light that leaves along `way`, of length 1.
FN ThrownPlace thrown_place(IN(EmitterRecord) emitter, Vec3 way) {
    ThrownPlace place;
    place.depth = dot(way, broadcast(emitter.direction));
    Float x = dot(way, broadcast(emitter.across));
    Float y = dot(way, broadcast(emitter.upwards));
    if (emitter.kind == EMITTER_PROJECTOR || emitter.kind == EMITTER_SPOT) {
        Float ahead = max(place.depth, Float(1.0e-6f));
        x = x / ahead;
        y = y / ahead;
        place.uv = vec2_of(Float(0.5f) + Float(0.5f) * x, Float(0.5f) + Float(0.5f) * y);
        Mask wide = either(abs(x) > Float(1.0f), abs(y) > Float(1.0f));
        place.inside = without(place.depth > Float(1.0e-6f), wide);
    } else if (emitter.kind == EMITTER_GONIOMETRIC) {
        Float ring = sqrt(x * x + place.depth * place.depth);
        place.uv = vec2_of(fraction(angle_of(x, place.depth) * Float(0.5f / PI) + Float(0.5f)),
                           Float(0.5f) + angle_of(y, ring) * Float(1.0f / PI));
        place.inside = ring >= Float(0.0f);
    } else {
        Float ring = sqrt(x * x + y * y);
        place.uv = vec2_of(fraction(angle_of(y, x) * Float(0.5f / PI) + Float(1.0f)), angle_of(ring, place.depth) * Float(1.0f / PI));
        place.inside = ring >= Float(0.0f);
    }
    return place;
}

// ---- Photometric files -------------------------------------------------------------------------------------------------------------------

// Where x lies between rising values of a table: the value before it, and how far it is to the next, 0 to 1.
struct Between {
    Int before;
    Float share;
};

FN Between find_between(IN(WorldRecord) world, int first, int count, Float x, Mask mask) {
    Between found;
    Int after = find_share(world, Int(first), count, x, mask);
    after = select(is_above(after, Int(0)), after, Int(1));
    found.before = after - Int(1);
    Float low = gather_float(world.distributions, found.before + Int(first), mask);
    Float high = gather_float(world.distributions, after + Int(first), mask);
    found.share = clamp01((x - low) / max(high - low, Float(SMALLEST)));
    return found;
}

FN Float profile_value(IN(WorldRecord) world, int profile, Vec2 place, Mask mask) {
    int rows = int(AT(world.distributions, profile));
    int columns = int(AT(world.distributions, profile + 1));
    int angles = profile + 2;
    Between down = find_between(world, angles, rows, place.y, mask);
    Between around = find_between(world, angles + rows, columns, place.x, mask);
    Int first = Int(angles + rows + columns) + around.before * Int(rows) + down.before;
    Int second = first + Int(rows);
    Float one = Float(1.0f);
    Float left = gather_float(world.distributions, first, mask) * (one - down.share) +
                 gather_float(world.distributions, first + Int(1), mask) * down.share;
    Float right = gather_float(world.distributions, second, mask) * (one - down.share) +
                  gather_float(world.distributions, second + Int(1), mask) * down.share;
    Float value = left * (one - around.share) + right * around.share;
    // A little room for the rounding of angles.
    Mask beyond = place.y > Float(AT(world.distributions, angles + rows - 1)) + Float(4.0e-7f);
    return select(beyond, Float(0.0f), value);
}

// What the light's colour, its picture's included, is multiplied by in the direction `way`.
FN Float thrown_share(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec3 way, Mask mask) {
    ThrownPlace place = thrown_place(emitter, way);
    Float share = select(place.inside, Float(1.0f), Float(0.0f));
    if (emitter.kind == EMITTER_IES) {
        share = profile_value(world, emitter.profile, place.uv, mask);
    } else if (emitter.even != 0) {
        Float depth = max(place.depth, Float(1.0e-6f));
        share = share / (depth * depth * depth);
    }
    return share;
}

// ---- Directions drawn by the picture's brightness, for paths that start at the light ----------------------------------------------------

struct ThrownWay {
    Vec3 way;       // of length 1
    Float density;  // per solid angle
};

FN Float length_2(vec3 v) { return Float(v.x * v.x + v.y * v.y + v.z * v.z); }

// The solid angle at a place of the picture for each unit of (u, v).
FN Float thrown_stretch(IN(EmitterRecord) emitter, Float depth, Float row_height) {
    Float stretch = Float(2.0f * PI) * row_height;
    if (emitter.kind == EMITTER_PROJECTOR) {
        Float across_2 = length_2(emitter.across);
        Float upwards_2 = length_2(emitter.upwards);
        stretch = Float(4.0f) * depth * depth * depth / sqrt(across_2 * upwards_2);
    }
    return stretch;
}

// Cosines of the angle from v = 0 at the lower and the upper edge of a row.
FN Vec2 thrown_edges(IN(EmitterRecord) emitter, Int row) {
    Float step = Float(0.5f / float(emitter.share_count));
    return vec2_of(on_circle(to_float(row) * step).x, on_circle(to_float(row + Int(1)) * step).x);
}

// Of the cell, for each unit of (u, v); and of a direction in it, at that depth.
FN Float cell_density(IN(WorldRecord) world, IN(EmitterRecord) emitter, Int row, Int column, Float depth, Mask mask) {
    Float rows = Float(float(emitter.share_count));
    Float share = own_share(world, Int(emitter.first_share), row, mask) *
                  own_share(world, row * Int(emitter.columns) + Int(emitter.first_share + emitter.share_count), column, mask);
    Vec2 edges = thrown_edges(emitter, row);
    Float stretch = thrown_stretch(emitter, depth, (edges.x - edges.y) * rows);
    return share * rows * Float(float(emitter.columns)) / max(stretch, Float(SMALLEST));
}

FN ThrownWay thrown_sample(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec2 u, Mask mask) {
    ThrownWay drawn;
    Int rows = Int(emitter.first_share);
    Int row = find_share(world, rows, emitter.share_count, u.y, mask);
    Float up = rest_of(u.y, gather_float(world.distributions, row + rows, mask), own_share(world, rows, row, mask));
    Int columns = row * Int(emitter.columns) + Int(emitter.first_share + emitter.share_count);
    Int column = find_share(world, columns, emitter.columns, u.x, mask);
    Float along = rest_of(u.x, gather_float(world.distributions, column + columns, mask), own_share(world, columns, column, mask));
    Float x = (to_float(column) + along) * Float(1.0f / float(emitter.columns));
    Vec3 axis = broadcast(emitter.direction);
    if (emitter.kind == EMITTER_PROJECTOR) {
        Float y = (to_float(row) + up) * Float(1.0f / float(emitter.share_count));
        Float across_2 = length_2(emitter.across);
        Float upwards_2 = length_2(emitter.upwards);
        Vec3 right = broadcast(emitter.across) * ((Float(2.0f) * x - Float(1.0f)) / across_2);
        drawn.way = normalize(axis + right + broadcast(emitter.upwards) * ((Float(2.0f) * y - Float(1.0f)) / upwards_2));
    } else {
        Vec2 edges = thrown_edges(emitter, row);
        Float cosine = edges.x + (edges.y - edges.x) * up;
        Float sine = sqrt(max(Float(1.0f) - cosine * cosine, Float(0.0f)));
        if (emitter.kind == EMITTER_GONIOMETRIC) {
            Vec2 around = on_circle(fraction(x + Float(0.5f)));
            drawn.way = axis * (around.x * sine) + broadcast(emitter.across) * (around.y * sine) - broadcast(emitter.upwards) * cosine;
        } else {
            Vec2 around = on_circle(x);
            drawn.way = broadcast(emitter.across) * (around.x * sine) + broadcast(emitter.upwards) * (around.y * sine) + axis * cosine;
        }
    }
    drawn.density = cell_density(world, emitter, row, column, dot(drawn.way, axis), mask);
    return drawn;
}

// 0 outside the picture.
FN Float thrown_density(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec3 way, Mask mask) {
    ThrownPlace place = thrown_place(emitter, way);
    Float columns = Float(float(emitter.columns));
    Float rows = Float(float(emitter.share_count));
    Float column = min(max(floor(place.uv.x * columns), Float(0.0f)), columns - Float(1.0f));
    Float row = min(max(floor(place.uv.y * rows), Float(0.0f)), rows - Float(1.0f));
    Float density = cell_density(world, emitter, round_to_int(row), round_to_int(column), place.depth, mask);
    return select(place.inside, density, Float(0.0f));
}

NAMESPACE_END

#endif
