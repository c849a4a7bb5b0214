// Stretched facets: by how much they lose more light in one meeting than the round ones of albedo.h by which they are looked up.
//
// These parts of the table (made by world/generator/make_albedo_table.cpp) have nodes at even steps of the root of the root mean square roughness, of
// the logarithm of the ratio of the two roughnesses, of the direction's turn from the rougher axis, and of cosines as in albedo.h. Ratios beyond 10
// are taken for 10. Facets that hide one another towards either direction by itself have no such parts: they are looked up as round ones.
#ifndef LANCER_KERNEL_BSDF_STRETCHED_H
#define LANCER_KERNEL_BSDF_STRETCHED_H

#include "lancer/kernel/bsdf/albedo.h"

NAMESPACE_BEGIN

struct StretchedShape {
    Mask stretched;
    TablePlace rough;
    TablePlace ratio;
};

struct StretchedView {
    TablePlace cosine;
    TablePlace turn;
};

FN Int distribution_of_stretched(IN(Facets) f) { return select(f.beckmann, Int(1), Int(0)); }

FN StretchedShape stretched_shape(IN(Facets) f, IN(StretchedGrid) grid, Mask mask) {
    Float most = max(f.x, f.y);
    Float ratio = most / max(min(f.x, f.y), Float(SMALLEST));
    StretchedShape shape;
    shape.stretched = without(both(mask, ratio > Float(1.001f)), f.separate);
    shape.rough = place_in_table(sqrt(sqrt(mean_square_roughness(f))), grid.roughnesses);
    shape.ratio = place_in_table(log_2(max(ratio, Float(1.0f))) * Float(0.30103f), grid.ratios);
    return shape;
}

FN StretchedView stretched_view(IN(Facets) f, Vec3 w, Float critical, IN(StretchedGrid) grid) {
    Float x = abs(w.x);
    Float y = abs(w.y);
    Float across = select(f.x < f.y, x, y);
    StretchedView view;
    view.cosine = place_in_table(place_of_cosine(abs(w.z), critical), grid.cosines);
    view.turn = place_in_table(across / max(x + y, Float(SMALLEST)), grid.turns);
    return view;
}

FN Float between_four(IN(WorldRecord) world, Int at, int step, Float part, Float step_part, Mask mask) {
    Float low = between(gather_float(world.albedo, at, mask), gather_float(world.albedo, at + Int(1), mask), part);
    Int next = at + Int(step);
    Float high = between(gather_float(world.albedo, next, mask), gather_float(world.albedo, next + Int(1), mask), part);
    return between(low, high, step_part);
}

// `sheet`: of the grid's, counted from its first.
FN Float stretched_loss(IN(WorldRecord) world, IN(StretchedGrid) grid, Int sheet, IN(StretchedShape) shape, IN(StretchedView) view) {
    int of_cosine = grid.turns;
    int of_ratio = of_cosine * grid.cosines;
    int of_rough = of_ratio * grid.ratios;
    Int at = Int(grid.first) + sheet * Int(of_rough * grid.roughnesses) + shape.rough.entry * Int(of_rough) +
             shape.ratio.entry * Int(of_ratio) + view.cosine.entry * Int(of_cosine) + view.turn.entry;
    Float value = Float(0.0f);
    for (int i = 0; i < 2; ++i) {
        Int from = at + Int(i * of_rough);
        Float low = between_four(world, from, of_cosine, view.turn.part, view.cosine.part, shape.stretched);
        Float high = between_four(world, from + Int(of_ratio), of_cosine, view.turn.part, view.cosine.part, shape.stretched);
        Float share = i == 0 ? Float(1.0f) - shape.rough.part : shape.rough.part;
        value = value + between(low, high, shape.ratio.part) * share;
    }
    return value;
}

// The mean of all that they lose, not of the difference only.
FN Float mean_stretched_loss(IN(WorldRecord) world, IN(StretchedGrid) grid, Int sheet, IN(StretchedShape) shape) {
    Int at = Int(grid.first_mean) + (sheet * Int(grid.roughnesses) + shape.rough.entry) * Int(grid.ratios) + shape.ratio.entry;
    return between_four(world, at, grid.ratios, shape.ratio.part, shape.rough.part, shape.stretched);
}

// ---- Facets that reflect everything. -----------------------------------------------------------------------------------------------------

FN StretchedGrid stretched_mirrors() {
    StretchedGrid grid;
    grid.first = STRETCHED_MIRRORS;
    grid.first_mean = STRETCHED_MIRROR_MEANS;
    grid.roughnesses = MIRROR_ROUGHNESSES;
    grid.ratios = MIRROR_RATIOS;
    grid.cosines = MIRROR_COSINES;
    grid.turns = MIRROR_TURNS;
    return grid;
}

// What they lose towards a direction, where the second lobe gives it back; below, its mean over directions.
FN Float facet_loss(IN(WorldRecord) world, IN(Facets) f, Vec3 w, Mask mask) {
    TablePlace rough = place_in_table(sqrt(sqrt(mean_square_roughness(f))), ALBEDO_ROUGHNESSES);
    TablePlace cosine = place_in_table(sqrt(cosine_of_round_facets(f, w)), ALBEDO_COSINES);
    Float loss = albedo_of_sheet(world, Int(ALBEDO_MIRROR) + distribution_of(f), rough, cosine, mask);
    StretchedGrid grid = stretched_mirrors();
    StretchedShape shape = stretched_shape(f, grid, mask);
    if (some(shape.stretched)) {
        loss = max(loss + stretched_loss(world, grid, distribution_of_stretched(f), shape, stretched_view(f, w, Float(0.0f), grid)),
                   Float(0.0f));
    }
    return select(f.once, Float(0.0f), loss);
}

FN Float mean_facet_loss(IN(WorldRecord) world, IN(Facets) f, Mask mask) {
    TablePlace rough = place_in_table(sqrt(sqrt(mean_square_roughness(f))), ALBEDO_ROUGHNESSES);
    Float loss = mean_of_sheet(world, Int(ALBEDO_MIRROR) + distribution_of(f), rough, mask);
    StretchedGrid grid = stretched_mirrors();
    StretchedShape shape = stretched_shape(f, grid, mask);
    if (some(shape.stretched)) {
        loss = select(shape.stretched, mean_stretched_loss(world, grid, distribution_of_stretched(f), shape), loss);
    }
    return loss;
}

// ---- Clear borders. ----------------------------------------------------------------------------------------------------------------------

FN StretchedGrid stretched_borders() {
    StretchedGrid grid;
    grid.first = STRETCHED_BORDERS;
    grid.first_mean = STRETCHED_BORDER_MEANS;
    grid.roughnesses = BORDER_ROUGHNESSES;
    grid.ratios = BORDER_RATIOS;
    grid.cosines = BORDER_COSINES;
    grid.turns = BORDER_TURNS;
    return grid;
}

// The sheet of the next lower index, and how far it is to the next one.
FN TablePlace stretched_index(Float eta) {
    Float ratio = abs(eta - Float(1.0f)) / (eta + Float(1.0f));
    return place_in_table(sqrt(ratio * Float(1.0f / ALBEDO_LARGEST_RATIO)), BORDER_INDICES);
}

FN Int stretched_sheet(IN(TablePlace) index, Float eta, IN(Facets) f) {
    Int side = select(eta < Float(1.0f), Int(1), Int(0));
    return (distribution_of_stretched(f) * Int(2) + side) * Int(BORDER_INDICES) + index.entry;
}

// What a border loses of light along w, on the side from which its relative index is eta; below, its mean over directions.
FN Float border_lost(IN(WorldRecord) world, IN(Facets) f, Float eta, Vec3 w, Mask mask) {
    // From the denser side the critical angle counts: towards the horizon round facets are taken that are as rough as these are along w.
    Float along = f.x * f.x * w.x * w.x + f.y * f.y * w.y * w.y;
    Float square = mean_square_roughness(f);
    square = select(eta < Float(1.0f), square * w.z * w.z + along, square);
    Float loss = albedo_at(world, border_place(eta, sqrt(square), f), cosine_of_facets(f, square, w), mask);
    StretchedGrid grid = stretched_borders();
    StretchedShape shape = stretched_shape(f, grid, mask);
    if (some(shape.stretched)) {
        TablePlace index = stretched_index(eta);
        Int sheet = stretched_sheet(index, eta, f);
        StretchedView view = stretched_view(f, w, critical_cosine(eta), grid);
        Float more =
            between(stretched_loss(world, grid, sheet, shape, view), stretched_loss(world, grid, sheet + Int(1), shape, view), index.part);
        loss = max(loss + more, Float(0.0f));
    }
    return loss;
}

FN Float mean_border_lost(IN(WorldRecord) world, IN(Facets) f, Float eta, Mask mask) {
    Float loss = mean_albedo(world, border_place(eta, sqrt(mean_square_roughness(f)), f), mask);
    StretchedGrid grid = stretched_borders();
    StretchedShape shape = stretched_shape(f, grid, mask);
    if (some(shape.stretched)) {
        TablePlace index = stretched_index(eta);
        Int sheet = stretched_sheet(index, eta, f);
        Float mean =
            between(mean_stretched_loss(world, grid, sheet, shape), mean_stretched_loss(world, grid, sheet + Int(1), shape), index.part);
        loss = select(shape.stretched, mean, loss);
    }
    return loss;
}

NAMESPACE_END

#endif
