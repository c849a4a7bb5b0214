// Materials as tables of the notation.
#include <fmt/format.h>

#include "lancer/import/toml/write_context.h"

namespace lancer::notation {

namespace {

const scene::Color black{};

const char* word(scene::Facets::Distribution distribution) {
    switch (distribution) {
        case scene::Facets::Distribution::ggx:
            return "ggx";
        case scene::Facets::Distribution::beckmann:
            return "beckmann";
    }
    return "";
}

void write_facets(Fields& fields, const scene::Facets& facets) {
    const auto& [distribution, separate, once] = facets;
    fields.text("facets", word(distribution), word(scene::Facets{}.distribution));
    fields.text("facet_shadows", separate ? "separate" : "correlated", "correlated");
    fields.text("facet_light", once ? "lost" : "kept", "kept");
}

std::string write_index(const scene::Index& index) {
    return std::visit(Overloaded{[](const scene::MeasuredSpectrum& curve) { return write_curve(curve); },
                                 [](const scene::Rgb& rgb) { return list_text(rgb); }},
                      index);
}

void write_model(Fields& fields, WriteContext& context, const scene::WhittedMaterial& model) {
    const auto& [color, ambient, diffuse, highlight, shininess, reflectivity, transparency, refraction, absorption] = model;
    const scene::WhittedMaterial preset{};
    add_texture(fields, "color", context, color, std::get<scene::Color>(preset.color));
    fields.number("ambient", ambient, preset.ambient);
    fields.number("diffuse", diffuse, preset.diffuse);
    fields.number("highlight", highlight, preset.highlight);
    fields.number("shininess", shininess, preset.shininess);
    fields.number("reflectivity", reflectivity, preset.reflectivity);
    fields.number("transparency", transparency, preset.transparency);
    fields.raw("refraction", write_refraction(refraction));
    add_color(fields, "absorption", absorption, black);
}

void write_model(Fields& fields, WriteContext& context, const scene::DiffuseMaterial& model) {
    const auto& [color, roughness] = model;
    fields.text("type", "diffuse");
    add_texture(fields, "color", context, color, scene::Rgb(0.8));
    add_value(fields, "roughness", context, roughness, 0.0);
}

void write_model(Fields& fields, WriteContext& context, const scene::ConductorMaterial& model) {
    const auto& [metal, color, roughness, anisotropy, n, k, facets] = model;
    fields.text("type", "conductor");
    // A metal's name is meant where there is one, and its index has no effect then.
    if (!metal.empty()) {
        fields.text("metal", metal);
    } else if (n && k) {
        fields.raw("n", write_index(*n));
        fields.raw("k", write_index(*k));
    }
    add_texture(fields, "color", context, color, scene::Rgb(1.0));
    add_value(fields, "roughness", context, roughness, 0.0);
    add_value(fields, "anisotropy", context, anisotropy, 0.0);
    write_facets(fields, facets);
}

void write_model(Fields& fields, WriteContext& context, const scene::DielectricMaterial& model) {
    const auto& [refraction, color, roughness, anisotropy, absorption, thin, facets] = model;
    fields.text("type", "dielectric");
    fields.raw("refraction", write_refraction(refraction));
    add_texture(fields, "color", context, color, scene::Rgb(1.0));
    add_value(fields, "roughness", context, roughness, 0.0);
    add_value(fields, "anisotropy", context, anisotropy, 0.0);
    add_color(fields, "absorption", absorption, black);
    fields.flag("thin", thin, false);
    write_facets(fields, facets);
}

void write_model(Fields& fields, WriteContext& context, const scene::PlasticMaterial& model) {
    const auto& [color, refraction, roughness, saturates, facets] = model;
    fields.text("type", "plastic");
    add_texture(fields, "color", context, color, scene::Rgb(0.8));
    fields.number("refraction", refraction, 1.5);
    add_value(fields, "roughness", context, roughness, 0.0);
    fields.flag("saturates", saturates, true);
    write_facets(fields, facets);
}

void write_model(Fields& fields, WriteContext& context, const scene::PrincipledMaterial& model) {
    const auto& [color, metalness, roughness, anisotropy, refraction, specular, transmission, thin, absorption, coat, coat_roughness, sheen,
                 sheen_roughness, film, film_refraction, dispersion, coat_relief, turn, smooth_along] = model;
    fields.text("type", "principled");
    add_texture(fields, "color", context, color, scene::Rgb(0.8));
    add_value(fields, "metalness", context, metalness, 0.0);
    add_value(fields, "roughness", context, roughness, 0.3);
    add_value(fields, "anisotropy", context, anisotropy, 0.0);
    fields.number("refraction", refraction, 1.5);
    add_texture(fields, "specular", context, specular, scene::Rgb(1.0));
    add_value(fields, "transmission", context, transmission, 0.0);
    fields.flag("thin", thin, false);
    add_color(fields, "absorption", absorption, black);
    add_value(fields, "coat", context, coat, 0.0);
    add_value(fields, "coat_roughness", context, coat_roughness, 0.0);
    add_texture(fields, "sheen", context, sheen, black);
    add_value(fields, "sheen_roughness", context, sheen_roughness, 0.3);
    add_value(fields, "film", context, film, 0.0);
    fields.number("film_refraction", film_refraction, 1.3);
    fields.number("dispersion", dispersion, 0.0);
    if (coat_relief) {
        const auto& [normals, scale] = *coat_relief;
        fields.flag("coat_smooth", !normals, false);
        if (normals) {
            fields.raw("coat_normal_map", write_texture(context, *normals));
            fields.number("coat_normal_scale", scale, 1.0);
        }
    }
    fields.number("turn", turn, 0.0);
    if (smooth_along) {
        fields.raw("smooth_along", write_texture(context, *smooth_along));
    }
}

void write_model(Fields& fields, WriteContext& context, const scene::BurleyMaterial& model) {
    const auto& [color, roughness, anisotropy, refraction, specular_tint, metalness, transmission, flatness, sheen, sheen_tint, coat,
                 coat_gloss, thin, passes] = model;
    fields.text("type", "burley");
    add_texture(fields, "color", context, color, scene::Rgb(0.5));
    add_value(fields, "roughness", context, roughness, 0.5);
    add_value(fields, "anisotropy", context, anisotropy, 0.0);
    fields.number("refraction", refraction, 1.5);
    fields.number("specular_tint", specular_tint, 0.0);
    add_value(fields, "metalness", context, metalness, 0.0);
    add_value(fields, "transmission", context, transmission, 0.0);
    fields.number("flatness", flatness, 0.0);
    add_value(fields, "sheen", context, sheen, 0.0);
    fields.number("sheen_tint", sheen_tint, 0.0);
    add_value(fields, "coat", context, coat, 0.0);
    fields.number("coat_gloss", coat_gloss, 0.0);
    fields.flag("thin", thin, false);
    add_value(fields, "passes", context, passes, 0.0);
}

void write_model(Fields& fields, WriteContext& context, const scene::MixMaterial& model) {
    const auto& [first, second, share] = model;
    fields.text("type", "mix");
    fields.text("first", context.material(first));
    fields.text("second", context.material(second));
    add_value(fields, "share", context, share, 0.5);
}

void write_model(Fields& fields, WriteContext&, const scene::NullMaterial&) { fields.text("type", "null"); }

void write_emission(Fields& fields, WriteContext& context, const scene::Emission& emission) {
    const auto& [radiance, strength, both_sides] = emission;
    fields.raw("emission", write_texture(context, radiance));
    fields.number("emission_strength", strength, 1.0);
    fields.text("emission_sides", both_sides ? "both" : "front", "front");
}

void write_relief(Fields& fields, WriteContext& context, const scene::Relief& relief) {
    const auto& [normals, scale, flips_green, heights, crosswise, shadows] = relief;
    if (normals) {
        fields.raw("normal_map", write_texture(context, *normals));
        fields.number("normal_scale", scale, 1.0);
        fields.flag("normal_flip_green", flips_green, false);
        fields.flag("normal_crosswise", crosswise, false);
    }
    if (heights) {
        fields.raw("bump", write_value(context, *heights));
    }
    if (normals || heights) {
        fields.flag("relief_shadows", shadows, false);
    }
}

}  // namespace

std::string write_material(WriteContext& context, const scene::Material& material, const std::string& written_name) {
    const auto& [name, model, position, emission, is_default, relief, opacity, opacity_cutoff, behind, one_sided, open_behind, interior,
                 priority] = material;
    static_cast<void>(name), static_cast<void>(position), static_cast<void>(is_default);
    Fields fields;
    std::visit([&](const auto& kind) { write_model(fields, context, kind); }, model);
    if (emission) {
        write_emission(fields, context, *emission);
    }
    write_relief(fields, context, relief);
    add_value(fields, "opacity", context, opacity, 1.0);
    fields.number("opacity_cutoff", opacity_cutoff, 0.0);
    if (behind) {
        fields.text("behind", context.material(*behind));
    }
    fields.flag("one_sided", one_sided, false);
    fields.flag("open_behind", open_behind, false);
    if (interior) {
        fields.text("interior", context.media[static_cast<std::size_t>(*interior)]);
    }
    fields.number("priority", priority, 0);
    return fmt::format("\n[material.{}]\n{}", key_text(written_name), fields.lines());
}

}  // namespace lancer::notation
