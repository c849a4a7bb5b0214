// From Phong's words to surfaces that follow physics.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "lancer/base/file.h"
#include "lancer/import/obj/mtl.h"

namespace lancer::obj {

namespace {

constexpr double bump_metres = 0.01;  // what a picture's white is raised by, where the file speaks of no unit

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

class Maker {
public:
    Maker(const MaterialStatements& statements, const std::string& file, ImportContext& context)
        : from_(statements), file_(file), context_(context) {}

    scene::Material make() {
        scene::Material material;
        material.name = from_.name;
        material.position = from_.position;
        const int illumination = static_cast<int>(std::clamp(from_.number("illum").value_or(2.0), 0.0, 10.0));
        const bool is_glass = illumination == 4 || illumination == 6 || illumination == 7 || illumination == 9;
        if (is_glass) {
            material.model = glass();
        } else {
            material.model = opaque(illumination);
            set_opacity(material);
        }
        set_emission(material);
        set_relief(material);
        for (const char* key : {"map_ka", "map_ns", "refl", "disp", "decal", "map_pc", "map_pcr"}) {
            if (const Map* map = from_.map(key)) {
                const bool is_seen = std::string_view(key) != "map_ka";
                context_.report.dropped(fmt::format("MTL {}", key),
                                        is_seen ? "lancer has nothing like it" : "ambient light finds its own way", map->position, is_seen);
            }
        }
        return material;
    }

private:
    // Nobody gives back more light than there is.
    scene::Rgb share(const char* key, const scene::Rgb& otherwise) {
        const auto color = from_.color(key);
        if (color && largest(*color) > 1.0) {
            context_.report.approximated(fmt::format("MTL {} above 1", key), "1 is used", from_.position);
        }
        return glm::clamp(color.value_or(otherwise), 0.0, 1.0);
    }

    double share(const char* key, double otherwise) { return std::clamp(from_.number(key).value_or(otherwise), 0.0, 1.0); }

    std::optional<scene::ImageTexture> picture(const Map* map, bool linear) {
        if (map == nullptr) {
            return std::nullopt;
        }
        scene::ImageTexture image;
        image.file = path_beside(file_, map->file);
        image.position = map->position;
        context_.files.image(image, map->position);
        image.linear = linear;
        image.scale = map->scale;
        image.offset = map->offset;
        image.wrap = map->clamps ? scene::Wrap::clamp : scene::Wrap::repeat;
        context_.report.honoured("MTL pictures", map->position);
        return image;
    }

    scene::Texture color(const char* key, const char* map_key, const scene::Rgb& otherwise) {
        const Map* map = from_.map(map_key);
        const scene::Rgb factor = share(key, map != nullptr ? scene::Rgb(1.0) : otherwise);
        if (auto image = picture(map, false)) {
            image->tint = factor * map->gain;
            if (map->base != 0.0) {
                context_.report.dropped("MTL -mm", "the base of a picture of colours", map->position);
            }
            return *image;
        }
        return factor;
    }

    scene::Value value(double factor, const char* map_key, scene::Channel standard = scene::Channel::red) {
        const Map* map = from_.map(map_key);
        scene::Value value(factor);
        if (const auto image = picture(map, true)) {
            value.texture = *image;
            value.channel = channel_of(*map, standard);
            value.scale = map->gain;
            value.offset = map->base;
        }
        return value;
    }

    static scene::Channel channel_of(const Map& map, scene::Channel standard) {
        switch (map.channel) {
            case 'r':
                return scene::Channel::red;
            case 'g':
                return scene::Channel::green;
            case 'b':
                return scene::Channel::blue;
            case 'm':
                return scene::Channel::alpha;
            default:
                return standard;
        }
    }

    // The exponent of a Phong lobe as the width of facets that scatter about as far [Walter et al. 2007].
    double roughness() const {
        if (const auto own = from_.number("pr")) {
            return std::clamp(*own, 0.0, 1.0);
        }
        const double exponent = std::max(from_.number("ns").value_or(0.0), 0.0);
        return std::pow(2.0 / (exponent + 2.0), 0.25);
    }

    bool has_physical_keys() const {
        return std::any_of(std::begin(physical_keys), std::end(physical_keys),
                           [&](const char* key) { return from_.numbers.contains(key); }) ||
               from_.map("map_pr") != nullptr || from_.map("map_pm") != nullptr || from_.map("map_ps") != nullptr;
    }

    scene::DielectricMaterial glass() {
        scene::DielectricMaterial model;
        const double index = from_.number("ni").value_or(1.5);
        model.refraction = index >= 1.0 && index <= 10.0 ? index : 1.5;
        model.color = share("tf", scene::Rgb(1.0));
        context_.report.honoured("MTL illum, clear bodies", from_.position);
        return model;
    }

    decltype(scene::Material::model) opaque(int illumination) {
        const scene::Rgb mirror = share("ks", scene::Rgb(0.0));
        const bool has_map = from_.map("map_ks") != nullptr;
        if (has_physical_keys()) {
            return layered();
        }
        if (illumination < 2 || (largest(mirror) == 0.0 && !has_map)) {
            scene::DiffuseMaterial model;
            model.color = color("kd", "map_kd", scene::Rgb(0.8));
            context_.report.honoured("MTL matt surfaces", from_.position);
            return model;
        }
        scene::PrincipledMaterial model;
        model.color = color("kd", "map_kd", scene::Rgb(0.8));
        model.roughness = roughness();
        if (illumination == 3 || illumination == 5 || illumination == 8) {
            // A mirror: it gives back Ks of what it sees straight on.
            const double most = std::clamp(largest(mirror), 0.0, 0.99);
            const double amplitude = std::sqrt(most);
            model.refraction = most > 0.0 ? (1.0 + amplitude) / (1.0 - amplitude) : 1.5;
            model.specular = most > 0.0 ? glm::min(mirror / most, scene::Rgb(1.0)) : scene::Rgb(1.0);
            model.roughness = 0.0;
            context_.report.approximated("MTL mirrors", "Ks is what is mirrored straight on; more is at grazing angles", from_.position);
            return model;
        }
        // Programs write 0.5 for what glass or plastic reflects.
        model.specular = color("ks", "map_ks", scene::Rgb(1.0));
        if (auto* tint = std::get_if<scene::Color>(&model.specular)) {
            tint->rgb = glm::min(2.0 * tint->rgb, scene::Rgb(1.0));
        }
        context_.report.approximated("MTL highlights", "Ks and Ns are facets of a coat that reflects 4 % where Ks is 0.5", from_.position);
        return model;
    }

    scene::PrincipledMaterial layered() {
        scene::PrincipledMaterial model;
        model.color = color("kd", "map_kd", scene::Rgb(0.8));
        model.metalness = value(share("pm", 0.0), "map_pm");
        model.roughness = value(roughness(), "map_pr");
        model.sheen = scene::Rgb(share("ps", 0.0));
        if (from_.map("map_ps") != nullptr) {
            context_.report.dropped("MTL map_Ps", "sheen is the same everywhere", from_.map("map_ps")->position);
        }
        model.coat = share("pc", 0.0);
        model.coat_roughness = share("pcr", 0.0);
        model.anisotropy = share("aniso", 0.0);
        if (from_.number("anisor").value_or(0.0) != 0.0) {
            context_.report.dropped("MTL anisor", "highlights run along u", from_.position);
        }
        const double index = from_.number("ni").value_or(1.5);
        model.refraction = index > 1.0 && index <= 3.0 ? index : 1.5;
        context_.report.honoured("MTL Pr, Pm, Ps, Pc, Pcr, aniso", from_.position);
        return model;
    }

    void set_opacity(scene::Material& material) {
        double opacity = 1.0;
        if (const auto d = from_.number("d")) {
            opacity = *d;
        } else if (const auto tr = from_.number("tr")) {
            opacity = 1.0 - *tr;
        }
        material.opacity = std::clamp(opacity, 0.0, 1.0);
        if (const Map* map = from_.map("map_d")) {
            const Map* colors = from_.map("map_kd");
            const bool is_same = colors != nullptr && colors->file == map->file;
            material.opacity = value(1.0, "map_d", is_same ? scene::Channel::alpha : scene::Channel::red);
        }
    }

    void set_emission(scene::Material& material) {
        const Map* map = from_.map("map_ke");
        const scene::Rgb factor = glm::max(from_.color("ke").value_or(scene::Rgb(map != nullptr ? 1.0 : 0.0)), 0.0);
        if (largest(factor) == 0.0) {
            return;
        }
        scene::Emission emission;
        emission.strength = largest(factor);
        emission.radiance = factor / emission.strength;
        if (auto image = picture(map, false)) {
            image->tint = factor / emission.strength;
            emission.radiance = *image;
        }
        material.emission = emission;
        context_.report.honoured("MTL Ke", from_.position);
    }

    void set_relief(scene::Material& material) {
        const Map* normals = from_.map("norm") != nullptr ? from_.map("norm") : from_.map("map_kn");
        if (auto image = picture(normals, true)) {
            material.relief.normals = *image;
            material.relief.scale = normals->bump;
        }
        const Map* bumps = from_.map("map_bump") != nullptr ? from_.map("map_bump") : from_.map("bump");
        if (auto image = picture(bumps, true)) {
            scene::Value heights(0.0);
            heights.texture = *image;
            heights.channel = channel_of(*bumps, scene::Channel::red);
            heights.scale = bump_metres * bumps->bump * bumps->gain;
            material.relief.heights = heights;
            context_.report.approximated("MTL bump", "white is raised by a centimetre, times -bm", bumps->position);
        }
    }

    static constexpr const char* physical_keys[] = {"pr", "pm", "ps", "pc", "pcr", "aniso"};

    const MaterialStatements& from_;
    const std::string& file_;
    ImportContext& context_;
};

}  // namespace

scene::Material make_material(const MaterialStatements& statements, const std::string& file, ImportContext& context) {
    return Maker(statements, file, context).make();
}

}  // namespace lancer::obj
