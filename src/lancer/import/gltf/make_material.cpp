// One material, property by property [Khronos 2021, section 3.9 and the extensions' own pages].
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include "lancer/import/gltf/materials.h"

namespace lancer::gltf {

namespace {

double share(Json json, std::string_view key, double otherwise) { return std::clamp(json.number(key, otherwise), 0.0, 1.0); }

scene::Rgb color_or(Json json, std::string_view key, const scene::Rgb& otherwise) {
    const std::vector<double> v = json.numbers(key);
    return v.size() >= 3 ? glm::max(scene::Rgb(v[0], v[1], v[2]), 0.0) : otherwise;
}

class MaterialMaker {
public:
    MaterialMaker(Document& document, Textures& textures, Json json, bool has_colors, Wishes& wishes, std::vector<scene::Material>& all)
        : document_(document), textures_(textures), json_(json), has_colors_(has_colors), wishes_(wishes), all_(all) {}

    scene::Material make() {
        material_.name = json_.text("name");
        material_.position = document_.position(json_);
        is_double_sided_ = json_.truth("doubleSided", false);
        set_base();
        set_emission();
        if (extension("KHR_materials_unlit")) {
            glow();
            return material_;
        }
        set_relief();
        set_layers();
        set_transmission();
        set_specular();
        set_film();
        set_anisotropy();
        if (const Json occlusion = json_["occlusionTexture"]) {
            document_.dropped("occlusionTexture", "light finds by itself where it does not reach", occlusion, false);
        }
        material_.model = model_;
        if (!disperse()) {
            mix();
        }
        // A body of glass is met from within; of everything else, the back is not there.
        material_.open_behind = !is_double_sided_ && !(is_clear_ && !model_.thin);
        return material_;
    }

private:
    Json extension(std::string_view name) {
        const Json found = document_.extension(json_, name);
        if (found) {
            document_.honoured(std::string(name), found);
        }
        return found;
    }

    // factor * picture * colours of the vertices, whatever of these there is.
    scene::Texture color(const scene::Rgb& factor, Json info, bool with_vertices = false) {
        if (auto picture = textures_.of(info, false, wishes_)) {
            picture->tint = factor;
            picture->times_mesh_colors = with_vertices && has_colors_;
            return *picture;
        }
        if (with_vertices && has_colors_) {
            scene::MeshColors colors;
            colors.tint = factor;
            return colors;
        }
        return factor;
    }

    scene::Value value(double factor, Json info, scene::Channel channel) {
        scene::Value value(factor);
        if (const auto picture = textures_.of(info, true, wishes_); picture && factor != 0.0) {
            value.texture = *picture;
            value.channel = channel;
            value.scale = factor;
        }
        return value;
    }

    void set_base() {
        const Json pbr = json_["pbrMetallicRoughness"];
        const Json base = pbr["baseColorTexture"];
        const scene::Rgb factor = glm::min(color_or(pbr, "baseColorFactor", scene::Rgb(1.0)), 1.0);
        model_.color = color(factor, base, true);
        model_.metalness = value(share(pbr, "metallicFactor", 1.0), pbr["metallicRoughnessTexture"], scene::Channel::blue);
        model_.roughness = value(share(pbr, "roughnessFactor", 1.0), pbr["metallicRoughnessTexture"], scene::Channel::green);
        const std::vector<double> rgba = pbr.numbers("baseColorFactor");
        const double alpha = rgba.size() == 4 ? std::clamp(rgba[3], 0.0, 1.0) : 1.0;
        const std::string_view mode = json_.text("alphaMode", "OPAQUE");
        if (mode == "MASK" || mode == "BLEND") {
            material_.opacity = alpha;
            const bool is_textured = model_.color.index() != 0;
            if (is_textured && alpha > 0.0) {
                material_.opacity.texture = model_.color;
                material_.opacity.channel = scene::Channel::alpha;
                material_.opacity.scale = alpha;
            }
            const double cutoff = std::max(json_.number("alphaCutoff", 0.5), 0.0);
            if (mode == "MASK" && cutoff > 0.0) {
                material_.opacity_cutoff = cutoff;
                if (!is_textured) {
                    material_.opacity = alpha >= cutoff ? 1.0 : 0.0;
                    material_.opacity_cutoff = 0.0;
                }
            } else if (mode == "MASK") {
                material_.opacity = 1.0;
            }
            document_.honoured(fmt::format("alphaMode {}", mode), json_);
        }
    }

    void set_emission() {
        scene::Rgb factor = color_or(json_, "emissiveFactor", scene::Rgb(0.0));
        if (const Json strength = extension("KHR_materials_emissive_strength")) {
            factor *= std::max(strength.number("emissiveStrength", 1.0), 0.0);
        }
        if (factor != scene::Rgb(0.0)) {
            scene::Emission emission;
            emission.strength = std::max({factor.x, factor.y, factor.z});
            emission.radiance = color(factor / emission.strength, json_["emissiveTexture"]);
            emission.both_sides = is_double_sided_;
            material_.emission = emission;
        }
    }

    // As bright as its colour, whatever the light: a black surface that shines.
    void glow() {
        scene::Emission emission;
        emission.radiance = model_.color;
        emission.both_sides = is_double_sided_;
        material_.emission = emission;
        scene::DiffuseMaterial black;
        black.color = scene::Rgb(0.0);
        material_.model = black;
        material_.open_behind = !is_double_sided_;
        document_.approximated("KHR_materials_unlit", "the surface shines in its colour, and so lights others", json_);
    }

    void set_relief() {
        if (const auto normals = textures_.of(json_["normalTexture"], true, wishes_)) {
            material_.relief.normals = *normals;
            material_.relief.scale = json_["normalTexture"].number("scale", 1.0);
            wishes_.tangents = true;
        }
    }

    void set_specular() {
        if (const Json ior = extension("KHR_materials_ior")) {
            // 0 asks for a surface that reflects everything straight on; so does a very large index.
            const double index = ior.number("ior", 1.5);
            model_.refraction = index >= 1.0 ? index : 1e3;
        }
        const Json specular = extension("KHR_materials_specular");
        if (!specular) {
            return;
        }
        const Json factor = specular["specularTexture"];
        scene::Rgb tint = color_or(specular, "specularColorFactor", scene::Rgb(1.0));
        if (factor) {
            specular_share_ = value(share(specular, "specularFactor", 1.0), factor, scene::Channel::alpha);
        } else {
            tint *= share(specular, "specularFactor", 1.0);
        }
        // Colours above 1 ask for more than the index gives straight on: for another index, as KHR_materials_specular has it.
        const double most = std::max({tint.x, tint.y, tint.z});
        if (most > 1.0 && !is_clear_) {
            const double amplitude = (model_.refraction - 1.0) / (model_.refraction + 1.0);
            const double stronger = std::min(std::abs(amplitude) * std::sqrt(most), 0.995);
            model_.refraction = (1.0 + stronger) / (1.0 - stronger);
            tint /= most;
        } else if (most > 1.0) {
            document_.approximated("specularColorFactor above 1", "1 is used for clear bodies", specular);
        }
        model_.specular = color(glm::min(tint, 1.0), specular["specularColorTexture"]);
    }

    void set_layers() {
        if (const Json coat = extension("KHR_materials_clearcoat")) {
            model_.coat = value(share(coat, "clearcoatFactor", 0.0), coat["clearcoatTexture"], scene::Channel::red);
            model_.coat_roughness =
                value(share(coat, "clearcoatRoughnessFactor", 0.0), coat["clearcoatRoughnessTexture"], scene::Channel::green);
            const auto normals = textures_.of(coat["clearcoatNormalTexture"], true, wishes_);
            if (normals || material_.relief.normals) {
                model_.coat_relief.emplace();
            }
            if (normals) {
                model_.coat_relief->normals = *normals;
                model_.coat_relief->scale = coat["clearcoatNormalTexture"].number("scale", 1.0);
                wishes_.tangents = true;
            }
        }
        if (const Json sheen = extension("KHR_materials_sheen")) {
            model_.sheen = color(color_or(sheen, "sheenColorFactor", scene::Rgb(0.0)), sheen["sheenColorTexture"]);
            model_.sheen_roughness =
                value(share(sheen, "sheenRoughnessFactor", 0.0), sheen["sheenRoughnessTexture"], scene::Channel::alpha);
        }
    }

    void set_transmission() {
        const Json transmission = extension("KHR_materials_transmission");
        if (!transmission) {
            return;
        }
        model_.transmission =
            value(share(transmission, "transmissionFactor", 0.0), transmission["transmissionTexture"], scene::Channel::red);
        is_clear_ = model_.transmission.most() > 0.0;
        const Json volume = extension("KHR_materials_volume");
        model_.thin = !(volume.number("thicknessFactor", 0.0) > 0.0);
        if (volume && !model_.thin) {
            if (volume["thicknessTexture"]) {
                document_.dropped("thicknessTexture", "the shape itself says how thick it is", volume["thicknessTexture"], false);
            }
            const double distance = volume.number("attenuationDistance", 0.0);
            if (distance > 0.0) {
                // Black would swallow all on the first step; what a float still knows is black enough.
                const scene::Rgb left = glm::max(color_or(volume, "attenuationColor", scene::Rgb(1.0)), 1e-6);
                model_.absorption = glm::max(-glm::log(left) / distance, 0.0);
            }
        }
    }

    void set_film() {
        const Json film = extension("KHR_materials_iridescence");
        const double strength = share(film, "iridescenceFactor", 0.0);
        if (strength == 0.0) {
            return;
        }
        const double least = std::max(film.number("iridescenceThicknessMinimum", 100.0), 0.0);
        const double most = std::max(film.number("iridescenceThicknessMaximum", 400.0), 0.0);
        model_.film = value(1.0, film["iridescenceThicknessTexture"], scene::Channel::green);
        if (model_.film.texture) {
            model_.film.scale = most - least;
            model_.film.offset = least;
        } else {
            model_.film = most;
        }
        model_.film_refraction = std::max(film.number("iridescenceIor", 1.3), 1.0);
        if (strength < 1.0 || film["iridescenceTexture"]) {
            film_share_ = value(strength, film["iridescenceTexture"], scene::Channel::red);
        }
    }

    // What the layers can't say at each place becomes two surfaces, one here and the other there: reflections are linear in both shares.
    void mix() {
        scene::PrincipledMaterial plain = model_;
        plain.film = 0.0;
        if (film_share_) {
            material_.model = mixed(plain, model_, *film_share_);
        }
        if (specular_share_) {
            plain.specular = scene::Rgb(0.0);
            material_.model = mixed(plain, material_.model, *specular_share_);
        }
        if (film_share_ || specular_share_) {
            material_.relief = {};
        }
    }

    using Model = decltype(scene::Material::model);

    scene::MixMaterial mixed(const Model& first, const Model& second, const scene::Value& share) {
        const int one = part(first);
        return {one, part(second), share};
    }

    int part(const Model& model) {
        scene::Material inner;
        inner.name = fmt::format("{}, part {}", material_.name.empty() ? "mixed" : material_.name, ++parts_);
        inner.position = material_.position;
        inner.model = model;
        if (!std::holds_alternative<scene::MixMaterial>(model)) {
            inner.relief = material_.relief;
        }
        all_.push_back(std::move(inner));
        return static_cast<int>(all_.size()) - 1;
    }

    void set_anisotropy() {
        const Json anisotropy = extension("KHR_materials_anisotropy");
        if (!anisotropy) {
            return;
        }
        model_.anisotropy = value(share(anisotropy, "anisotropyStrength", 0.0), anisotropy["anisotropyTexture"], scene::Channel::blue);
        wishes_.tangents = true;
        model_.turn = glm::degrees(anisotropy.number("anisotropyRotation", 0.0));
        if (const auto direction = textures_.of(anisotropy["anisotropyTexture"], true, wishes_)) {
            model_.smooth_along = *direction;
        }
    }

    // Whether it is nothing but a body that parts the colours.
    bool disperse() {
        const Json json = extension("KHR_materials_dispersion");
        const double dispersion = json.number("dispersion", 0.0);
        if (!(dispersion > 0.0) || !is_clear_ || model_.thin) {
            return false;
        }
        const bool is_pure = !model_.transmission.texture && model_.transmission.number >= 1.0 && !model_.metalness.texture &&
                             model_.metalness.number == 0.0 && model_.coat.most() == 0.0 && model_.film.most() == 0.0;
        if (!is_pure) {
            model_.dispersion = dispersion;
            material_.model = model_;
            return false;
        }
        scene::DielectricMaterial glass;
        glass.refraction = scene::AbbeGlass{model_.refraction, 20.0 / dispersion};
        glass.color = model_.color;
        glass.roughness = model_.roughness;
        glass.anisotropy = model_.anisotropy;
        glass.absorption = model_.absorption;
        material_.model = glass;
        return true;
    }

    Document& document_;
    Textures& textures_;
    Json json_;
    bool has_colors_;
    Wishes& wishes_;
    std::vector<scene::Material>& all_;
    bool is_double_sided_ = false;
    bool is_clear_ = false;
    scene::Material material_;
    scene::PrincipledMaterial model_;
    std::optional<scene::Value> specular_share_;  // where a texture says how much is reflected
    std::optional<scene::Value> film_share_;      // where the film does not cover all
    int parts_ = 0;
};

}  // namespace

int make_material(Document& document, Textures& textures, Json material, bool has_colors, Wishes& wishes,
                  std::vector<scene::Material>& all) {
    scene::Material made = MaterialMaker(document, textures, material, has_colors, wishes, all).make();
    all.push_back(std::move(made));
    return static_cast<int>(all.size()) - 1;
}

}  // namespace lancer::gltf
