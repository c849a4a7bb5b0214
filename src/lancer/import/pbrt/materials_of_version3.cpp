// The materials of pbrt-v3 that version 4 has no more.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/import/pbrt/conductors.h"
#include "lancer/import/pbrt/facets.h"
#include "lancer/import/pbrt/materials.h"
#include "lancer/import/pbrt/spectra.h"

namespace lancer::pbrt {

namespace {

class Builder {
public:
    Builder(const Recipe& recipe, const Textures& textures, const FindMaterial& find)
        : recipe_(recipe), parameters_(recipe.parameters), textures_(textures), find_(find),
          material_(grey_material(parameters_.position())) {}

    scene::Material build() {
        const std::string& type = recipe_.type;
        if (type == "matte") {
            const scene::Value sigma =
                textures_.value(recipe_, "sigma", 0.0, [](double degrees) { return std::clamp(degrees / 90.0, 0.0, 1.0); });
            material_.model = scene::DiffuseMaterial{color("Kd", 0.5), sigma};
            honoured();
        } else if (type == "plastic") {
            set_plastic();
        } else if (type == "metal") {
            material_.model = read_conductor(recipe_, textures_, "", 0.01, true);
            honoured();
        } else if (type == "glass") {
            set_glass();
        } else if (type == "mirror") {
            scene::ConductorMaterial mirror;
            mirror.color = color("Kr", 0.9);
            material_.model = mirror;
            honoured();
        } else if (type == "uber") {
            set_uber();
        } else if (type == "substrate") {
            set_substrate();
        } else if (type == "translucent") {
            material_.model = scene::DiffuseMaterial{color("Kd", 0.25), 0.0};
            parameters_.pass_over({"Ks", "reflect", "transmit", "roughness", "remaproughness"});
            approximated("a diffuse surface that lets nothing through");
        } else if (type == "disney") {
            set_disney();
        } else if (type == "mix") {
            set_mix();
        } else if (type == "kdsubsurface") {
            scene::PlasticMaterial plastic;
            plastic.color = color("Kd", 0.5);
            plastic.refraction = std::max(parameters_.number("eta", 1.33), 1.0);
            parameters_.pass_over({"mfp", "Kr", "Kt", "uroughness", "vroughness", "remaproughness"});
            material_.model = plastic;
            approximated("a coated diffuse surface");
        } else if (type == "fourier") {
            parameters_.pass_over({"bsdffile"});
            approximated("a grey diffuse surface");
        } else {
            return build_material(recipe_, textures_, find_);
        }
        return material_;
    }

private:
    void honoured() { parameters_.context().report.honoured(parameters_.owner(), parameters_.position()); }
    void approximated(std::string how) {
        parameters_.context().report.approximated(parameters_.owner(), std::move(how), parameters_.position());
    }

    scene::Texture color(std::string_view name, double otherwise) { return textures_.color(recipe_, name, scene::Rgb(otherwise)); }

    scene::Value roughness(double otherwise) { return read_facets(recipe_, textures_, "", otherwise, true).roughness; }

    // A body of colour Kd, whose surface reflects Ks of what a clear one of that index would.
    scene::PrincipledMaterial body(double kd, double ks, double rough, double index) {
        scene::PrincipledMaterial result;
        result.color = color("Kd", kd);
        result.specular = color("Ks", ks);
        result.roughness = roughness(rough);
        result.refraction = std::max(parameters_.number(parameters_.has("eta") ? "eta" : "index", index), 1.0);
        return result;
    }

    void set_plastic() {
        material_.model = body(0.25, 0.25, 0.1, 1.5);
        approximated("a layered surface");
    }

    void set_glass() {
        scene::DielectricMaterial glass;
        glass.refraction = std::max(parameters_.number(parameters_.has("eta") ? "eta" : "index", 1.5), 1e-3);
        const FacetValues facets = read_facets(recipe_, textures_, "", 0.0, true);
        glass.facets.once = true;
        glass.roughness = facets.roughness;
        glass.anisotropy = facets.anisotropy;
        glass.color = color("Kt", 1.0);
        const bool tinted = parameters_.has("Kt") || parameters_.has("Kr");
        material_.model = glass;
        tinted ? approximated("glass whose tint Kt is that of what it reflects, too") : honoured();
    }

    void set_uber() {
        scene::PrincipledMaterial layered = body(0.25, 0.25, 0.1, 1.5);
        if (parameters_.has("Kt")) {
            layered.transmission = textures_.value(recipe_, "Kt", 0.0);
        }
        material_.opacity = textures_.value(recipe_, "opacity", 1.0);
        parameters_.pass_over({"Kr"});
        material_.model = layered;
        approximated("a layered surface");
    }

    // Ks is what it reflects head-on [Ashikhmin and Shirley 2000].
    void set_substrate() {
        scene::PrincipledMaterial layered = body(0.5, 0.5, 0.1, 1.5);
        if (const auto* head_on = std::get_if<Color>(&std::as_const(layered.specular))) {
            const scene::Rgb rgb = visible(*head_on);
            const double most = std::clamp(std::max({rgb.x, rgb.y, rgb.z}), 1e-4, 0.9);
            layered.specular = scene::Rgb(glm::clamp(rgb / most, 0.0, 1.0));
            layered.refraction = (1.0 + std::sqrt(most)) / (1.0 - std::sqrt(most));
        }
        material_.model = layered;
        approximated("a layered surface");
    }

    void set_disney() {
        scene::PrincipledMaterial layered;
        layered.color = color("color", 0.5);
        layered.metalness = textures_.value(recipe_, "metallic", 0.0);
        layered.roughness = textures_.value(recipe_, "roughness", 0.5);
        layered.anisotropy = textures_.value(recipe_, "anisotropic", 0.0);
        layered.refraction = std::max(textures_.number(recipe_, "eta", 1.5), 1.0);
        layered.transmission = textures_.value(recipe_, "spectrans", 0.0);
        layered.thin = parameters_.boolean("thin", false);
        layered.coat = textures_.value(recipe_, "clearcoat", 0.0);
        layered.coat_roughness = textures_.value(recipe_, "clearcoatgloss", 1.0, [](double gloss) { return 0.3 * (1.0 - gloss); });
        const scene::Value sheen = textures_.value(recipe_, "sheen", 0.0);
        layered.sheen = scene::Rgb(sheen.number);
        parameters_.pass_over({"speculartint", "sheentint", "scatterdistance", "difftrans", "flatness"});
        material_.model = layered;
        approximated("a layered surface");
    }

    void set_mix() {
        const auto one = parameters_.string("namedmaterial1"), other = parameters_.string("namedmaterial2");
        if (!one || !other) {
            parameters_.context().diagnostics.error(parameters_.position(),
                                                    parameters_.owner() + " needs \"string namedmaterial1\" and \"string namedmaterial2\"");
            return;
        }
        scene::MixMaterial mix;
        mix.first = find_(*one, recipe_);
        mix.second = find_(*other, recipe_);
        mix.share = textures_.value(recipe_, "amount", 0.5, [](double share) { return std::clamp(1.0 - share, 0.0, 1.0); });
        material_.model = mix;
        honoured();
    }

    const Recipe& recipe_;
    const Parameters& parameters_;
    const Textures& textures_;
    const FindMaterial& find_;
    scene::Material material_;
};

}  // namespace

scene::Material build_old_material(const Recipe& recipe, const Textures& textures, const FindMaterial& find) {
    return Builder(recipe, textures, find).build();
}

}  // namespace lancer::pbrt
