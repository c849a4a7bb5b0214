// What surfaces are made of, as the author of a scene wrote it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/color.h"
#include "lancer/scene/textures.h"

namespace lancer::scene {

// ---- Refraction -----------------------------------------------------------------------------------------------------------------

// n = refractive index at the d line (587.56 nm), V = Abbe number.
struct AbbeGlass {
    double index = 1.5;
    double abbe_number = 60.0;
};

// n^2 = 1 + sum B_i L^2 / (L^2 - C_i), L in micrometres, C_i in square micrometres [Sellmeier 1871].
struct SellmeierGlass {
    glm::dvec3 b{0.0};
    glm::dvec3 c{0.0};
};

struct NamedGlass {
    std::string name;  // a name that spectrum/glass.h knows
};

// A plain number is the same index at every wavelength.
using Refraction = std::variant<double, AbbeGlass, SellmeierGlass, NamedGlass, MeasuredSpectrum>;

// ---- Materials ------------------------------------------------------------------------------------------------------------------

// The report's material, with transparency added [Whitted 1980]. All weights are shares in [0, 1].
struct WhittedMaterial {
    Texture color = Color(Rgb(0.8));
    double ambient = 0.1;
    double diffuse = 0.9;
    double highlight = 0.3;
    double shininess = 50.0;  // exponent of the highlight
    double reflectivity = 0.0;
    double transparency = 0.0;
    Refraction refraction = 1.5;
    Color absorption = Color();  // inside a transparent body, per metre
};

// The rest follow physics: they are for the path integrator. Roughness runs from 0, smooth, to 1; its square is the width of the facets' slopes.

// The small mirrors that rough surfaces are made of. As other programs have them they may lose light.
struct Facets {
    enum class Distribution { ggx, beckmann };
    Distribution distribution = Distribution::ggx;
    bool separate = false;  // they hide one another towards either direction by itself, else by how high each lies
    bool once = false;      // light that meets several of them is lost, else it is given back

    bool operator==(const Facets&) const = default;
};

// Scatters to all sides alike [Lambert 1760], or as small facets of that kind do.
struct DiffuseMaterial {
    Texture color = Color(Rgb(0.8));
    Value roughness = 0.0;
};

// Part of a complex index of refraction: measured, or one number for each of red, green and blue.
using Index = std::variant<MeasuredSpectrum, Rgb>;

// A metal, by name, by its complex index n + i k, or by its colour when seen straight on.
struct ConductorMaterial {
    std::string metal;                // a name that spectrum/metal.h knows; empty: n and k, or `color` alone
    Texture color = Color(Rgb(1.0));  // of a metal with an index, a tint: white in nature
    Value roughness = 0.0;
    Value anisotropy = 0.0;                 // how much smoother along u than along v, 0 to 1
    std::optional<Index> n = std::nullopt;  // both or none
    std::optional<Index> k = std::nullopt;
    Facets facets = {};
};

// A clear body, such as glass or water; or a pane of it, so thin that nothing is seen to be shifted.
struct DielectricMaterial {
    Refraction refraction = 1.5;
    Texture color = Color(Rgb(1.0));  // a tint for whatever it reflects or lets through; white in nature
    Value roughness = 0.0;
    Value anisotropy = 0.0;
    Color absorption = Color();  // inside, per metre
    bool thin = false;
    Facets facets = {};
};

// A coloured body under a clear coat.
struct PlasticMaterial {
    Texture color = Color(Rgb(0.8));
    double refraction = 1.5;  // of the coat
    Value roughness = 0.0;
    bool saturates = true;  // light that the coat sends back takes the body's colour again
    Facets facets = {};
};

// Normals of a coat, where they differ from those of what it covers: the shape's own, or those of a map as in Relief.
struct CoatRelief {
    std::optional<Texture> normals = std::nullopt;
    double scale = 1.0;  // of x and y
};

// Layers: sheen over a clear coat over a base of metal, coloured body or clear body. After glTF's metallic-roughness and its extensions.
struct PrincipledMaterial {
    Texture color = Color(Rgb(0.8));
    Value metalness = 0.0;
    Value roughness = 0.3;
    Value anisotropy = 0.0;
    double refraction = 1.5;
    Texture specular = Color(Rgb(1.0));  // tint of what the base reflects
    Value transmission = 0.0;
    bool thin = false;
    Color absorption = Color();
    Value coat = 0.0;
    Value coat_roughness = 0.0;
    Texture sheen = Color();
    Value sheen_roughness = 0.3;
    Value film = 0.0;  // thickness in nanometres of a thin film; 0: none
    double film_refraction = 1.3;
    double dispersion = 0.0;  // of the clear body: 20 / Abbe number, as glTF has it
    std::optional<CoatRelief> coat_relief = std::nullopt;
    double turn = 0.0;  // degrees, anticlockwise from u, to where it is smooth, as `anisotropy` has it
    std::optional<Texture> smooth_along =
        std::nullopt;  // red and green from 0 to 1: the same by a texture: the way along u and v that is turned
};

// Burley's surface, after what was published of it: scenes of other programs are made for it. It is bright where PrincipledMaterial is true.
struct BurleyMaterial {
    Texture color = Color(Rgb(0.5));
    Value roughness = 0.5;
    Value anisotropy = 0.0;      // how much rougher along u than along v, 0 to 1
    double refraction = 1.5;     // of what is no metal
    double specular_tint = 0.0;  // how much of the colour it takes that the surface reflects, 0 to 1
    Value metalness = 0.0;
    Value transmission = 0.0;
    double flatness = 0.0;  // of the diffuse body, 0 to 1
    Value sheen = 0.0;
    double sheen_tint = 0.0;
    Value coat = 0.0;
    double coat_gloss = 0.0;  // from 0, blurred, to 1
    bool thin = false;        // a sheet: no metal, no coat
    Value passes = 0.0;       // of a sheet: the share of the diffuse light that goes through, 0 to 1
};

// A border with nothing to be seen of it, between one medium and another of the same refractive index, such as that of a cloud.
struct NullMaterial {};

// Light that a surface gives by itself.
struct Emission {
    Texture radiance = Color();  // W/(m^2 sr), weighed by the eye: 1 is as bright as a white surface under an irradiance of pi
    double strength = 1.0;       // times this
    bool both_sides = false;     // else outwards only
};

// Two materials, one here and the other there: indices into Scene::materials. They may be mixes themselves; no mix may contain itself.
struct MixMaterial {
    int first = 0;
    int second = 0;
    Value share = 0.5;  // of the second
};

// Where a surface's normals differ from those of its shape.
struct Relief {
    std::optional<Texture> normals = std::nullopt;  // red, green, blue from 0 to 1 are x, y, z from -1 to 1: along u, along v, outwards
    double scale = 1.0;                             // of x and y
    bool flips_green = false;                       // y grows downwards
    std::optional<Value> heights = std::nullopt;    // metres outwards, of which only the slopes are seen
    bool crosswise = false;                         // y lies along the cross product of the normal and x, wherever v grows
    bool shadows = false;                           // light that comes slantwise is dimmed as if the relief hid it from itself
};

struct Material {
    std::string name;  // empty when written in place
    std::variant<WhittedMaterial, DiffuseMaterial, ConductorMaterial, DielectricMaterial, PlasticMaterial, PrincipledMaterial,
                 BurleyMaterial, MixMaterial, NullMaterial>
        model;
    SourcePosition position;
    std::optional<Emission> emission = std::nullopt;
    bool is_default = false;  // for shapes without one: as it is, or diffuse where light follows physics
    Relief relief = {};
    Value opacity = 1.0;               // how much of it is there; light passes by the rest as if there were nothing
    double opacity_cutoff = 0.0;       // above 0: it is there where the opacity is at least this, and nowhere else
    std::optional<int> behind = {};    // what is seen from within instead: index into Scene::materials
    bool one_sided = false;            // black when seen from within
    bool open_behind = false;          // not there when seen from within
    std::optional<int> interior = {};  // what fills a clear body or what a null border closes in: index into Scene::media
    int priority = 0;                  // of bodies that overlap the one of the highest fills the overlap; of equals the one entered last
};

inline bool is_physical(const Material& material) {
    return !std::holds_alternative<WhittedMaterial>(material.model) || material.emission.has_value();
}

}  // namespace lancer::scene
