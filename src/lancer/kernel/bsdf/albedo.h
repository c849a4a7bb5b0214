// How much light rough surfaces reflect after one meeting with a facet, tabulated; what is left to 1 has met more than one, and is given back
// by smooth lobes [Kulla and Conty 2017].
//
// The table (world.albedo, made by world/generator/make_albedo_table.cpp) has nodes at even steps of the root of the cosine, of the root of
// the roughness alpha, and of the root of (eta - 1) / (eta + 1). From the denser side of a border they crowd about the critical angle instead, where
// light that goes through leaves along the border and is lost: see place_within(). Its parts, each for GGX and then for Beckmann, and both again for facets that hide one
// another towards either direction by itself:
//   mirror   1 - albedo of facets that reflect everything
//   coat     albedo of what a clear border reflects, seen from outside
//   border   1 - albedo of what it reflects and lets through, from the side of lower index and then from the other
// then the sheen's albedo; then the means of all these, weighted by the cosine, over directions.
#ifndef LANCER_KERNEL_BSDF_ALBEDO_H
#define LANCER_KERNEL_BSDF_ALBEDO_H

#include "lancer/kernel/bsdf/microfacet.h"
#include "lancer/kernel/tables.h"

NAMESPACE_BEGIN

const int ALBEDO_COSINES = 41;  // so that HALF_CRITICAL_PLACE and CRITICAL_PLACE are nodes
const int ALBEDO_ROUGHNESSES = 32;
const int ALBEDO_INDICES = 32;
const float ALBEDO_LARGEST_RATIO = 0.5f;  // (eta - 1) / (eta + 1) of eta = 3
const int ALBEDO_SHEET = ALBEDO_COSINES * ALBEDO_ROUGHNESSES;

// Sheets of all cosines and roughnesses, counted from the start.
const int ALBEDO_MIRROR = 0;
const int ALBEDO_DISTRIBUTIONS = 4;
const int ALBEDO_COAT = ALBEDO_DISTRIBUTIONS;
const int ALBEDO_BORDER = ALBEDO_COAT + ALBEDO_DISTRIBUTIONS * ALBEDO_INDICES;
const int ALBEDO_SHEEN = ALBEDO_BORDER + 2 * ALBEDO_DISTRIBUTIONS * ALBEDO_INDICES;
const int ALBEDO_SHEETS = ALBEDO_SHEEN + 1;
const int ALBEDO_MEANS = ALBEDO_SHEETS * ALBEDO_SHEET;  // ALBEDO_ROUGHNESSES means for each sheet
const int STRETCHED_MIRRORS = ALBEDO_MEANS + ALBEDO_SHEETS * ALBEDO_ROUGHNESSES;

// Stretched facets, see stretched.h: mirrors, one sheet for each distribution; then clear borders.
struct StretchedGrid {
    int first;
    int first_mean;
    int roughnesses;
    int ratios;
    int cosines;
    int turns;
};
const int MIRROR_ROUGHNESSES = 12;
const int MIRROR_RATIOS = 7;
const int MIRROR_COSINES = 12;
const int MIRROR_TURNS = 9;
const int STRETCHED_MIRROR_MEANS = STRETCHED_MIRRORS + 2 * MIRROR_ROUGHNESSES * MIRROR_RATIOS * MIRROR_COSINES * MIRROR_TURNS;
const int STRETCHED_BORDERS = STRETCHED_MIRROR_MEANS + 2 * MIRROR_ROUGHNESSES * MIRROR_RATIOS;
const int BORDER_INDICES = 12;
const int BORDER_ROUGHNESSES = 12;
const int BORDER_RATIOS = 6;
const int BORDER_COSINES = 16;
const int BORDER_TURNS = 9;
const int BORDER_SHEETS = 4 * BORDER_INDICES;  // by distribution, then by side
const int STRETCHED_BORDER_MEANS = STRETCHED_BORDERS + BORDER_SHEETS * BORDER_ROUGHNESSES * BORDER_RATIOS * BORDER_COSINES * BORDER_TURNS;
const int ALBEDO_VALUES = STRETCHED_BORDER_MEANS + BORDER_SHEETS * BORDER_ROUGHNESSES * BORDER_RATIOS;

struct TablePlace {
    Int entry;
    Float part;  // of the way to the next
};

FN TablePlace place_in_table(Float x, int count) {
    Float at = clamp01(x) * Float(float(count - 1));
    TablePlace place;
    place.entry = to_int(min(at, Float(float(count) - 1.5f)));
    place.part = at - to_float(place.entry);
    return place;
}

// Of the cosine of the critical angle, on the side from which the relative index is eta; 0 where light goes through at all angles.
FN Float critical_cosine(Float eta) { return sqrt(max(Float(1.0f) - eta * eta, Float(0.0f))); }

// Where a cosine stands from 0 to 1 on the denser side: dense at 0, and on both sides of the critical angle, which is at CRITICAL_PLACE.
const float HALF_CRITICAL_PLACE = 0.4f;  // of half its cosine
const float CRITICAL_PLACE = 0.6f;
FN Float place_within(Float cosine, Float critical) {
    Float u = Float(2.0f) * clamp01(cosine / max(critical, Float(SMALLEST)));
    Float low = Float(HALF_CRITICAL_PLACE) * sqrt(u);
    Float high = Float(CRITICAL_PLACE) - Float(CRITICAL_PLACE - HALF_CRITICAL_PLACE) * sqrt(max(Float(2.0f) - u, Float(0.0f)));
    Float above = max(cosine - critical, Float(0.0f)) / max(Float(1.0f) - critical, Float(SMALLEST));
    above = Float(CRITICAL_PLACE) + Float(1.0f - CRITICAL_PLACE) * sqrt(above);
    return select(cosine < critical, select(u < Float(1.0f), low, high), above);
}

FN Float place_of_cosine(Float cosine, Float critical) {
    return select(critical > Float(0.0f), place_within(cosine, critical), sqrt(max(cosine, Float(0.0f))));
}

FN Float between(Float a, Float b, Float part) { return a + (b - a) * part; }

// Of a sheet, at a root of a cosine and a root of a roughness.
FN Float albedo_of_sheet(IN(WorldRecord) world, Int sheet, IN(TablePlace) rough, IN(TablePlace) cosine, Mask mask) {
    Int at = sheet * Int(ALBEDO_SHEET) + rough.entry * Int(ALBEDO_COSINES) + cosine.entry;
    Float low = between(gather_float(world.albedo, at, mask), gather_float(world.albedo, at + Int(1), mask), cosine.part);
    at = at + Int(ALBEDO_COSINES);
    Float high = between(gather_float(world.albedo, at, mask), gather_float(world.albedo, at + Int(1), mask), cosine.part);
    return between(low, high, rough.part);
}

FN Float mean_of_sheet(IN(WorldRecord) world, Int sheet, IN(TablePlace) rough, Mask mask) {
    Int at = Int(ALBEDO_MEANS) + sheet * Int(ALBEDO_ROUGHNESSES) + rough.entry;
    return between(gather_float(world.albedo, at, mask), gather_float(world.albedo, at + Int(1), mask), rough.part);
}

// Where a surface stands in a part of the table with several indices: between two sheets.
struct AlbedoPlace {
    Int sheet;
    Float part;
    TablePlace rough;
    Float critical;  // cosine
};

FN Int distribution_of(IN(Facets) f) { return select(f.beckmann, Int(1), Int(0)) + select(f.separate, Int(2), Int(0)); }

FN TablePlace index_place(Float eta) {
    Float ratio = abs(eta - Float(1.0f)) / (eta + Float(1.0f));
    return place_in_table(sqrt(ratio * Float(1.0f / ALBEDO_LARGEST_RATIO)), ALBEDO_INDICES);
}

FN AlbedoPlace coat_place(Float eta, Float roughness, IN(Facets) f) {
    TablePlace index = index_place(eta);
    AlbedoPlace place;
    place.sheet = Int(ALBEDO_COAT) + distribution_of(f) * Int(ALBEDO_INDICES) + index.entry;
    place.part = index.part;
    place.rough = place_in_table(sqrt(max(roughness, Float(0.0f))), ALBEDO_ROUGHNESSES);
    place.critical = Float(0.0f);
    return place;
}

FN AlbedoPlace border_place(Float eta, Float roughness, IN(Facets) f) {
    TablePlace index = index_place(eta);
    Int side = select(eta < Float(1.0f), Int(1), Int(0));
    AlbedoPlace place;
    place.sheet = Int(ALBEDO_BORDER) + (distribution_of(f) * Int(2) + side) * Int(ALBEDO_INDICES) + index.entry;
    place.part = index.part;
    place.rough = place_in_table(sqrt(max(roughness, Float(0.0f))), ALBEDO_ROUGHNESSES);
    place.critical = critical_cosine(eta);
    return place;
}

FN Float albedo_at(IN(WorldRecord) world, IN(AlbedoPlace) place, Float cosine, Mask mask) {
    TablePlace at = place_in_table(place_of_cosine(cosine, place.critical), ALBEDO_COSINES);
    Float low = albedo_of_sheet(world, place.sheet, place.rough, at, mask);
    Float high = albedo_of_sheet(world, place.sheet + Int(1), place.rough, at, mask);
    return between(low, high, place.part);
}

FN Float mean_albedo(IN(WorldRecord) world, IN(AlbedoPlace) place, Mask mask) {
    Float low = mean_of_sheet(world, place.sheet, place.rough, mask);
    Float high = mean_of_sheet(world, place.sheet + Int(1), place.rough, mask);
    return between(low, high, place.part);
}

FN Float mean_square_roughness(IN(Facets) f) { return Float(0.5f) * (f.x * f.x + f.y * f.y); }

// Facets that are stretched lose about as much as round ones do that are seen from where these hide one another as much; stretched.h knows the
// difference. `square`: of the round ones' roughness.
FN Float cosine_of_facets(IN(Facets) f, Float square, Vec3 w) {
    Float z_2 = w.z * w.z;
    Float tilt = (f.x * f.x * w.x * w.x + f.y * f.y * w.y * w.y) / max(square, Float(SMALLEST));
    return sqrt(z_2 / max(z_2 + tilt, Float(SMALLEST)));
}

FN Float cosine_of_round_facets(IN(Facets) f, Vec3 w) { return cosine_of_facets(f, mean_square_roughness(f), w); }

NAMESPACE_END

#endif
