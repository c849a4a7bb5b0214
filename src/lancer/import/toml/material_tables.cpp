// The keys of every kind of material. Defaults are those of scene/materials.h; a test holds them together.
#include <glm/vec3.hpp>

#include "lancer/import/toml/notation.h"

namespace lancer::notation {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Range any{};
constexpr Range not_negative{0.0, infinity};
constexpr Range share{0.0, 1.0};

const Default none{};
const glm::dvec3 origin{0.0};

// The keys of a material that follows physics: its type, its own, and those that all have.
Table physical(std::string_view type, std::string_view help, std::vector<Key> keys) {
    Table table{type, "a material", help, {{"type", Kind::choice, none, any, "", "The model of the surface.", true, {type}}}};
    table.keys.insert(table.keys.end(), keys.begin(), keys.end());
    table.keys.push_back({"emission", Kind::texture, origin, not_negative, "W/(m^2 sr)",
                          "The light that the surface gives by itself, weighed by the eye; the shape is a lamp then."});
    table.keys.push_back({"emission_strength", Kind::number, 1.0, not_negative, "", "Multiplies emission."});
    table.keys.push_back({"emission_sides", Kind::choice, "front", any, "", "Whether it shines outwards only.", false, {"front", "both"}});
    table.keys.push_back({"opacity", Kind::value, 1.0, share, "", "How much of it is there; light passes by the rest."});
    table.keys.push_back({"opacity_cutoff", Kind::number, 0.0, not_negative, "",
                          "Above 0: it is there where the opacity is at least this, and nowhere else."});
    table.keys.push_back({"behind", Kind::material, none, any, "", "The material that is seen from within, instead of this one."});
    table.keys.push_back({"one_sided", Kind::flag, false, any, "", "Black when seen from within."});
    table.keys.push_back({"open_behind", Kind::flag, false, any, "", "Not there when seen from within."});
    if (type != "mix") {
        table.keys.push_back({"normal_map", Kind::texture, glm::dvec3(0.5, 0.5, 1.0), share, "",
                              "Bends the normals: red along u, green along v, blue outwards, 0.5 standing for none."});
        table.keys.push_back({"normal_scale", Kind::number, 1.0, Range{-100.0, 100.0}, "", "Multiplies the red and green of normal_map."});
        table.keys.push_back({"normal_flip_green", Kind::flag, false, any, "", "The map's green grows downwards, as Direct3D has it."});
        table.keys.push_back({"normal_crosswise", Kind::flag, false, any, "",
                              "The map's green grows across normal and red, counter-clockwise, even where the picture is mirrored."});
        table.keys.push_back({"bump", Kind::value, 0.0, any, "m", "Heights that bend the normals as if the surface were raised by them."});
        table.keys.push_back(
            {"relief_shadows", Kind::flag, false, any, "", "Dims slanting light as if normal_map or bump hid it from itself."});
    }
    return table;
}

const Key interior{"interior", Kind::text, none, any, "", "The name of the [medium.NAME] that fills the body."};
const Key priority{
    "priority", Kind::integer,
    0.0,        Range{-1e6, 1e6},
    "",         "Where bodies overlap, the one of the highest priority fills the overlap; of equals the one that light entered last."};
const Key roughness{"roughness", Kind::value, 0.0, share, "", "From 0, polished, to 1; its square is the width of the facets' slopes."};
const Key facets{"facets", Kind::choice,       "ggx", any, "", "How the small mirrors of a rough surface are distributed.",
                 false,    {"ggx", "beckmann"}};
const Key facet_shadows{"facet_shadows",
                        Kind::choice,
                        "correlated",
                        any,
                        "",
                        "How they hide one another: as high ones are seen from everywhere, or towards either direction by itself.",
                        false,
                        {"correlated", "separate"}};
const Key facet_light{
    "facet_light", Kind::choice,    "kept", any, "", "What becomes of light that meets several of them; many programs lose it.",
    false,         {"kept", "lost"}};
const Key anisotropy{"anisotropy", Kind::value,
                     0.0,          Range{-100.0, 1.1},
                     "",           "How much smoother the surface is along u than along v, 0 to 1; below 0 it is rougher."};

}  // namespace

const Table& whitted_material() {
    static const Table table{
        "whitted",
        "a material",
        "The classic material of ray tracing. Its weights are shares from 0 to 1.",
        {{"type", Kind::choice, "whitted", any, "", "The model of the surface.", false, {"whitted"}},
         {"color", Kind::texture, glm::dvec3(0.8), share, "", "The colour of the surface."},
         {"ambient", Kind::number, 0.1, share, "", "How much of the scene's ambient light it gives back."},
         {"diffuse", Kind::number, 0.9, share, "", "How much of the lights' light it scatters."},
         {"highlight", Kind::number, 0.3, share, "", "How strong the highlights of the lights are."},
         {"shininess", Kind::number, 50.0, Range{0.0, 1e6, true, false}, "",
          "The exponent of the highlight: larger is smaller and sharper."},
         {"reflectivity", Kind::number, 0.0, share, "", "How much it mirrors."},
         {"transparency", Kind::number, 0.0, share, "", "How much passes into it; with reflectivity at most 1."},
         {"refraction", Kind::refraction, 1.5, Range{0.1, 10.0}, "",
          "The refractive index, the name of a glass, an index with its Abbe number, Sellmeier coefficients, or a curve."},
         {"absorption", Kind::color, origin, not_negative, "1/m", "How fast each colour fades inside: exp(-absorption * depth)."}}};
    return table;
}

const Table& diffuse_material() {
    static const Table table = physical("diffuse", "Scatters light to all sides alike, as chalk, plaster or paper.",
                                        {{"color", Kind::texture, glm::dvec3(0.8), share, "", "The share of light that it scatters."},
                                         {"roughness", Kind::value, 0.0, share, "", "Above 0: of small facets, as clay or the moon."}});
    return table;
}

const Table& conductor_material() {
    static const Table table =
        physical("conductor", "A metal, polished or rough.",
                 {{"metal", Kind::text, none, any, "", "Its name, such as \"gold\" or \"Cu\": measured indices are used."},
                  {"n", Kind::index, none, Range{0.0, 1000.0}, "", "The real part of its refractive index, with k; instead of metal."},
                  {"k", Kind::index, none, Range{0.0, 1000.0}, "", "The imaginary part."},
                  {"color", Kind::texture, glm::dvec3(1.0), share, "",
                   "The share of light that it mirrors when looked at straight on; of a metal with an index, a tint."},
                  roughness,
                  anisotropy,
                  facets,
                  facet_shadows,
                  facet_light});
    return table;
}

const Table& dielectric_material() {
    static const Table table = physical(
        "dielectric", "A clear body, such as glass, water or a diamond.",
        {{"refraction", Kind::refraction, 1.5, Range{0.1, 10.0}, "",
          "The refractive index, the name of a glass, an index with its Abbe number, Sellmeier coefficients, or a curve."},
         roughness,
         anisotropy,
         {"color", Kind::texture, glm::dvec3(1.0), share, "", "A tint of all light that it mirrors or lets through; white in nature."},
         {"absorption", Kind::color, origin, not_negative, "1/m", "How fast each colour fades inside: exp(-absorption * depth)."},
         {"thin", Kind::flag, false, any, "", "A pane without thickness: light passes straight through."},
         facets,
         facet_shadows,
         facet_light,
         interior,
         priority});
    return table;
}

const Table& plastic_material() {
    static const Table table =
        physical("plastic", "A coloured body under a clear coat, as plastic, varnished wood or glazed china.",
                 {{"color", Kind::texture, glm::dvec3(0.8), share, "", "The share of light that the body scatters."},
                  {"refraction", Kind::number, 1.5, Range{1.0, 3.0}, "", "The refractive index of the coat."},
                  roughness,
                  {"saturates", Kind::flag, true, any, "", "Light that the coat sends back into the body takes its colour once more."},
                  facets,
                  facet_shadows,
                  facet_light});
    return table;
}

const Table& principled_material() {
    static const Table table = physical(
        "principled", "A layered surface for nearly everything: sheen over a coat over a base of metal, coloured body or clear body.",
        {{"color", Kind::texture, glm::dvec3(0.8), share, "", "The colour of the base."},
         {"metalness", Kind::value, 0.0, share, "", "From 0, none, to 1, a metal."},
         {"roughness", Kind::value, 0.3, share, "", "From 0, polished, to 1; its square is the width of the facets' slopes."},
         anisotropy,
         {"refraction", Kind::number, 1.5, Range{1.0, 1000.0}, "", "The refractive index of the base where it is no metal."},
         {"specular", Kind::texture, glm::dvec3(1.0), share, "", "A tint of what the border of the base reflects; white in nature."},
         {"transmission", Kind::value, 0.0, share, "", "How much of the base is a clear body."},
         {"thin", Kind::flag, false, any, "", "A sheet without inside: what passes through is not bent."},
         {"absorption", Kind::color, origin, not_negative, "1/m", "How fast each colour fades inside: exp(-absorption * depth)."},
         {"coat", Kind::value, 0.0, share, "", "How much of the surface a clear coat covers."},
         {"coat_roughness", Kind::value, 0.0, share, "", "Of the coat."},
         {"sheen", Kind::texture, origin, share, "", "Light from fine fibres, as of velvet."},
         {"sheen_roughness", Kind::value, 0.3, share, "", "Of the fibres."},
         {"film", Kind::value, 0.0, Range{0.0, 10000.0}, "nm", "The thickness of a film that shimmers in colours; 0 for none."},
         {"film_refraction", Kind::number, 1.3, Range{1.0, 10.0}, "", "The refractive index of the film."},
         {"dispersion", Kind::number, 0.0, Range{0.0, 10.0}, "",
          "How far the clear body parts the colours: 20 over its Abbe number, as in glTF."},
         {"coat_smooth", Kind::flag, false, any, "", "The coat is as smooth as the shape, whatever bends the normals of what it covers."},
         {"coat_normal_map", Kind::texture, glm::dvec3(0.5, 0.5, 1.0), share, "", "Bends the coat's normals, instead of normal_map."},
         {"coat_normal_scale", Kind::number, 1.0, Range{-100.0, 100.0}, "", "Multiplies the red and green of coat_normal_map."},
         {"turn", Kind::number, 0.0, Range{-360.0, 360.0}, "degrees",
          "With anisotropy: from u, anticlockwise, to the way in which it is smooth."},
         {"smooth_along", Kind::texture, glm::dvec3(1.0, 0.5, 0.0), share, "",
          "With anisotropy: red along u and green along v, 0.5 standing for none, are that way before it is turned."},
         interior,
         priority});
    return table;
}

const Table& burley_material() {
    static const Table table = physical(
        "burley", "Burley's surface, as films and games know it: for scenes of other programs. Its layers do not share the light out.",
        {{"color", Kind::texture, glm::dvec3(0.5), share, "", "The colour of the base."},
         {"roughness", Kind::value, 0.5, share, "", "From 0, polished, to 1; its square is the width of the facets' slopes."},
         {"anisotropy", Kind::value, 0.0, Range{0.0, 1.0}, "", "How much rougher the surface is along u than along v."},
         {"refraction", Kind::number, 1.5, Range{1.0, 3.0}, "", "The refractive index of the base where it is no metal."},
         {"specular_tint", Kind::number, 0.0, share, "", "How much of the base's colour it takes that the surface reflects."},
         {"metalness", Kind::value, 0.0, share, "", "From 0, none, to 1, a metal."},
         {"transmission", Kind::value, 0.0, share, "", "How much of the base is a clear body, or of a sheet clear."},
         {"flatness", Kind::number, 0.0, share, "", "How flat the diffuse body looks, as if light went about in it."},
         {"sheen", Kind::value, 0.0, share, "", "Light along the edges, as of cloth."},
         {"sheen_tint", Kind::number, 0.0, share, "", "How much of the base's colour it takes."},
         {"coat", Kind::value, 0.0, share, "", "How much of the surface a clear coat covers."},
         {"coat_gloss", Kind::number, 0.0, share, "", "From 0, blurred, to 1, sharp."},
         {"thin", Kind::flag, false, any, "", "A sheet without inside: no metal, no coat; what passes through is not bent."},
         {"passes", Kind::value, 0.0, share, "", "Of a sheet: the share of its diffuse light that goes through."}});
    return table;
}

const Table& mix_material() {
    static const Table table = physical("mix", "Two materials, one here and the other there, or both together.",
                                        {{"first", Kind::material, none, any, "", "A material, which may be a mix itself.", true},
                                         {"second", Kind::material, none, any, "", "The other one.", true},
                                         {"share", Kind::value, 0.5, share, "", "How much of the second there is."},
                                         interior,
                                         priority});
    return table;
}

const Table& null_material() {
    static const Table table{"null",
                             "a material",
                             "A border that is not seen, which closes in a medium: a cloud, a pillar of smoke.",
                             {{"type", Kind::choice, none, any, "", "The model of the surface.", true, {"null"}}, interior, priority}};
    return table;
}

}  // namespace lancer::notation
