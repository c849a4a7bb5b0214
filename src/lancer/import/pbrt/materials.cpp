#include "lancer/import/pbrt/materials.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "lancer/import/pbrt/named_spectra.h"
#include "lancer/import/pbrt/words.h"
#include "lancer/spectrum/metal.h"
#include "lancer/spectrum/sensor.h"

namespace lancer::pbrt {

namespace {

class Builder {
public:
    Builder(const Recipe& recipe, const Textures& textures, bool version3)
        : recipe_(recipe), parameters_(recipe.parameters), textures_(textures), version3_(version3) {}

    scene::Material build() {
        scene::Material material{{}, scene::DiffuseMaterial{scene::Rgb(0.5), 0.0}, parameters_.position()};
        const std::string& type = recipe_.type;
        if (type == "diffuse") {
            material.model = scene::DiffuseMaterial{textures_.color(recipe_, "reflectance", scene::Rgb(0.5)), 0.0};
            honoured();
        } else if (type == "coateddiffuse") {
            material.model = coated_diffuse();
        } else if (type == "conductor") {
            material.model = conductor("", textures_);
            honoured();
        } else if (type == "dielectric" || type == "thindielectric") {
            material.model = dielectric(type == "thindielectric");
            honoured();
        } else if (type == "interface" || type == "" || type == "none") {
            material.model = nothing();
        } else {
            parameters_.context().report.dropped(parameters_.owner(), "a grey diffuse material stands for it", parameters_.position());
        }
        parameters_.pass_over({"type"});
        return material;
    }

private:
    void honoured() { parameters_.context().report.honoured(parameters_.owner(), parameters_.position()); }

    // The root of alpha, which our materials call roughness.
    double roughness(std::string_view name, std::string_view along, double otherwise) {
        const double both = textures_.number(recipe_, name, otherwise);
        const double value = std::max(textures_.number(recipe_, along, both), 0.0);
        return remapped() ? std::pow(value, 0.25) : std::sqrt(value);
    }

    bool remapped() { return parameters_.boolean("remaproughness", true); }

    struct Facets {
        double roughness = 0.0;
        double anisotropy = 0.0;
    };

    // alpha = r^2 aspect along u and r^2 / aspect along v.
    Facets facets(const std::string& prefix, double otherwise) {
        const double u = std::min(roughness(prefix + "roughness", prefix + "uroughness", otherwise), 1.0);
        const double v = std::min(roughness(prefix + "roughness", prefix + "vroughness", otherwise), 1.0);
        Facets result{std::sqrt(u * v), 0.0};
        if (u != v) {
            const double ratio = std::clamp(u * u / std::max(v * v, 1e-12), 0.1, 1.0);
            result.anisotropy = (1.0 - ratio) / 0.9;
            if (ratio != u * u / (v * v)) {
                parameters_.context().report.approximated(parameters_.owner() + ", roughness along v below that along u",
                                                          "the same in all directions", parameters_.position());
            }
        }
        return result;
    }

    scene::ConductorMaterial conductor(const std::string& prefix, const Textures& textures) {
        scene::ConductorMaterial metal;
        metal.facets.once = true;
        const Facets f = facets(prefix, 0.0);
        metal.roughness = f.roughness;
        metal.anisotropy = f.anisotropy;
        if (parameters_.has("reflectance")) {
            metal.color = textures.color(recipe_, "reflectance", scene::Rgb(0.5));
            return metal;
        }
        const Parameter* eta = parameters_.find(prefix.empty() ? "eta" : "conductor.eta");
        const Parameter* k = parameters_.find(prefix.empty() ? "k" : "conductor.k");
        if (eta == nullptr && k == nullptr) {
            metal.metal = "Cu";
            return metal;
        }
        const Metal copper = find_metal("Cu").value();
        const auto index_of = [&](const Parameter* parameter, const SpectralCurve& otherwise) -> scene::Index {
            const auto read = parameter != nullptr ? read_index(parameters_, *parameter, recipe_.space) : std::nullopt;
            return read ? *read : scene::MeasuredSpectrum{otherwise.nanometres(), otherwise.values()};
        };
        metal.n = index_of(eta, copper.n);
        metal.k = index_of(k, copper.k);
        return metal;
    }

    // The index of refraction, as a number or as a glass by name.
    scene::Refraction refraction(double otherwise) {
        const Parameter* eta = parameters_.find("eta");
        if (eta == nullptr) {
            return otherwise;
        }
        if (eta->type == "float" || eta->type == "texture") {
            return textures_.number(recipe_, "eta", otherwise);
        }
        if (eta->values.find('"') != std::string_view::npos) {
            const std::vector<std::string> names = parameters_.strings_of(*eta);
            const std::string glass = names.size() == 1 ? glass_of(names[0]) : std::string();
            if (!glass.empty()) {
                return scene::NamedGlass{glass};
            }
        }
        const auto curve = read_curve(parameters_, *eta, recipe_.space);
        return curve ? curve->at(589.3) : otherwise;
    }

    scene::DielectricMaterial dielectric(bool thin) {
        scene::DielectricMaterial glass;
        glass.refraction = refraction(1.5);
        glass.thin = thin;
        if (!thin) {
            glass.facets.once = true;
            const Facets f = facets("", 0.0);
            glass.roughness = f.roughness;
            glass.anisotropy = f.anisotropy;
        }
        return glass;
    }

    scene::PlasticMaterial coated_diffuse() {
        scene::PlasticMaterial plastic;
        plastic.color = textures_.color(recipe_, "reflectance", scene::Rgb(0.5));
        plastic.refraction = textures_.number(recipe_, "eta", 1.5);
        plastic.roughness = facets("", 0.0).roughness;
        parameters_.pass_over({"thickness", "maxdepth", "nsamples", "g", "albedo"});
        honoured();
        return plastic;
    }

    // A border that light passes as if it were not there.
    scene::DielectricMaterial nothing() {
        scene::DielectricMaterial glass;
        glass.refraction = 1.0;
        glass.thin = true;
        honoured();
        return glass;
    }

    const Recipe& recipe_;
    const Parameters& parameters_;
    const Textures& textures_;
    [[maybe_unused]] bool version3_;
};

}  // namespace

scene::Material build_material(const Recipe& recipe, const Textures& textures, bool version3) {
    return Builder(recipe, textures, version3).build();
}

}  // namespace lancer::pbrt
