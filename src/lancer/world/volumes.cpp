#include "lancer/world/volumes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "lancer/kernel/spectrum.h"
#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/observer.h"
#include "lancer/spectrum/sensor.h"

#include "lancer/world/grids.h"
#include "lancer/world/spectra.h"

namespace lancer {

namespace {

constexpr double largest_asymmetry = 0.999;

bool is_zero(const scene::Color& color) {
    if (color.spectrum) {
        return !(reflectance_curve(*color.spectrum).highest() > 0.0);
    }
    return !(std::max({color.rgb.x, color.rgb.y, color.rgb.z}) > 0.0);
}

scene::Color scaled(const scene::Color& color, double factor) {
    if (!color.spectrum) {
        return color.rgb * factor;
    }
    scene::Spectrum spectrum = *color.spectrum;
    spectrum.scale *= factor;
    return spectrum;
}

class Volumes {
public:
    Volumes(const scene::Scene& scene, World& world, Colors& colors, Diagnostics& diagnostics)
        : scene_(scene), world_(world), colors_(colors), diagnostics_(diagnostics), numbers_(scene.media.size(), -1) {}

    void compile() {
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
            const scene::Material& material = scene_.materials[i];
            world_.has_media = world_.has_media || std::holds_alternative<scene::NullMaterial>(material.model);
            world_.has_priorities = world_.has_priorities || material.priority != scene_.materials.front().priority;
            if (const std::optional<int> interior = interior_of(material, 0)) {
                fill(i, scene_.media[static_cast<std::size_t>(*interior)], *interior);
            }
        }
        if (scene_.medium) {
            world_.surrounding_volume = number_of(*scene_.medium);
        }
        world_.has_media = world_.has_media || world_.has_priorities || !world_.volumes.empty();
    }

private:
    // A mix without one has that of the first of its parts that has one.
    std::optional<int> interior_of(const scene::Material& material, int depth) const {
        const auto* mix = std::get_if<scene::MixMaterial>(&material.model);
        if (material.interior || mix == nullptr || depth > 32) {
            return material.interior;
        }
        const auto first = interior_of(scene_.materials[static_cast<std::size_t>(mix->first)], depth + 1);
        return first ? first : interior_of(scene_.materials[static_cast<std::size_t>(mix->second)], depth + 1);
    }

    void fill(std::size_t material, const scene::Medium& medium, int number) {
        kernel::MaterialRecord& surface = world_.surfaces[material];
        if ((surface.flags & kernel::MATERIAL_PANE) != 0 && (surface.flags & kernel::MATERIAL_CUT) == 0) {
            surface.flags |= kernel::MATERIAL_BOUNDS;
            world_.has_media = true;
        } else if (surface.kind == kernel::BSDF_THIN_DIELECTRIC) {
            return;  // it has no inside
        }
        if (surface.clear_distance > 0.0f) {
            diagnostics_.error(scene_.materials[material].position, "a material has either an absorption of its own or an interior medium");
            return;
        }
        if (const auto absorption = mere_absorption(medium)) {
            set_clearness(*absorption, colors_, surface);
        } else {
            world_.media[material].volume = number_of(number);
        }
        world_.has_transparency = true;
    }

    // In 1/m, of a medium that does nothing else.
    static std::optional<scene::Color> mere_absorption(const scene::Medium& medium) {
        const bool emits = medium.emission_strength > 0.0 && (!is_dark(medium.emission) || medium.temperature);
        if (emits || medium.density || medium.albedo) {
            return std::nullopt;
        }
        if (const auto* parts = std::get_if<scene::AbsorbingScattering>(&medium.coefficients)) {
            return is_zero(parts->scattering) ? std::optional(scaled(parts->absorption, medium.scale)) : std::nullopt;
        }
        const auto& sum = std::get<scene::ExtinctionAlbedo>(medium.coefficients);
        return is_zero(sum.albedo) ? std::optional(scaled(sum.extinction, medium.scale)) : std::nullopt;
    }

    static bool is_dark(const scene::Color& light) { return !light.spectrum && !(std::max({light.rgb.x, light.rgb.y, light.rgb.z}) > 0.0); }

    int number_of(int medium) {
        int& number = numbers_[static_cast<std::size_t>(medium)];
        if (number < 0) {
            const kernel::VolumeRecord record = compile(scene_.media[static_cast<std::size_t>(medium)]);
            number = static_cast<int>(world_.volumes.size());
            world_.volumes.push_back(record);
        }
        return number;
    }

    kernel::VolumeRecord compile(const scene::Medium& medium) {
        kernel::VolumeRecord record{};
        record.grid = record.albedo_grid = record.temperature_grid = -1;
        bool scatters = false;
        if (const auto* parts = std::get_if<scene::AbsorbingScattering>(&medium.coefficients)) {
            record.first = colors_.quantity(parts->absorption, medium.scale);
            record.second = colors_.quantity(parts->scattering, medium.scale);
            scatters = !is_zero(parts->scattering);
        } else {
            const auto& sum = std::get<scene::ExtinctionAlbedo>(medium.coefficients);
            record.first = colors_.quantity(sum.extinction, medium.scale);
            record.second = colors_.reflectance(sum.albedo);
            record.flags |= kernel::VOLUME_HAS_ALBEDO;
            scatters = !is_zero(sum.albedo) || medium.albedo.has_value();
        }
        record.flags |= scatters ? kernel::VOLUME_SCATTERS : 0;
        record.phase = medium.phase == scene::Phase::rayleigh ? kernel::PHASE_RAYLEIGH : kernel::PHASE_HENYEY_GREENSTEIN;
        record.asymmetry = static_cast<float>(std::clamp(medium.asymmetry, -largest_asymmetry, largest_asymmetry));
        if (medium.density) {
            record.grid = grid(*medium.density, medium);
        }
        if (medium.albedo) {
            record.albedo_grid = grid(*medium.albedo, medium);
            if ((record.flags & kernel::VOLUME_HAS_ALBEDO) == 0) {
                diagnostics_.error(medium.position, "an albedo in a grid needs an extinction, and no absorption and scattering");
            }
        }
        set_emission(medium, record);
        if (record.grid < 0 && (record.albedo_grid >= 0 || record.temperature_grid >= 0)) {
            diagnostics_.error(medium.position, "a medium whose albedo or temperature is a grid needs a density that is one, too");
        }
        return record;
    }

    void set_emission(const scene::Medium& medium, kernel::VolumeRecord& record) {
        record.emission = colors_.constant(0.0);
        if (!(medium.emission_strength > 0.0) || is_dark(medium.emission)) {
            return;
        }
        record.flags |= kernel::VOLUME_EMITS;
        if (!medium.temperature) {
            record.emission = colors_.light(medium.emission, medium.emission_strength);
            return;
        }
        record.emission = colors_.quantity(medium.emission, medium.emission_strength);
        record.temperature_grid = grid(*medium.temperature, medium);
        const std::vector<float>& kelvins = medium.temperature->data->values;
        const double hottest = static_cast<double>(*std::max_element(kelvins.begin(), kelvins.end()));
        if (medium.temperature->data->channels != 1) {
            diagnostics_.error(medium.position, "temperatures are a grid of one channel");
        }
        heat(std::max(hottest, 1.0), record);
    }

    // Black bodies from 0 K to the hottest, in W/(m^2 sr) weighed by the eye: 1 at every wavelength has luminance 1.
    void heat(double hottest, kernel::VolumeRecord& record) {
        record.heat = static_cast<int>(world_.spectral ? world_.curves.size() / kernel::WAVELENGTH_COUNT : world_.voxels.size());
        record.heat_steps = static_cast<float>((kernel::HEAT_ENTRIES - 1) / hottest);
        for (int i = 0; i < kernel::HEAT_ENTRIES; ++i) {
            const double kelvin = hottest * i / (kernel::HEAT_ENTRIES - 1);
            const SpectralCurve light = i == 0 ? SpectralCurve(0.0) : blackbody(kelvin).scaled(cie_1931_area());
            if (world_.spectral) {
                colors_.add_curve(light);
            } else {
                const scene::Rgb rgb = glm::max(to_rgb(light), scene::Rgb(0.0));
                for (int channel = 0; channel < 3; ++channel) {
                    world_.voxels.push_back(static_cast<float>(rgb[channel]));
                }
            }
        }
    }

    int grid(const scene::Grid& grid, const scene::Medium& medium) {
        if (const auto found = grids_.find(&grid); found != grids_.end()) {
            return found->second;
        }
        const int number = compile_grid(grid, medium.position, world_, diagnostics_);
        grids_[&grid] = number;
        return number;
    }

    const scene::Scene& scene_;
    World& world_;
    Colors& colors_;
    Diagnostics& diagnostics_;
    std::vector<int> numbers_;  // of the media that have been compiled
    std::map<const scene::Grid*, int> grids_;
};

}  // namespace

void compile_volumes(const scene::Scene& scene, World& world, Colors& colors, Diagnostics& diagnostics) {
    Volumes(scene, world, colors, diagnostics).compile();
}

}  // namespace lancer
