#include "lancer/world/materials.h"

#include <string>

#include <fmt/format.h>

#include "lancer/spectrum/glass.h"
#include "lancer/spectrum/observer.h"
#include "lancer/world/spectra.h"

namespace lancer {

namespace {

kernel::vec3 to_float(const glm::dvec3& v) { return kernel::vec3(v); }

class Materials {
public:
    Materials(const scene::Scene& scene, World& world, Textures& textures, Colors& colors, Diagnostics& diagnostics)
        : scene_(scene), world_(world), textures_(textures), colors_(colors), diagnostics_(diagnostics) {}

    void compile() {
        bool disperses = false;
        for (const scene::Material& material : scene_.materials) {
            std::visit([&](const auto& model) { add(model, material.position); }, material.model);
            disperses = disperses || world_.media.back().dispersive != 0;
        }
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
            if (std::holds_alternative<scene::MixMaterial>(scene_.materials[i].model)) {
                world_.media[i] = medium_of(static_cast<int>(i), 0);
            }
        }
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
            world_.media[i].volume = -1;
            world_.media[i].priority = scene_.materials[i].priority;
        }
        if (disperses) {
            for (const WavelengthBand& band : wavelength_bands(scene_.settings.wavelengths)) {
                world_.bands.push_back({static_cast<float>(band.nanometres), to_float(band.weight)});
            }
        }
    }

private:
    void add(const scene::WhittedMaterial& material, const SourcePosition& position) {
        kernel::WhittedRecord record{};
        const CompiledTexture color = textures_.add(material.color);
        record.texture = color.number;
        record.color = to_float(reflected(color.color));
        record.ambient = static_cast<float>(material.ambient);
        record.diffuse = static_cast<float>(material.diffuse);
        record.highlight = static_cast<float>(material.highlight);
        record.shininess = static_cast<float>(material.shininess);
        record.reflectivity = static_cast<float>(material.reflectivity);
        record.transparency = static_cast<float>(material.transparency);
        kernel::MediumRecord medium{};
        medium.absorption = to_float(reflected(material.absorption));
        std::visit([&](const auto& refraction) { set_refraction(refraction, medium, position); }, material.refraction);
        world_.has_transparency = world_.has_transparency || material.transparency > 0.0;
        world_.materials.push_back(record);
        world_.media.push_back(medium);
    }

    // For Whitted's integrator the materials that follow physics are not there.
    void add(const scene::DielectricMaterial& material, const SourcePosition& position) {
        kernel::MediumRecord medium{};
        std::visit([&](const auto& refraction) { set_refraction(refraction, medium, position); }, material.refraction);
        world_.has_transparency = true;
        world_.materials.push_back(no_material());
        world_.media.push_back(medium);
    }

    void add(const scene::PrincipledMaterial& material, const SourcePosition& position) {
        kernel::MediumRecord medium{};
        if (material.dispersion > 0.0) {
            set_refraction(scene::AbbeGlass{material.refraction, 20.0 / material.dispersion}, medium, position);
        } else {
            set_refraction(material.refraction, medium, position);
        }
        world_.has_transparency = world_.has_transparency || material.transmission.most() > 0.0;
        world_.materials.push_back(no_material());
        world_.media.push_back(medium);
    }

    // Nothing, as far as light is bent.
    void add(const scene::NullMaterial&, const SourcePosition&) {
        kernel::MediumRecord medium{};
        medium.refraction = kernel::REFRACTION_NONE;
        medium.refraction_a = kernel::vec3(1.0f, 0.0f, 0.0f);
        world_.has_transparency = true;
        world_.materials.push_back(no_material());
        world_.media.push_back(medium);
    }

    void add(const scene::BurleyMaterial& material, const SourcePosition& position) {
        kernel::MediumRecord medium{};
        set_refraction(material.refraction, medium, position);
        world_.has_transparency = world_.has_transparency || (!material.thin && material.transmission.most() > 0.0);
        world_.materials.push_back(no_material());
        world_.media.push_back(medium);
    }

    // What fills a body of a mix: that of the first of its parts that lets light in.
    kernel::MediumRecord medium_of(int number, int depth) const {
        const auto at = static_cast<std::size_t>(number);
        const auto* mix = std::get_if<scene::MixMaterial>(&scene_.materials[at].model);
        if (!mix || depth > 32) {
            return world_.media[at];
        }
        const kernel::MediumRecord first = medium_of(mix->first, depth + 1);
        return first.refraction_a == kernel::vec3(0.0f) ? medium_of(mix->second, depth + 1) : first;
    }

    template <class Opaque>
    void add(const Opaque&, const SourcePosition&) {
        world_.materials.push_back(no_material());
        world_.media.push_back({});
    }

    static kernel::WhittedRecord no_material() {
        kernel::WhittedRecord record{};
        record.texture = -1;
        return record;
    }

    void set_refraction(double index, kernel::MediumRecord& medium, const SourcePosition&) {
        medium.refraction = kernel::REFRACTION_CAUCHY;
        medium.refraction_a = kernel::vec3(static_cast<float>(index), 0.0f, 0.0f);
    }

    void set_refraction(const scene::AbbeGlass& glass, kernel::MediumRecord& medium, const SourcePosition&) {
        // n = a + b / L^2 through two of its own values.
        const double f_line = 486.1327;
        const double c_line = 656.2725;
        const double n_f = abbe_index(glass.index, glass.abbe_number, f_line);
        const double n_c = abbe_index(glass.index, glass.abbe_number, c_line);
        const double b = (n_f - n_c) / (1.0 / (f_line * f_line) - 1.0 / (c_line * c_line));
        medium.refraction = kernel::REFRACTION_CAUCHY;
        medium.refraction_a = to_float({n_f - b / (f_line * f_line), b, 0.0});
        medium.dispersive = b != 0.0 ? 1 : 0;
    }

    void set_refraction(const scene::SellmeierGlass& glass, kernel::MediumRecord& medium, const SourcePosition&) {
        medium.refraction = kernel::REFRACTION_SELLMEIER;
        medium.refraction_a = to_float(glass.b);
        medium.refraction_b = to_float(glass.c);
        medium.dispersive = 1;
    }

    void set_refraction(const scene::NamedGlass& glass, kernel::MediumRecord& medium, const SourcePosition& position) {
        if (const auto known = find_glass(glass.name)) {
            set_refraction(scene::SellmeierGlass{{known->b[0], known->b[1], known->b[2]}, {known->c[0], known->c[1], known->c[2]}}, medium,
                           position);
        } else {
            diagnostics_.error(position, fmt::format("no glass is called \"{}\"{}", glass.name, did_you_mean(glass.name, glass_names())));
        }
    }

    void set_refraction(const scene::MeasuredSpectrum& measured, kernel::MediumRecord& medium, const SourcePosition&) {
        medium.refraction = kernel::REFRACTION_CURVE;
        medium.curve = colors_.add_curve(SpectralCurve(measured.nanometres, measured.values, SpectralCurve::Beyond::constant));
        medium.dispersive = measured.values.size() > 1 ? 1 : 0;
    }

    const scene::Scene& scene_;
    World& world_;
    Textures& textures_;
    Colors& colors_;
    Diagnostics& diagnostics_;
};

}  // namespace

void compile_materials(const scene::Scene& scene, World& world, Textures& textures, Colors& colors, Diagnostics& diagnostics) {
    Materials(scene, world, textures, colors, diagnostics).compile();
}

}  // namespace lancer
