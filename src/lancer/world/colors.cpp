#include <algorithm>
#include <cmath>
#include <vector>

#include "lancer/kernel/spectrum.h"
#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/upsample.h"
#include "lancer/world/spectra.h"
#include "lancer/world/surfaces.h"

namespace lancer {

namespace {

kernel::ColorRecord no_color() {
    kernel::ColorRecord record{};
    record.scale = 1.0f;
    record.curve = -1;
    record.illuminant = -1;
    record.texture = -1;
    return record;
}

// Means around each nanometre: a measured light may end or jump anywhere.
SpectralCurve means(const SpectralCurve& curve) {
    constexpr int parts = 32;
    std::vector<double> nanometres, values;
    for (int i = 0; i < kernel::WAVELENGTH_COUNT; ++i) {
        nanometres.push_back(static_cast<double>(kernel::FIRST_WAVELENGTH) + i);
        double sum = 0.0;
        for (int j = 0; j < parts; ++j) {
            sum += curve.at(nanometres.back() - 0.5 + (j + 0.5) / parts);
        }
        values.push_back(sum / parts);
    }
    return SpectralCurve(nanometres, values, SpectralCurve::Beyond::zero);
}

}  // namespace

int Colors::add_curve(const SpectralCurve& curve) {
    const int number = static_cast<int>(world_.curves.size()) / kernel::WAVELENGTH_COUNT;
    for (const double value : curve.on(fine_grid)) {
        world_.curves.push_back(static_cast<float>(value));
    }
    return number;
}

kernel::ColorRecord Colors::constant(double value) {
    // A smooth spectrum of coefficients 0 is 1/2 everywhere.
    kernel::ColorRecord record = no_color();
    record.rgb = kernel::vec3(static_cast<float>(value));
    record.scale = static_cast<float>(2.0 * value);
    return record;
}

kernel::ColorRecord Colors::reflectance(const scene::Color& color) {
    if (color.spectrum) {
        return curve(reflectance_curve(*color.spectrum), glm::min(reflected(color), scene::Rgb(1.0)));
    }
    kernel::ColorRecord record = no_color();
    record.rgb = kernel::vec3(color.rgb);
    record.coefficients = kernel::vec3(smooth_reflectance(color.rgb).coefficients);
    return record;
}

kernel::ColorRecord Colors::reflectance(const CompiledTexture& texture) {
    kernel::ColorRecord record = reflectance(texture.color);
    record.texture = texture.number;
    return record;
}

kernel::ColorRecord Colors::quantity(const scene::Color& color, double scale) {
    if (color.spectrum) {
        return curve(reflectance_curve(*color.spectrum).scaled(scale), reflected(color) * scale);
    }
    const SmoothLight smooth = smooth_light(color.rgb * scale);
    kernel::ColorRecord record = no_color();
    record.rgb = kernel::vec3(color.rgb * scale);
    record.coefficients = kernel::vec3(smooth.shape.coefficients);
    record.scale = static_cast<float>(smooth.scale);
    return record;
}

kernel::ColorRecord Colors::light(const scene::Color& color, double strength) {
    if (color.spectrum) {
        return curve(means(light_curve(*color.spectrum).scaled(strength)), emitted(color) * strength);
    }
    const scene::Rgb rgb = color.rgb * strength;
    if (daylight_ < 0 && world_.spectral) {
        daylight_ = add_curve(unit_d65());
    }
    const SmoothLight light = smooth_light(rgb);
    kernel::ColorRecord record = no_color();
    record.rgb = kernel::vec3(rgb);
    record.coefficients = kernel::vec3(light.shape.coefficients);
    record.scale = static_cast<float>(light.scale);
    record.illuminant = daylight_;
    return record;
}

kernel::ColorRecord Colors::light(const CompiledTexture& texture, double strength) {
    if (texture.number < 0) {
        return light(texture.color, strength);
    }
    kernel::ColorRecord record = light(scene::Color(scene::Rgb(1.0)));
    record.texture = texture.number;
    record.scale = static_cast<float>(strength);
    return record;
}

kernel::ColorRecord Colors::curve(const SpectralCurve& curve, const scene::Rgb& rgb) {
    kernel::ColorRecord record = no_color();
    record.rgb = kernel::vec3(rgb);
    record.curve = world_.spectral ? add_curve(curve) : -1;
    return record;
}

}  // namespace lancer
