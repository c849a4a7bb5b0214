#include "lancer/import/pbrt/media.h"

#include <algorithm>

#include <fmt/format.h>

#include "lancer/import/pbrt/spectra.h"

namespace lancer::pbrt {

namespace {

class Media {
public:
    Media(const Recipe& recipe, const std::string& name, const glm::dmat4& to_scene, double brightness)
        : recipe_(recipe), parameters_(recipe.parameters), to_scene_(to_scene), brightness_(brightness),
          owner_(fmt::format("MakeNamedMedium \"{}\"", name)) {
        medium_.name = name;
        medium_.position = parameters_.position();
    }

    std::optional<scene::Medium> build() {
        const std::string type = parameters_.string("type", "homogeneous");
        bool good = true;
        if (type == "homogeneous") {
            set_coefficients();
        } else if (type == "uniformgrid" || type == "heterogeneous") {
            set_coefficients();
            medium_.density = grid("density", 1);
            good = medium_.density.has_value();
        } else if (type == "rgbgrid") {
            good = set_colored_grids();
        } else {
            parameters_.context().report.dropped(fmt::format("{} of type \"{}\"", owner_, type), "such grids are not read",
                                                 parameters_.position());
            return std::nullopt;
        }
        medium_.scale = parameters_.number("scale", 1.0);
        medium_.asymmetry = std::clamp(parameters_.number("g", 0.0), -0.999, 0.999);
        set_emission();
        if (good) {
            parameters_.context().report.honoured(owner_, parameters_.position());
        }
        return good ? std::optional(medium_) : std::nullopt;
    }

private:
    scene::Color coefficient(std::string_view name, const scene::Rgb& otherwise) {
        const Parameter* parameter = parameters_.find(name);
        if (parameter == nullptr) {
            return otherwise;
        }
        if (parameter->type == "rgb") {
            const std::vector<double> numbers = parameters_.numbers_of(*parameter);
            return numbers.size() == 3 ? scene::Rgb(glm::max(glm::dvec3(numbers[0], numbers[1], numbers[2]), 0.0)) : otherwise;
        }
        const auto curve = read_curve(parameters_, *parameter, recipe_.space);
        if (!curve) {
            return otherwise;
        }
        return scene::Spectrum{scene::MeasuredSpectrum{curve->nanometres(), curve->values()}, 1.0, std::nullopt};
    }

    void set_coefficients() {
        if (parameters_.has("preset")) {
            parameters_.context().report.approximated(owner_ + ": \"preset\"", "what \"sigma_a\" and \"sigma_s\" say",
                                                      parameters_.position());
        }
        const bool written = parameters_.has("sigma_a") || parameters_.has("sigma_s");
        const bool grid = parameters_.string("type", "homogeneous") != "homogeneous";
        // pbrt's own where nothing is written.
        const scene::Rgb absorption = grid ? scene::Rgb(1.0) : written ? scene::Rgb(0.0) : scene::Rgb(0.0011, 0.0024, 0.014);
        const scene::Rgb scattering = grid ? scene::Rgb(1.0) : written ? scene::Rgb(0.0) : scene::Rgb(2.55, 3.21, 3.77);
        medium_.coefficients = scene::AbsorbingScattering{coefficient("sigma_a", absorption), coefficient("sigma_s", scattering)};
    }

    std::optional<glm::ivec3> cells() {
        const glm::ivec3 size(parameters_.integer("nx", 1), parameters_.integer("ny", 1), parameters_.integer("nz", 1));
        if (size.x < 1 || size.y < 1 || size.z < 1) {
            parameters_.context().diagnostics.error(parameters_.position(), owner_ + " has no cells");
            return std::nullopt;
        }
        return size;
    }

    std::optional<scene::Grid> grid(std::string_view name, int channels) {
        const Parameter* parameter = parameters_.find(name);
        const auto size = cells();
        if (parameter == nullptr || !size) {
            return std::nullopt;
        }
        const std::vector<double> numbers = parameters_.numbers_of(*parameter);
        const double count = static_cast<double>(size->x) * size->y * size->z * channels;
        if (static_cast<double>(numbers.size()) != count) {
            parameters_.error(*parameter,
                              fmt::format("\"{}\" has {} values, not {} as \"nx\", \"ny\" and \"nz\" say", name, numbers.size(), count));
            return std::nullopt;
        }
        auto data = std::make_shared<scene::VoxelData>();
        data->size = *size;
        data->channels = channels;
        for (const double number : numbers) {
            data->values.push_back(static_cast<float>(std::max(number, 0.0)));
        }
        return scene::Grid{data, to_scene_ * box(), true};
    }

    glm::dmat4 box() {
        const glm::dvec3 low = parameters_.triple("p0").value_or(glm::dvec3(0.0)),
                         high = parameters_.triple("p1").value_or(glm::dvec3(1.0));
        glm::dmat4 map(1.0);
        for (int axis = 0; axis < 3; ++axis) {
            map[axis][axis] = high[axis] - low[axis];
            map[3][axis] = low[axis];
        }
        return map;
    }

    // Absorption and scattering in colours: their sum as the density of a medium of extinction 1, and what share of it is scattering.
    bool set_colored_grids() {
        const std::optional<scene::Grid> absorption = grid("sigma_a", 3), scattering = grid("sigma_s", 3);
        if (!absorption && !scattering) {
            return false;
        }
        scene::Grid density = absorption ? *absorption : *scattering;
        auto sums = std::make_shared<scene::VoxelData>(*density.data);
        auto shares = std::make_shared<scene::VoxelData>(*density.data);
        for (std::size_t i = 0; i < sums->values.size(); ++i) {
            const float turned = scattering ? scattering->data->values[i] : 0.0f;
            sums->values[i] = turned + (absorption ? absorption->data->values[i] : 0.0f);
            shares->values[i] = sums->values[i] > 0.0f ? turned / sums->values[i] : 0.0f;
        }
        scene::Grid albedo = density;
        density.data = sums;
        albedo.data = shares;
        albedo.fades = false;
        medium_.coefficients = scene::ExtinctionAlbedo{scene::Rgb(1.0), scene::Rgb(0.0)};
        medium_.density = density;
        medium_.albedo = albedo;
        return true;
    }

    void set_emission() {
        if (const Parameter* light = parameters_.find("Le")) {
            medium_.emission = read_light(parameters_, *light, recipe_.space, false).value_or(scene::Color());
            medium_.emission_strength = brightness_;
            const Parameter* scale = parameters_.find("Lescale");
            if (scale != nullptr) {
                const std::vector<double> numbers = parameters_.numbers_of(*scale);
                medium_.emission_strength *= numbers.size() == 1 ? numbers[0] : 1.0;
                if (numbers.size() > 1) {
                    parameters_.context().report.approximated(owner_ + ": \"Lescale\"", "as bright everywhere", parameters_.position());
                }
            }
        }
        if (parameters_.has("temperature")) {
            parameters_.context().report.dropped(owner_ + ": \"temperature\"", "it does not glow", parameters_.position());
        }
        parameters_.pass_over({"type", "Lescale", "temperature", "temperaturescale", "temperatureoffset"});
    }

    const Recipe& recipe_;
    const Parameters& parameters_;
    glm::dmat4 to_scene_;
    double brightness_;
    std::string owner_;
    scene::Medium medium_;
};

}  // namespace

std::optional<scene::Medium> build_medium(const Recipe& recipe, const std::string& name, const glm::dmat4& to_scene, double brightness) {
    return Media(recipe, name, to_scene, brightness).build();
}

}  // namespace lancer::pbrt
