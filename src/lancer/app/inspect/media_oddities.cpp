#include "lancer/app/inspect/media_oddities.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "lancer/scene/bounds.h"
#include "lancer/world/flatten.h"
#include "lancer/world/spectra.h"

namespace lancer::app {

namespace {

constexpr double densest = 1e5;  // 1/m; milk and skin have some thousands

double most_of(const scene::Color& color) {
    if (color.spectrum) {
        return reflectance_curve(*color.spectrum).highest();
    }
    return std::max({color.rgb.x, color.rgb.y, color.rgb.z});
}

bool shines(const scene::Color& color) { return color.spectrum || most_of(color) > 0.0; }

struct Sums {
    double extinction = 0.0;  // 1/m, at most
    bool absorbs = false;
};

Sums sums_of(const scene::Medium& medium) {
    Sums sums;
    if (const auto* parts = std::get_if<scene::AbsorbingScattering>(&medium.coefficients)) {
        sums.extinction = most_of(parts->absorption) + most_of(parts->scattering);
        sums.absorbs = most_of(parts->absorption) > 0.0;
    } else {
        const auto& sum = std::get<scene::ExtinctionAlbedo>(medium.coefficients);
        sums.extinction = most_of(sum.extinction);
        const scene::Rgb& albedo = sum.albedo.rgb;
        sums.absorbs = sum.albedo.spectrum || medium.albedo || std::min({albedo.x, albedo.y, albedo.z}) < 1.0;
    }
    if (medium.density) {
        const auto& values = medium.density->data->values;
        sums.extinction *= values.empty() ? 0.0 : static_cast<double>(*std::max_element(values.begin(), values.end()));
    }
    sums.extinction *= medium.scale;
    return sums;
}

class MediaOddities {
public:
    MediaOddities(const scene::Scene& scene, Diagnostics& diagnostics)
        : scene_(scene), diagnostics_(diagnostics), objects_(flatten(scene)) {}

    void find() {
        for (std::size_t i = 0; i < scene_.media.size(); ++i) {
            look_at(scene_.media[i], static_cast<int>(i));
        }
        for (const scene::Material& material : scene_.materials) {
            if (std::holds_alternative<scene::NullMaterial>(material.model) && !material.interior && !material.name.empty()) {
                diagnostics_.warning(
                    material.position,
                    fmt::format("material \"{}\" is a null border without an interior: nothing is seen of it", material.name));
            }
        }
    }

private:
    void look_at(const scene::Medium& medium, int number) {
        const auto warn = [&](const std::string& problem) {
            diagnostics_.warning(medium.position, fmt::format("medium \"{}\" {}", medium.name, problem));
        };
        const Sums sums = sums_of(medium);
        if (!(sums.extinction > 0.0)) {
            warn("does nothing: it neither absorbs nor scatters");
            return;
        }
        if (sums.extinction > densest) {
            warn(fmt::format("has an extinction of {:.3g} per metre: were millimetres taken for metres?", sums.extinction));
        }
        if (shines(medium.emission) && !sums.absorbs) {
            warn("shines but absorbs nothing: it emits as much as it absorbs, nothing");
        }
        if (scene_.medium == number && !medium.density && light_comes_from_far()) {
            warn(
                "is everywhere, and no light of the sky or a directional light gets through so much of it: close it in with a null border");
        }
        if (medium.density && scene_.medium != number && !is_reached(*medium.density, number)) {
            warn("has a grid that lies outside of all that it fills");
        }
    }

    bool light_comes_from_far() const {
        const scene::Background& sky = scene_.background;
        const bool bright = sky.image || shines(sky.zenith) || shines(sky.horizon) || shines(sky.nadir);
        return bright || std::any_of(scene_.lights.begin(), scene_.lights.end(), [](const scene::Light& light) {
                   return std::holds_alternative<scene::DirectionalLight>(light.model);
               });
    }

    bool is_reached(const scene::Grid& grid, int number) const {
        scene::Bounds unit;
        unit.low = glm::dvec3(0.0);
        unit.high = glm::dvec3(1.0);
        const scene::Bounds box = scene::transform(grid.to_world, unit);
        return std::any_of(objects_.begin(), objects_.end(), [&](const FlatObject& flat) {
            if (scene_.materials[static_cast<std::size_t>(flat.material)].interior != number) {
                return false;
            }
            if (std::holds_alternative<scene::Plane>(flat.object->shape)) {
                return true;
            }
            const scene::Bounds body = scene::transform(flat.to_world, scene::bounds(flat.object->shape));
            return glm::all(glm::lessThan(body.low, box.high)) && glm::all(glm::lessThan(box.low, body.high));
        });
    }

    const scene::Scene& scene_;
    Diagnostics& diagnostics_;
    std::vector<FlatObject> objects_;
};

}  // namespace

void find_media_oddities(const scene::Scene& scene, Diagnostics& diagnostics) { MediaOddities(scene, diagnostics).find(); }

}  // namespace lancer::app
