// Media, and the grids of numbers that some of them have.
#include <fmt/format.h>

#include "lancer/import/toml/write_context.h"

namespace lancer::notation {

namespace {

const char* word(scene::Phase phase) {
    switch (phase) {
        case scene::Phase::henyey_greenstein:
            return "henyey-greenstein";
        case scene::Phase::rayleigh:
            return "rayleigh";
    }
    return "";
}

// Its numbers in a file of their own.
std::string write_grid(WriteContext& context, const scene::Grid& grid) {
    const auto& [data, to_world, fades] = grid;
    const auto& [size, channels, values] = *data;
    const auto [known, is_new] = context.voxels.try_emplace(data.get());
    if (is_new) {
        known->second = fmt::format("{}-{}.raw", context.stem, context.voxels.size());
        auto bytes = std::make_shared<std::string>(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
        context.result.pictures.push_back({known->second, std::move(bytes)});
    }
    Fields fields;
    fields.text("file", known->second);
    fields.raw("cells", fmt::format("[{}, {}, {}]", size.x, size.y, size.z));
    fields.number("channels", channels);
    fields.raw("fades", fades ? "true" : "false");
    add_transform(fields, to_world);
    return fields.braces();
}

}  // namespace

std::string write_medium(WriteContext& context, const scene::Medium& medium, const std::string& written_name, bool everywhere) {
    const auto& [name, coefficients, scale, phase, asymmetry, emission, emission_strength, density, albedo, temperature, position] = medium;
    static_cast<void>(name), static_cast<void>(position);
    const scene::Color black;
    Fields fields;
    if (const auto* apart = std::get_if<scene::AbsorbingScattering>(&coefficients)) {
        const auto& [absorption, scattering] = *apart;
        add_color(fields, "absorption", absorption, black);
        add_color(fields, "scattering", scattering, black);
    } else {
        const auto& [extinction, share] = std::get<scene::ExtinctionAlbedo>(coefficients);
        fields.raw("extinction", write_color(extinction));
        if (!albedo) {
            fields.raw("albedo", write_color(share));
        }
    }
    fields.number("scale", scale, 1.0);
    fields.text("phase", word(phase), word(scene::Phase::henyey_greenstein));
    if (phase == scene::Phase::henyey_greenstein) {
        fields.number("asymmetry", asymmetry, 0.0);
    }
    add_color(fields, "emission", emission, scene::Rgb(temperature ? 1.0 : 0.0));
    fields.number("emission_strength", emission_strength, 1.0);
    if (density) {
        fields.raw("density", write_grid(context, *density));
    }
    if (albedo) {
        fields.raw("albedo_grid", write_grid(context, *albedo));
    }
    if (temperature) {
        fields.raw("temperature", write_grid(context, *temperature));
    }
    fields.flag("everywhere", everywhere, false);
    return fmt::format("\n[medium.{}]\n{}", key_text(written_name), fields.lines());
}

}  // namespace lancer::notation
