#include "lancer/import/pbrt/materials.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include "lancer/import/pbrt/conductors.h"
#include "lancer/import/pbrt/facets.h"
#include "lancer/import/pbrt/files.h"
#include "lancer/import/pbrt/named_spectra.h"
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
        if (type == "diffuse") {
            material_.model = scene::DiffuseMaterial{color("reflectance", 0.5), 0.0};
            honoured();
        } else if (type == "coateddiffuse") {
            set_coated_diffuse();
        } else if (type == "conductor") {
            material_.model = read_conductor(recipe_, textures_, "", 0.0, false);
            honoured();
        } else if (type == "coatedconductor") {
            set_coated_conductor();
        } else if (type == "dielectric" || type == "thindielectric") {
            set_dielectric(type == "thindielectric");
        } else if (type == "diffusetransmission") {
            material_.model = scene::DiffuseMaterial{color("reflectance", 0.25), 0.0};
            parameters_.pass_over({"transmittance", "scale"});
            approximated("a diffuse surface that lets nothing through");
        } else if (type == "subsurface") {
            set_subsurface();
        } else if (type == "hair") {
            set_hair();
        } else if (type == "mix") {
            set_mix();
        } else if (type == "interface" || type.empty() || type == "none") {
            material_.opacity = 0.0;  // light passes by as if it were not there
            honoured();
        } else if (type == "measured") {
            parameters_.pass_over({"filename"});
            approximated("a grey diffuse surface");
        } else {
            parameters_.context().report.dropped(parameters_.owner(), "a grey diffuse material stands for it", parameters_.position());
        }
        return material_;
    }

private:
    void honoured() { parameters_.context().report.honoured(parameters_.owner(), parameters_.position()); }
    void approximated(std::string how) {
        parameters_.context().report.approximated(parameters_.owner(), std::move(how), parameters_.position());
    }

    scene::Texture color(std::string_view name, double otherwise) { return textures_.color(recipe_, name, scene::Rgb(otherwise)); }

    // The index of refraction: a number, a glass by name, or measured.
    scene::Refraction refraction(double otherwise) {
        const Parameter* eta = parameters_.find("eta");
        if (eta == nullptr) {
            return otherwise;
        }
        if (eta->type == "float" || eta->type == "texture") {
            return std::max(textures_.number(recipe_, "eta", otherwise), 1e-3);
        }
        if (eta->values.find('"') != std::string_view::npos) {
            const std::vector<std::string> names = parameters_.strings_of(*eta);
            const std::string glass = names.size() == 1 ? glass_of(names[0]) : std::string();
            if (!glass.empty()) {
                return scene::NamedGlass{glass};
            }
        }
        const auto curve = read_curve(parameters_, *eta, recipe_.space);
        if (!curve || !(curve->lowest() > 0.0)) {
            return otherwise;
        }
        return curve->at(587.56);
    }

    void set_dielectric(bool thin) {
        scene::DielectricMaterial glass;
        glass.refraction = refraction(1.5);
        glass.thin = thin;
        if (!thin) {
            const FacetValues facets = read_facets(recipe_, textures_, "", 0.0, false);
            glass.facets.once = true;
            glass.roughness = facets.roughness;
            glass.anisotropy = facets.anisotropy;
        }
        material_.model = glass;
        honoured();
    }

    // pbrt follows light between coat and body step by step; ours has the sum of all steps.
    void set_coated_diffuse() {
        scene::PlasticMaterial plastic;
        plastic.color = color("reflectance", 0.5);
        plastic.refraction = std::max(textures_.number(recipe_, "eta", 1.5), 1.0);
        plastic.roughness = read_facets(recipe_, textures_, "", 0.0, false).roughness;
        if (const Parameter* albedo = parameters_.find("albedo")) {
            parameters_.context().report.dropped("\"albedo\" of coateddiffuse", "nothing scatters within the coat",
                                                 Parameters::position_of(*albedo));
        }
        parameters_.pass_over({"thickness", "maxdepth", "nsamples", "g", "uroughness", "vroughness"});
        material_.model = plastic;
        honoured();
    }

    void set_coated_conductor() {
        scene::PrincipledMaterial coated;
        const scene::ConductorMaterial metal = read_conductor(recipe_, textures_, "conductor.", 0.0, false);
        coated.color = head_on_color(metal);
        coated.metalness = 1.0;
        coated.roughness = metal.roughness;
        coated.coat = 1.0;
        coated.coat_roughness = read_facets(recipe_, textures_, "interface.", 0.0, false).roughness;
        parameters_.pass_over({"thickness", "interface.eta", "maxdepth", "nsamples", "g", "albedo"});
        material_.model = coated;
        approximated("a metal of the colour that it has head-on, under a clear coat");
    }

    // What comes back from a thick body of that medium, roughly [van de Hulst 1980].
    void set_subsurface() {
        scene::PlasticMaterial plastic;
        scene::Texture body = scene::Rgb(0.7);
        const Parameter* swallows = parameters_.find("sigma_a");
        const Parameter* scatters = parameters_.find("sigma_s");
        if (parameters_.has("reflectance")) {
            body = color("reflectance", 0.5);
        } else if (swallows != nullptr && scatters != nullptr && swallows->type == "rgb" && scatters->type == "rgb") {
            const std::vector<double> a = parameters_.numbers_of(*swallows), s = parameters_.numbers_of(*scatters);
            if (a.size() == 3 && s.size() == 3) {
                const glm::dvec3 swallowed(a[0], a[1], a[2]), scattered(s[0], s[1], s[2]);
                const glm::dvec3 gamma = glm::sqrt(glm::clamp(swallowed / glm::max(swallowed + scattered, 1e-12), 0.0, 1.0));
                body = scene::Rgb((1.0 - gamma) / (1.0 + 2.0 * gamma));
            }
        }
        plastic.color = body;
        plastic.refraction = std::max(textures_.number(recipe_, "eta", 1.33), 1.0);
        plastic.roughness = read_facets(recipe_, textures_, "", 0.0, false).roughness;
        parameters_.pass_over({"name", "mfp", "g", "scale", "uroughness", "vroughness"});
        material_.model = plastic;
        approximated("a coated diffuse surface");
    }

    void set_hair() {
        scene::Texture strand = scene::Rgb(0.5);
        if (parameters_.has("reflectance") || parameters_.has("color")) {
            strand = color(parameters_.has("reflectance") ? "reflectance" : "color", 0.5);
        } else {
            const double dark = parameters_.number("eumelanin", parameters_.has("pheomelanin") ? 0.0 : 1.3);
            const glm::dvec3 swallowed =
                dark * glm::dvec3(0.419, 0.697, 1.37) + parameters_.number("pheomelanin", 0.0) * glm::dvec3(0.187, 0.4, 1.05);
            strand = scene::Rgb(glm::exp(-glm::sqrt(glm::max(swallowed, 0.0)) * 5.5));
        }
        parameters_.pass_over({"sigma_a", "eta", "beta_m", "beta_n", "alpha"});
        material_.model = scene::DiffuseMaterial{strand, 0.0};
        approximated("a diffuse surface of the hair's colour");
    }

    void set_mix() {
        const std::vector<std::string> names = parameters_.strings("materials");
        if (names.size() != 2) {
            parameters_.context().diagnostics.error(parameters_.position(), parameters_.owner() + " needs two names: \"string materials\"");
            return;
        }
        scene::MixMaterial mix;
        mix.first = find_(names[0], recipe_);
        mix.second = find_(names[1], recipe_);
        mix.share = textures_.value(recipe_, "amount", 0.5, [](double share) { return std::clamp(share, 0.0, 1.0); });
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

scene::Material grey_material(const SourcePosition& position) {
    scene::Material material;
    material.model = scene::DiffuseMaterial{scene::Rgb(0.5), 0.0};
    material.position = position;
    return material;
}

scene::Material build_material(const Recipe& recipe, const Textures& textures, const FindMaterial& find) {
    return Builder(recipe, textures, find).build();
}

void add_relief(const Recipe& recipe, const Textures& textures, scene::Material& material) {
    const Parameters& parameters = recipe.parameters;
    ImportContext& context = parameters.context();
    if (const Parameter* parameter = parameters.find("normalmap")) {
        if (const auto name = parameters.string("normalmap")) {
            scene::ImageTexture map;
            map.position = Parameters::position_of(*parameter);
            map.file = find_file(context, *name, *parameter->text);
            map.linear = true;
            context.files.image(map.file, map.position);
            material.relief.normals = map;
            context.report.honoured("\"normalmap\"", map.position);
        }
    }
    for (const std::string_view name : {"displacement", "bumpmap"}) {
        if (const Parameter* parameter = parameters.find(name)) {
            material.relief.heights = textures.value(recipe, name, 0.0);
            context.report.honoured(fmt::format("\"{}\", as a bump map", name), Parameters::position_of(*parameter));
        }
    }
}

}  // namespace lancer::pbrt
