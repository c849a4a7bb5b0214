#include "lancer/world/surfaces.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "lancer/spectrum/metal.h"
#include "lancer/spectrum/sensor.h"

namespace lancer {

namespace {

double square(double x) { return x * x; }

class Surfaces {
public:
    Surfaces(World& world, Textures& textures, Colors& colors, Diagnostics& diagnostics)
        : world_(world), textures_(textures), colors_(colors), diagnostics_(diagnostics) {}

    void add(const scene::Material& material) {
        position_ = &material.position;
        kernel::MaterialRecord record{};
        record.first_input = static_cast<int>(world_.inputs.size());
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
        record.input_count = static_cast<int>(world_.inputs.size()) - record.first_input;
        if (material.emission) {
            record.emission = colors_.light(textures_.add(material.emission->radiance), material.emission->strength);
            record.flags |= kernel::MATERIAL_EMITS;
            if (material.emission->both_sides) {
                record.flags |= kernel::MATERIAL_EMITS_BEHIND;
            }
        }
        mark(record);
        world_.surfaces.push_back(record);
    }

private:
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
        if (const auto metal = find_metal(material.metal)) {
            // As RGB: each channel's index is the mean of the spectrum as the channel sees it.
            record.color = colors_.constant(1.0);
            record.index = colors_.curve(metal->n, seen(metal->n));
            record.extinction = colors_.curve(metal->k, seen(metal->k));
        } else {
            // A perfect mirror times the colour.
            record.color = colors_.reflectance(textures_.add(material.color));
            record.index = colors_.constant(0.0);
            record.extinction = colors_.constant(1.0);
        }
    }

    void set(const scene::DielectricMaterial& material, kernel::MaterialRecord& record) {
        record.kind = material.thin ? kernel::BSDF_THIN_DIELECTRIC : kernel::BSDF_DIELECTRIC;
        record.color = colors_.reflectance(textures_.add(material.color));
        set_roughness(material.roughness, material.anisotropy, record);
        set_absorption(material.absorption, record);
    }

    void set(const scene::PlasticMaterial& material, kernel::MaterialRecord& record) {
        record.kind = kernel::BSDF_PLASTIC;
        record.color = colors_.reflectance(textures_.add(material.color));
        record.extinction = colors_.constant(1.0);
        record.eta = static_cast<float>(material.refraction);
        record.flags |= material.saturates ? kernel::MATERIAL_SATURATES : 0;
        set_roughness(material.roughness, 0.0, record);
    }

    void set(const scene::PrincipledMaterial& material, kernel::MaterialRecord& record) {
        record.kind = kernel::BSDF_PRINCIPLED;
        record.color = colors_.reflectance(textures_.add(material.color));
        record.index = colors_.reflectance(textures_.add(material.sheen));
        record.extinction = colors_.reflectance(textures_.add(material.specular));
        record.eta = static_cast<float>(material.refraction);
        set_roughness(material.roughness, material.anisotropy, record);
        record.metalness = take(material.metalness, kernel::INPUT_METALNESS);
        record.transmission = take(material.transmission, kernel::INPUT_TRANSMISSION);
        record.coat = take(material.coat, kernel::INPUT_COAT);
        record.coat_roughness = static_cast<float>(square(static_cast<double>(take(material.coat_roughness, kernel::INPUT_COAT_ROUGHNESS))));
        record.coat_index = 1.5f;
        record.sheen_roughness = take(material.sheen_roughness, kernel::INPUT_SHEEN_ROUGHNESS);
        record.film_thickness = take(material.film, kernel::INPUT_FILM);
        record.film_index = static_cast<float>(material.film_refraction);
        record.flags |= material.thin ? kernel::MATERIAL_THIN : 0;
        set_absorption(material.absorption, record);
    }

    void set_absorption(const scene::Rgb& absorption, kernel::MaterialRecord& record) {
        const double most = std::max({absorption.x, absorption.y, absorption.z});
        if (most > 0.0) {
            // The depth at which the strongest colour has faded to 1/e: neither 0 nor 1, which no spectrum could tell from their neighbours.
            record.clear_distance = static_cast<float>(1.0 / most);
            record.clearness = colors_.reflectance(glm::exp(-absorption / most));
        }
    }

    // The number of a material, which stands in its record; where a texture gives it, `otherwise`, and the texture among the inputs.
    float take(const scene::Value& value, int kind, double otherwise = 0.0) {
        if (!value.texture) {
            return static_cast<float>(value.number);
        }
        const CompiledTexture texture = textures_.add(*value.texture);
        world_.inputs.push_back({kind, texture.number, static_cast<int>(value.channel), static_cast<float>(value.scale),
                                 static_cast<float>(value.offset)});
        return static_cast<float>(otherwise);
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
            }
        };
        for (const kernel::ColorRecord* color : {&record.color, &record.index, &record.extinction, &record.emission}) {
            look_at(color->texture);
        }
        for (int i = 0; i < record.input_count; ++i) {
            look_at(world_.inputs[static_cast<std::size_t>(record.first_input + i)].texture);
        }
    }

    static scene::Rgb seen(const SpectralCurve& curve) { return glm::max(reflected_rgb(curve), scene::Rgb(0.0)); }

    World& world_;
    Textures& textures_;
    Colors& colors_;
    Diagnostics& diagnostics_;
    const SourcePosition* position_ = nullptr;
};

}  // namespace

void compile_surfaces(const scene::Scene& scene, World& world, Textures& textures, Colors& colors, Diagnostics& diagnostics) {
    Surfaces surfaces(world, textures, colors, diagnostics);
    for (const scene::Material& material : scene.materials) {
        surfaces.add(material);
    }
}

}  // namespace lancer
