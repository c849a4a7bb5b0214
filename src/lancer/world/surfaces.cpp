#include "lancer/world/surfaces.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/spectrum/metal.h"
#include "lancer/spectrum/sensor.h"
#include "lancer/world/spectra.h"

namespace lancer {

namespace {

double square(double x) { return x * x; }

scene::Rgb seen(const SpectralCurve& curve) { return glm::max(reflected_rgb(curve), scene::Rgb(0.0)); }

class Surfaces {
public:
    Surfaces(World& world, Textures& textures, Colors& colors, Diagnostics& diagnostics)
        : world_(world), textures_(textures), colors_(colors), diagnostics_(diagnostics) {}

    void add(const scene::Material& material) {
        position_ = &material.position;
        kernel::MaterialRecord record{};
        record.first_input = static_cast<int>(world_.inputs.size());
        record.turn = kernel::vec2(1.0f, 0.0f);
        record.color = colors_.constant(0.0);
        record.index = colors_.constant(1.0);
        record.extinction = colors_.constant(0.0);
        record.emission = colors_.constant(0.0);
        record.clearness = colors_.constant(1.0);
        if (material.is_default) {
            set(scene::DiffuseMaterial{}, record);
        } else {
            std::visit([&](const auto& model) { set(model, record); }, material.model);
        }
        record.input_count = record.mix_first > 0 ? 0 : static_cast<int>(world_.inputs.size()) - record.first_input;
        if (material.emission) {
            record.emission = colors_.light(textures_.add(material.emission->radiance), material.emission->strength);
            record.flags |= kernel::MATERIAL_EMITS;
            if (material.emission->both_sides) {
                record.flags |= kernel::MATERIAL_EMITS_BEHIND;
            }
        }
        if (!material.is_default) {
            set_sides(material, record);
            set_relief(material.relief, record);
        }
        mark(record);
        set_pane(record);
        world_.surfaces.push_back(record);
    }

    // What one material takes over from others.
    void finish(const scene::Scene& scene) {
        for (std::size_t i = 0; i < scene.materials.size(); ++i) {
            kernel::MaterialRecord& record = world_.surfaces[i];
            if ((record.flags & kernel::MATERIAL_CHOOSES) == 0) {
                continue;
            }
            std::vector<int> parts;
            collect(static_cast<int>(i), scene.materials[i].position, 0, parts);
            for (const int part : parts) {
                const kernel::MaterialRecord& child = world_.surfaces[static_cast<std::size_t>(part)];
                if (part != static_cast<int>(i) && ((child.flags & (kernel::MATERIAL_EMITS | kernel::MATERIAL_CUT)) != 0)) {
                    diagnostics_.error(
                        scene.materials[static_cast<std::size_t>(part)].position,
                        "a material within a mix, or behind another one, neither shines nor has an opacity: the outer one may");
                }
                // The point is found once for all of them.
                record.flags |= child.flags & (kernel::MATERIAL_MAPPED | kernel::MATERIAL_TINTED);
                if (record.clear_distance <= 0.0f && child.clear_distance > 0.0f && record.mix_first > 0) {
                    record.clear_distance = child.clear_distance;
                    record.clearness = child.clearness;
                }
            }
            if (!endless_ && blends(record)) {
                record.kind = kernel::BSDF_DIFFUSE;
                record.flags |= kernel::MATERIAL_BLENDS;
                record.flags &= record.behind > 0 ? ~0 : ~kernel::MATERIAL_CHOOSES;
            }
        }
    }

private:
    // A mix of two diffuse surfaces is one of the mixed colour: nothing has to be drawn.
    bool blends(const kernel::MaterialRecord& record) const {
        if (record.mix_first <= 0) {
            return false;
        }
        constexpr int kept = kernel::MATERIAL_MAPPED | kernel::MATERIAL_TINTED | kernel::MATERIAL_ONE_SIDED;
        for (const int number : {record.mix_first, record.mix_second}) {
            const kernel::MaterialRecord& part = world_.surfaces[static_cast<std::size_t>(number - 1)];
            const bool same_side = ((part.flags ^ record.flags) & kernel::MATERIAL_ONE_SIDED) == 0;
            if (part.kind != kernel::BSDF_DIFFUSE || (part.flags & ~kept) != 0 || part.mix_first > 0 || !same_side) {
                return false;
            }
        }
        return true;
    }

    // All materials that may be met where `number` is, itself first. Too deep a nesting is a mix that contains itself.
    void collect(int number, const SourcePosition& position, int depth, std::vector<int>& parts) {
        if (depth > 32 || parts.size() > 1024) {
            if (!endless_) {
                diagnostics_.error(position, "this material contains itself, or mixes are nested more than 32 deep");
            }
            endless_ = true;
            return;
        }
        parts.push_back(number);
        const kernel::MaterialRecord record = world_.surfaces[static_cast<std::size_t>(number)];
        for (const int child : {record.behind, record.mix_first, record.mix_second}) {
            if (child > 0) {
                collect(child - 1, position, depth + 1, parts);
            }
        }
    }

    void set(const scene::WhittedMaterial&, kernel::MaterialRecord&) {
        diagnostics_.error(
            *position_,
            "this material is for the whitted integrator; for path it needs another type, such as diffuse, conductor or principled");
    }

    void set(const scene::DiffuseMaterial& material, kernel::MaterialRecord& record) {
        record.kind = material.roughness.most() > 0.0 ? kernel::BSDF_ROUGH_DIFFUSE : kernel::BSDF_DIFFUSE;
        record.color = colors_.reflectance(textures_.add(material.color));
        record.roughness_x = take(material.roughness, kernel::INPUT_ROUGHNESS, 1.0);
    }

    void set(const scene::ConductorMaterial& material, kernel::MaterialRecord& record) {
        record.kind = kernel::BSDF_CONDUCTOR;
        set_roughness(material.roughness, material.anisotropy, record);
        set_facets(material.facets, record);
        if (const auto metal = find_metal(material.metal)) {
            record.color = tint(material.color);
            record.index = index(metal->n);
            record.extinction = index(metal->k);
        } else if (material.n && material.k) {
            record.color = tint(material.color);
            record.index = index(*material.n);
            record.extinction = index(*material.k);
        } else {
            // A perfect mirror times the colour.
            record.color = colors_.reflectance(textures_.add(material.color));
            record.index = colors_.constant(0.0);
            record.extinction = colors_.constant(1.0);
        }
    }

    void set(const scene::DielectricMaterial& material, kernel::MaterialRecord& record) {
        record.kind = material.thin ? kernel::BSDF_THIN_DIELECTRIC : kernel::BSDF_DIELECTRIC;
        record.flags |= material.thin ? 0 : kernel::MATERIAL_BODY;
        record.color = colors_.reflectance(textures_.add(material.color));
        set_roughness(material.roughness, material.anisotropy, record);
        set_facets(material.facets, record);
        set_clearness(material.absorption, colors_, record);
    }

    void set(const scene::NullMaterial&, kernel::MaterialRecord& record) { record.kind = kernel::BSDF_NULL; }

    void set(const scene::PlasticMaterial& material, kernel::MaterialRecord& record) {
        record.kind = kernel::BSDF_PLASTIC;
        record.color = colors_.reflectance(textures_.add(material.color));
        record.extinction = colors_.constant(1.0);
        record.eta = static_cast<float>(material.refraction);
        record.flags |= material.saturates ? kernel::MATERIAL_SATURATES : 0;
        set_roughness(material.roughness, 0.0, record);
        set_facets(material.facets, record);
    }

    void set(const scene::PrincipledMaterial& material, kernel::MaterialRecord& record) {
        record.kind = kernel::BSDF_PRINCIPLED;
        record.color = colors_.reflectance(textures_.add(material.color));
        record.index = colors_.reflectance(textures_.add(material.sheen));
        record.extinction = colors_.reflectance(textures_.add(material.specular));
        record.eta = static_cast<float>(material.refraction);
        set_roughness(material.roughness, material.anisotropy, record);
        const double turn = glm::radians(material.turn);
        record.turn = kernel::vec2(static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn)));
        if (material.smooth_along && (record.flags & kernel::MATERIAL_TURNED) != 0) {
            record.turn_map = 1 + textures_.add(*material.smooth_along).number;
        }
        record.metalness = take(material.metalness, kernel::INPUT_METALNESS);
        record.transmission = take(material.transmission, kernel::INPUT_TRANSMISSION);
        record.coat = take(material.coat, kernel::INPUT_COAT);
        record.coat_roughness =
            static_cast<float>(square(static_cast<double>(take(material.coat_roughness, kernel::INPUT_COAT_ROUGHNESS))));
        record.coat_index = 1.5f;
        if (material.coat_relief && material.coat.most() > 0.0) {
            set_coat_relief(*material.coat_relief, record);
        }
        record.sheen_roughness = take(material.sheen_roughness, kernel::INPUT_SHEEN_ROUGHNESS);
        record.film_thickness = take(material.film, kernel::INPUT_FILM);
        record.film_index = static_cast<float>(material.film_refraction);
        record.flags |= material.thin ? kernel::MATERIAL_THIN : 0;
        const bool clear = material.transmission.number >= 1.0 && !material.transmission.texture && !(material.metalness.most() > 0.0);
        record.flags |= clear && !material.thin ? kernel::MATERIAL_BODY : 0;
        set_clearness(material.absorption, colors_, record);
    }

    void set_coat_relief(const scene::CoatRelief& relief, kernel::MaterialRecord& record) {
        record.flags |= kernel::MATERIAL_OWN_COAT;
        world_.has_own_coats = true;
        if (relief.normals) {
            record.coat_normal_map = 1 + textures_.add(*relief.normals).number;
            record.coat_normal_scale = kernel::vec2(static_cast<float>(relief.scale));
            record.flags |= kernel::MATERIAL_MAPPED;
        }
    }

    void set(const scene::BurleyMaterial& material, kernel::MaterialRecord& record) {
        record.kind = kernel::BSDF_BURLEY;
        const CompiledTexture color = textures_.add(material.color);
        record.color = colors_.reflectance(color);
        record.eta = static_cast<float>(material.refraction);
        set_roughness(material.roughness, material.anisotropy, record);
        record.metalness = take(material.metalness, kernel::INPUT_METALNESS);
        record.transmission = take(material.transmission, kernel::INPUT_TRANSMISSION);
        record.coat = take(material.coat, kernel::INPUT_COAT);
        record.coat_roughness = static_cast<float>(0.1 + (0.001 - 0.1) * material.coat_gloss);
        record.sheen_roughness = take(material.sheen, kernel::INPUT_SHEEN_ROUGHNESS);
        record.film_index = take(material.passes, kernel::INPUT_PASSES);
        record.sheen_tint = static_cast<float>(material.sheen_tint);
        record.specular_tint = static_cast<float>(material.specular_tint);
        record.flatness = static_cast<float>(material.flatness);
        record.brightness = static_cast<float>(glm::dot(reflected(color.color), scene::Rgb(0.2126, 0.7152, 0.0722)));
        const bool clear = material.transmission.number >= 1.0 && !material.transmission.texture && !(material.metalness.most() > 0.0);
        record.flags |= material.thin ? kernel::MATERIAL_THIN : clear ? kernel::MATERIAL_BODY : 0;
    }

    void set(const scene::MixMaterial& material, kernel::MaterialRecord& record) {
        record.mix_first = 1 + material.first;
        record.mix_second = 1 + material.second;
        record.mix_share = static_cast<float>(material.share.number);
        record.mix_input = refer(material.share, kernel::INPUT_SHARE);
        record.flags |= kernel::MATERIAL_CHOOSES;
    }

    void set_sides(const scene::Material& material, kernel::MaterialRecord& record) {
        record.flags |= material.one_sided ? kernel::MATERIAL_ONE_SIDED : 0;
        if (material.behind) {
            record.behind = 1 + *material.behind;
            record.flags |= kernel::MATERIAL_CHOOSES;
        }
        record.opacity = static_cast<float>(material.opacity.number);
        if (material.opacity.texture || material.opacity.number < 1.0) {
            record.opacity_input = refer(material.opacity, kernel::INPUT_OPACITY);
            record.opacity_cutoff = static_cast<float>(material.opacity_cutoff);
            record.flags |= kernel::MATERIAL_CUT;
            world_.has_cuts = true;
        }
        if (material.open_behind) {
            record.flags |= kernel::MATERIAL_CUT | kernel::MATERIAL_OPEN_BEHIND;
            world_.has_cuts = true;
        }
        world_.has_choices = world_.has_choices || (record.flags & kernel::MATERIAL_CHOOSES) != 0;
    }

    // A pane that looks the same from both sides and does nothing but mirror and let pass.
    void set_pane(kernel::MaterialRecord& record) {
        constexpr int others = kernel::MATERIAL_CHOOSES | kernel::MATERIAL_EMITS | kernel::MATERIAL_ONE_SIDED | kernel::MATERIAL_RELIEF |
                               kernel::MATERIAL_OPEN_BEHIND;
        if (record.kind == kernel::BSDF_THIN_DIELECTRIC && (record.flags & others) == 0) {
            record.flags |= kernel::MATERIAL_PANE;
            world_.has_cuts = true;
        }
    }

    void set_relief(const scene::Relief& relief, kernel::MaterialRecord& record) {
        if (relief.normals) {
            record.normal_map = 1 + textures_.add(*relief.normals).number;
            const double scale = relief.flips_green ? -relief.scale : relief.scale;
            record.normal_scale = kernel::vec2(static_cast<float>(relief.scale), static_cast<float>(scale));
        }
        if (relief.heights && relief.heights->texture) {
            record.height_input = refer(*relief.heights, kernel::INPUT_HEIGHT);
        }
        if (record.normal_map > 0 || record.height_input > 0) {
            record.flags |= kernel::MATERIAL_RELIEF | kernel::MATERIAL_MAPPED | (relief.shadows ? kernel::MATERIAL_HILLS : 0) |
                            (relief.crosswise ? kernel::MATERIAL_CROSSWISE : 0);
        }
    }

    // 1 + the number of an input that the record refers to, 0 where the value is the same everywhere. After all that `take` takes.
    int refer(const scene::Value& value, int kind) {
        if (!value.texture) {
            return 0;
        }
        take(value, kind);
        return static_cast<int>(world_.inputs.size());
    }

    // The number of a material, which stands in its record; where a texture gives it, `otherwise`, and the texture among the inputs.
    float take(const scene::Value& value, int kind, double otherwise = 0.0) {
        if (!value.texture) {
            return static_cast<float>(value.number);
        }
        const CompiledTexture texture = textures_.add(*value.texture);
        world_.inputs.push_back(
            {kind, texture.number, static_cast<int>(value.channel), static_cast<float>(value.scale), static_cast<float>(value.offset)});
        return static_cast<float>(otherwise);
    }

    static void set_facets(const scene::Facets& facets, kernel::MaterialRecord& record) {
        record.flags |= facets.distribution == scene::Facets::Distribution::beckmann ? kernel::MATERIAL_BECKMANN : 0;
        record.flags |= facets.separate ? kernel::MATERIAL_SEPARATE : 0;
        record.flags |= facets.once ? kernel::MATERIAL_ONCE : 0;
    }

    // As RGB: each channel's index is the mean of the spectrum as the channel sees it.
    kernel::ColorRecord index(const SpectralCurve& curve) { return colors_.curve(curve, seen(curve)); }

    kernel::ColorRecord index(const scene::Index& index_of) {
        if (const auto* measured = std::get_if<scene::MeasuredSpectrum>(&index_of)) {
            return index(index_curve(*measured));
        }
        const scene::Rgb& rgb = std::get<scene::Rgb>(index_of);
        if (rgb.x == rgb.y && rgb.y == rgb.z) {
            return colors_.constant(rgb.x);
        }
        kernel::ColorRecord record = colors_.light(rgb);
        record.illuminant = -1;
        return record;
    }

    // White is 1 exactly.
    kernel::ColorRecord tint(const scene::Texture& texture) {
        const auto* color = std::get_if<scene::Color>(&texture);
        return color && *color == scene::Color(scene::Rgb(1.0)) ? colors_.constant(1.0) : colors_.reflectance(textures_.add(texture));
    }

    // Before all other inputs, which do not build upon it.
    void set_roughness(const scene::Value& roughness, const scene::Value& anisotropy, kernel::MaterialRecord& record) {
        const double alpha = square(static_cast<double>(take(roughness, kernel::INPUT_ROUGHNESS, 1.0)));
        const double aspect = std::sqrt(1.0 - 0.9 * static_cast<double>(take(anisotropy, kernel::INPUT_ANISOTROPY)));
        // Where the kernel goes on with them they are not cut yet.
        const double most = roughness.texture || anisotropy.texture ? 1e6 : 1.0;
        record.roughness_x = static_cast<float>(std::min(alpha * aspect, most));
        record.roughness_y = static_cast<float>(std::min(alpha / aspect, most));
        if (anisotropy.most() != 0.0) {
            record.flags |= kernel::MATERIAL_TURNED | kernel::MATERIAL_MAPPED;
            world_.has_directions = true;
        }
    }

    // What the record's textures need to know of a surface.
    void mark(kernel::MaterialRecord& record) {
        const auto look_at = [&](int number) {
            if (number >= 0) {
                const kernel::TextureRecord& texture = world_.textures[static_cast<std::size_t>(number)];
                const bool of_mesh = texture.kind == kernel::TEXTURE_VERTEX_COLOR || texture.kind == kernel::TEXTURE_FACE_COLOR;
                record.flags |= of_mesh ? kernel::MATERIAL_TINTED : kernel::MATERIAL_MAPPED;
                record.flags |= texture.tint == kernel::TINT_VERTEX_COLORS ? kernel::MATERIAL_TINTED : 0;
            }
        };
        for (const kernel::ColorRecord* color : {&record.color, &record.index, &record.extinction, &record.emission}) {
            look_at(color->texture);
        }
        for (std::size_t i = static_cast<std::size_t>(record.first_input); i < world_.inputs.size(); ++i) {
            look_at(world_.inputs[i].texture);
        }
    }

    World& world_;
    Textures& textures_;
    Colors& colors_;
    Diagnostics& diagnostics_;
    const SourcePosition* position_ = nullptr;
    bool endless_ = false;
};

}  // namespace

void set_clearness(const scene::Color& absorption, Colors& colors, kernel::MaterialRecord& record) {
    const scene::Rgb& rgb = absorption.rgb;
    const SpectralCurve curve = absorption.spectrum ? reflectance_curve(*absorption.spectrum) : SpectralCurve(0.0);
    const std::vector<double> visible = curve.on(fine_grid);
    const double most = absorption.spectrum ? *std::max_element(visible.begin(), visible.end()) : std::max({rgb.x, rgb.y, rgb.z});
    if (most > 0.0) {
        // The depth at which the strongest colour has faded to 1/e: neither 0 nor 1, which no spectrum could tell from their neighbours.
        record.clear_distance = static_cast<float>(1.0 / most);
        if (absorption.spectrum) {
            const SpectralCurve left = clearness(curve, 1.0 / most);
            record.clearness = colors.curve(left, seen(left));
        } else {
            record.clearness = colors.reflectance(scene::Rgb(glm::exp(-rgb / most)));
        }
    }
}

void compile_surfaces(const scene::Scene& scene, World& world, Textures& textures, Colors& colors, Diagnostics& diagnostics) {
    Surfaces surfaces(world, textures, colors, diagnostics);
    for (const scene::Material& material : scene.materials) {
        surfaces.add(material);
    }
    surfaces.finish(scene);
}

}  // namespace lancer
