#include "lancer/world/materials.h"

#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "lancer/image/image.h"
#include "lancer/spectrum/glass.h"
#include "lancer/spectrum/observer.h"

namespace lancer {

namespace {

kernel::vec3 to_float(const glm::dvec3& v) { return kernel::vec3(v); }

struct Texels {
    int first = 0;
    int width = 0;
    int height = 0;
};

class Materials {
public:
    Materials(const scene::Scene& scene, World& world, Diagnostics& diagnostics)
        : scene_(scene), world_(world), diagnostics_(diagnostics) {}

    void compile() {
        bool disperses = false;
        for (const scene::Material& material : scene_.materials) {
            std::visit([&](const auto& model) { add(model, material.position); }, material.model);
            disperses = disperses || world_.media.back().dispersive != 0;
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
        record.texture = -1;
        record.color = kernel::vec3(1.0f);
        std::visit([&](const auto& texture) { set_color(texture, record); }, material.color);
        record.ambient = static_cast<float>(material.ambient);
        record.diffuse = static_cast<float>(material.diffuse);
        record.highlight = static_cast<float>(material.highlight);
        record.shininess = static_cast<float>(material.shininess);
        record.reflectivity = static_cast<float>(material.reflectivity);
        record.transparency = static_cast<float>(material.transparency);
        kernel::MediumRecord medium{};
        medium.absorption = to_float(material.absorption);
        std::visit([&](const auto& refraction) { set_refraction(refraction, medium, position); }, material.refraction);
        world_.has_transparency = world_.has_transparency || material.transparency > 0.0;
        world_.materials.push_back(record);
        world_.media.push_back(medium);
    }

    void set_color(const scene::Rgb& color, kernel::WhittedRecord& record) { record.color = to_float(color); }

    void set_color(const scene::Checker& checker, kernel::WhittedRecord& record) {
        kernel::TextureRecord texture{};
        texture.kind = checker.solid ? kernel::TEXTURE_CHECKER_SOLID : kernel::TEXTURE_CHECKER_UV;
        texture.first = to_float(checker.first);
        texture.second = to_float(checker.second);
        texture.size = static_cast<float>(checker.size);
        add_texture(texture, record);
    }

    void set_color(const scene::ImageTexture& image, kernel::WhittedRecord& record) {
        kernel::TextureRecord texture{};
        texture.kind = kernel::TEXTURE_IMAGE;
        const Texels texels = load(image);
        texture.first_texel = texels.first;
        texture.width = texels.width;
        texture.height = texels.height;
        texture.size = 1.0f;
        texture.wrap = image.wrap == scene::Wrap::repeat  ? kernel::WRAP_REPEAT
                       : image.wrap == scene::Wrap::clamp ? kernel::WRAP_CLAMP
                                                          : kernel::WRAP_MIRROR;
        texture.nearest = image.filter == scene::Filter::nearest ? 1 : 0;
        texture.scale = kernel::vec2(image.scale);
        texture.offset = kernel::vec2(image.offset);
        add_texture(texture, record);
    }

    void add_texture(const kernel::TextureRecord& texture, kernel::WhittedRecord& record) {
        record.texture = static_cast<int>(world_.textures.size());
        world_.textures.push_back(texture);
    }

    // Each file is read once, however many materials use it.
    Texels load(const scene::ImageTexture& image) {
        const auto key = std::make_pair(image.file, image.linear);
        if (const auto known = images_.find(key); known != images_.end()) {
            return known->second;
        }
        Texels texels{0, 1, 1};
        try {
            const Image pixels = read_image(image.file, image.linear ? Encoding::linear : Encoding::automatic);
            texels = {static_cast<int>(world_.texels.size()), pixels.width, pixels.height};
            const std::size_t count = static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height);
            if (world_.texels.size() + count > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
                throw std::runtime_error("the scene's images together have more than 2147483647 pixels");
            }
            const auto channels = static_cast<std::size_t>(pixels.channels);
            const std::size_t colors = channels >= 3 ? 3 : 1;
            world_.texels.reserve(world_.texels.size() + count);
            for (std::size_t i = 0; i < count; ++i) {
                const float* p = &pixels.pixels[i * channels];
                world_.texels.push_back(colors == 3 ? kernel::vec3(p[0], p[1], p[2]) : kernel::vec3(p[0]));
            }
        } catch (const std::runtime_error& problem) {
            diagnostics_.error(image.position, problem.what());
        }
        images_[key] = texels;
        return texels;
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

    const scene::Scene& scene_;
    World& world_;
    Diagnostics& diagnostics_;
    std::map<std::pair<std::string, bool>, Texels> images_;
};

}  // namespace

void compile_materials(const scene::Scene& scene, World& world, Diagnostics& diagnostics) {
    Materials(scene, world, diagnostics).compile();
}

}  // namespace lancer
