#include "lancer/world/surfaces.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "lancer/spectrum/metal.h"
#include "lancer/spectrum/sensor.h"
#include "lancer/world/spectra.h"

namespace lancer {

namespace {

class Surfaces {
public:
    Surfaces(World& world, Textures& textures, Colors& colors, Diagnostics& diagnostics)
        : world_(world), textures_(textures), colors_(colors), diagnostics_(diagnostics) {}

    void add(const scene::Material& material) {
        position_ = &material.position;
        kernel::MaterialRecord record{};
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
        if (material.emission) {
            record.emission = colors_.light(textures_.add(material.emission->radiance), material.emission->strength);
            record.flags |= kernel::MATERIAL_EMITS;
            if (material.emission->both_sides) {
                record.flags |= kernel::MATERIAL_EMITS_BEHIND;
            }
        }
        world_.surfaces.push_back(record);
    }

private:
    void set(const scene::WhittedMaterial&, kernel::MaterialRecord&) {
        diagnostics_.error(
            *position_,
            "this material is for the whitted integrator; for path it needs another type, such as diffuse, conductor or principled");
    }

    void set(const scene::DiffuseMaterial& material, kernel::MaterialRecord& record) {
        record.kind = material.roughness > 0.0 ? kernel::BSDF_ROUGH_DIFFUSE : kernel::BSDF_DIFFUSE;
        record.color = colors_.reflectance(textures_.add(material.color));
        record.roughness_x = static_cast<float>(material.roughness);
    }

    void set(const scene::ConductorMaterial& material, kernel::MaterialRecord& record) {
        record.kind = kernel::BSDF_CONDUCTOR;
        set_roughness(material.roughness, material.anisotropy, record);
        if (const auto metal = find_metal(material.metal)) {
            // As RGB: each channel's index is the mean of the spectrum as the channel sees it.
            record.color = colors_.constant(1.0);
            record.index = colors_.curve(metal->n, seen(metal->n));
            record.extinction = colors_.curve(metal->k, seen(metal->k));
        } else if (material.n && material.k) {
            const SpectralCurve n = index_curve(*material.n), k = index_curve(*material.k);
            record.color = colors_.constant(1.0);
            record.index = colors_.curve(n, seen(n));
            record.extinction = colors_.curve(k, seen(k));
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
        record.index = colors_.reflectance(material.sheen);
        record.extinction = colors_.reflectance(material.specular);
        record.eta = static_cast<float>(material.refraction);
        record.metalness = static_cast<float>(material.metalness);
        record.transmission = static_cast<float>(material.transmission);
        record.coat = static_cast<float>(material.coat);
        record.coat_roughness = static_cast<float>(material.coat_roughness * material.coat_roughness);
        record.coat_index = 1.5f;
        record.sheen_roughness = static_cast<float>(material.sheen_roughness);
        record.film_thickness = static_cast<float>(material.film);
        record.film_index = static_cast<float>(material.film_refraction);
        record.flags |= material.thin ? kernel::MATERIAL_THIN : 0;
        set_roughness(material.roughness, material.anisotropy, record);
        set_absorption(material.absorption, record);
    }

    void set_absorption(const scene::Color& absorption, kernel::MaterialRecord& record) {
        const scene::Rgb& rgb = absorption.rgb;
        const SpectralCurve curve = absorption.spectrum ? reflectance_curve(*absorption.spectrum) : SpectralCurve(0.0);
        const std::vector<double> visible = curve.on(fine_grid);
        const double most = absorption.spectrum ? *std::max_element(visible.begin(), visible.end()) : std::max({rgb.x, rgb.y, rgb.z});
        if (most > 0.0) {
            // The depth at which the strongest colour has faded to 1/e: neither 0 nor 1, which no spectrum could tell from their neighbours.
            record.clear_distance = static_cast<float>(1.0 / most);
            if (absorption.spectrum) {
                const SpectralCurve left = clearness(curve, 1.0 / most);
                record.clearness = colors_.curve(left, seen(left));
            } else {
                record.clearness = colors_.reflectance(scene::Rgb(glm::exp(-rgb / most)));
            }
        }
    }

    static void set_roughness(double roughness, double anisotropy, kernel::MaterialRecord& record) {
        const double alpha = roughness * roughness;
        const double aspect = std::sqrt(1.0 - 0.9 * anisotropy);
        record.roughness_x = static_cast<float>(std::min(alpha * aspect, 1.0));
        record.roughness_y = static_cast<float>(std::min(alpha / aspect, 1.0));
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
