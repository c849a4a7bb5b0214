#include "lancer/import/mitsuba/bsdfs.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/import/mitsuba/optics.h"
#include "lancer/import/mitsuba/textures.h"
#include "lancer/spectrum/metal.h"

namespace lancer::mitsuba {

namespace {

// How rough and how stretched facets are, as our materials have it: the roots of the widths of their slopes.
struct Slopes {
    scene::Value roughness = 0.0;
    double anisotropy = 0.0;
};

double root_of_alpha(double alpha) { return std::sqrt(std::clamp(alpha, 1e-4, 1.0)); }

Slopes slopes(Builder& builder, Plugin& plugin) {
    plugin.ignore("sample_visible");
    if (!plugin.has("alpha_u") && !plugin.has("alpha_v")) {
        return {changed_value_or(builder, plugin, "alpha", 0.1, root_of_alpha), 0.0};
    }
    const double u = std::clamp(number_or(builder, plugin, "alpha_u", 0.1), 1e-4, 1.0);
    const double v = std::clamp(number_or(builder, plugin, "alpha_v", 0.1), 1e-4, 1.0);
    // Ours: the ratio of the two is 1 - 0.9 anisotropy.
    return {std::sqrt(std::sqrt(u * v)), (1.0 - u / v) / 0.9};
}

// Light that meets several of them is lost, and they hide one another towards either direction by itself.
scene::Facets read_facets(Builder& builder, Plugin& plugin) {
    const std::string name = plugin.text("distribution", "beckmann");
    if (name != "ggx" && name != "beckmann") {
        builder.approximated(plugin, fmt::format("Beckmann's facets for {}", quoted(name)));
    }
    return {name == "ggx" ? scene::Facets::Distribution::ggx : scene::Facets::Distribution::beckmann, true, true};
}

// A tint that nature does not have, and most scenes neither.
void expect_white(Builder& builder, Plugin& plugin, std::string_view name) {
    const scene::Texture tint = texture_or(builder, plugin, name, Color(1.0), Role::share);
    const auto* color = std::get_if<scene::Color>(&tint);
    if (!color || color->spectrum || color->rgb != Color(1.0)) {
        builder.context.report.dropped(fmt::format("{}: \"{}\"", plugin.title(), name), "white is used", plugin.position());
    }
}

double relative_index(Builder& builder, Plugin& plugin, std::string_view inside) {
    const double within = index_or(builder, plugin, "int_ior", inside);
    const double outside = index_or(builder, plugin, "ext_ior", "air");
    if (outside < 1.01) {
        return within / outside;
    }
    // Our paths know what they are inside of.
    builder.approximated(plugin, "the index of what is outside is taken from the bodies around it");
    return within;
}

scene::Material diffuse(Builder& builder, Plugin& plugin) {
    scene::Material made{plugin.id(), scene::DiffuseMaterial{}, plugin.position()};
    auto& material = std::get<scene::DiffuseMaterial>(made.model);
    material.color = texture_or(builder, plugin, "reflectance", Color(0.5), Role::share);
    builder.honoured(plugin);
    return made;
}

// 0.x: Oren and Nayar's facets.
scene::Material rough_diffuse(Builder& builder, Plugin& plugin) {
    scene::Material made{plugin.id(), scene::DiffuseMaterial{}, plugin.position()};
    auto& material = std::get<scene::DiffuseMaterial>(made.model);
    material.color = texture_or(builder, plugin, "reflectance", Color(0.5), Role::share);
    material.roughness = std::clamp(number_or(builder, plugin, "alpha", 0.2), 0.0, 1.0);
    plugin.ignore("use_fast_approx");
    builder.approximated(plugin, "facets that keep white surfaces white");
    return made;
}

scene::Material dielectric(Builder& builder, Plugin& plugin, bool rough, bool thin) {
    scene::Material made{plugin.id(), scene::DielectricMaterial{}, plugin.position()};
    auto& material = std::get<scene::DielectricMaterial>(made.model);
    material.thin = thin;
    material.refraction = relative_index(builder, plugin, "bk7");
    if (rough) {
        const Slopes a = slopes(builder, plugin);
        material.roughness = a.roughness;
        material.anisotropy = a.anisotropy;
        material.facets = read_facets(builder, plugin);
    }
    expect_white(builder, plugin, "specular_reflectance");
    expect_white(builder, plugin, "specular_transmittance");
    builder.honoured(plugin);
    return made;
}

void set_metal(Builder& builder, Plugin& plugin, scene::ConductorMaterial& material) {
    const std::string name = plugin.text("material", plugin.has("eta") ? "none" : "Cu");
    material.color = texture_or(builder, plugin, "specular_reflectance", Color(1.0), Role::share);
    if (plugin.has("eta") || plugin.has("k")) {
        const double outside = plugin.has("ext_eta") ? index_or(builder, plugin, "ext_eta", "air") : 1.0;
        material.n = index_curve_or_nothing(builder, plugin, "eta", outside).value_or(Color(0.0));
        material.k = index_curve_or_nothing(builder, plugin, "k", outside).value_or(Color(1.0));
    } else if (name == "none") {
        return;
    } else if (find_metal(name)) {
        material.metal = name;
    } else {
        const std::size_t dash = name.find_first_of("_-");
        material.metal = find_metal(name.substr(0, dash)) ? name.substr(0, dash) : "Cu";
        builder.approximated(plugin, fmt::format("{} for {}", material.metal, quoted(name)));
    }
}

scene::Material conductor(Builder& builder, Plugin& plugin, bool rough) {
    scene::Material made{plugin.id(), scene::ConductorMaterial{}, plugin.position()};
    auto& material = std::get<scene::ConductorMaterial>(made.model);
    set_metal(builder, plugin, material);
    if (rough) {
        const Slopes a = slopes(builder, plugin);
        material.roughness = a.roughness;
        material.anisotropy = a.anisotropy;
        material.facets = read_facets(builder, plugin);
    }
    builder.honoured(plugin);
    return made;
}

scene::Material plastic(Builder& builder, Plugin& plugin, bool rough) {
    scene::Material made{plugin.id(), scene::PlasticMaterial{}, plugin.position()};
    auto& material = std::get<scene::PlasticMaterial>(made.model);
    material.color = texture_or(builder, plugin, "diffuse_reflectance", Color(0.5), Role::share);
    const double within = index_or(builder, plugin, "int_ior", "polypropylene");
    material.refraction = within / index_or(builder, plugin, "ext_ior", "air");
    material.saturates = plugin.flag("nonlinear", false);
    if (rough) {
        material.roughness = slopes(builder, plugin).roughness;
        material.facets = read_facets(builder, plugin);
    }
    expect_white(builder, plugin, "specular_reflectance");
    builder.honoured(plugin);
    return made;
}

double number_from(Builder& builder, Plugin& plugin, std::string_view name, double preset, double most = 1.0) {
    return std::clamp(number_or(builder, plugin, name, preset), 0.0, most);
}

scene::Material principled(Builder& builder, Plugin& plugin, bool thin) {
    scene::Material made{plugin.id(), scene::BurleyMaterial{}, plugin.position()};
    auto& material = std::get<scene::BurleyMaterial>(made.model);
    material.color = texture_or(builder, plugin, "base_color", Color(0.5), Role::share);
    material.roughness = value_or(builder, plugin, "roughness", 0.5);
    material.anisotropy = value_or(builder, plugin, "anisotropic", 0.0);
    material.transmission = value_or(builder, plugin, "spec_trans", 0.0);
    material.specular_tint = number_from(builder, plugin, "spec_tint", 0.0);
    material.sheen = value_or(builder, plugin, "sheen", 0.0);
    material.sheen_tint = number_from(builder, plugin, "sheen_tint", 0.0);
    material.flatness = number_from(builder, plugin, "flatness", 0.0);
    material.thin = thin;
    if (thin) {
        material.refraction = std::max(number_or(builder, plugin, "eta", 1.5), 1.0);
        // From 0 to 2 there.
        material.passes =
            changed_value_or(builder, plugin, "diff_trans", 0.0, [](double passes) { return 0.5 * std::clamp(passes, 0.0, 2.0); });
    } else {
        // "specular" from 0 to 1 is 0 to 8 % of the light at normal incidence.
        const double mirrored = std::sqrt(0.08 * number_from(builder, plugin, "specular", 0.5));
        material.refraction = plugin.number("eta", std::max(2.0 / (1.0 - mirrored) - 1.0, 1.001), 1.0, 10.0);
        material.metalness = value_or(builder, plugin, "metallic", 0.0);
        material.coat = value_or(builder, plugin, "clearcoat", 0.0);
        material.coat_gloss = number_from(builder, plugin, "clearcoat_gloss", 0.0);
    }
    for (const std::string_view name :
         {"diffuse_reflectance_sampling_rate", "specular_reflectance_sampling_rate", "specular_transmittance_sampling_rate",
          "diffuse_transmittance_sampling_rate", "spec_trans_sampling_rate", "clearcoat_sampling_rate", "main_specular_sampling_rate",
          "diff_trans_sampling_rate"}) {
        plugin.ignore(name);
    }
    builder.honoured(plugin);
    return made;
}

// 0.x: Phong's and Ward's lobes.
scene::Material lobes(Builder& builder, Plugin& plugin) {
    scene::Material made{plugin.id(), scene::PrincipledMaterial{}, plugin.position()};
    auto& material = std::get<scene::PrincipledMaterial>(made.model);
    material.color = texture_or(builder, plugin, "diffuse_reflectance", Color(0.5), Role::share);
    const double exponent = number_or(builder, plugin, "exponent", 30.0);
    material.roughness =
        plugin.type() == "phong" ? scene::Value(std::pow(2.0 / (std::max(exponent, 0.0) + 2.0), 0.25)) : slopes(builder, plugin).roughness;
    plugin.ignore("specular_reflectance");
    plugin.ignore("variant");
    builder.approximated(plugin, "our principled material");
    return made;
}

scene::Material translucent(Builder& builder, Plugin& plugin) {
    scene::Material made{plugin.id(), scene::DiffuseMaterial{}, plugin.position()};
    auto& material = std::get<scene::DiffuseMaterial>(made.model);
    material.color = texture_or(builder, plugin, "transmittance", Color(0.5), Role::share);
    builder.approximated(plugin, "a diffuse surface that lets nothing through");
    return made;
}

scene::Material measured_grey(Builder& builder, Plugin& plugin) {
    plugin.ignore("filename");
    builder.approximated(plugin, "a grey diffuse surface: measured materials are not read");
    return {plugin.id(), scene::DiffuseMaterial{Color(0.5)}, plugin.position()};
}

struct Model {
    std::string_view name;
    scene::Material (*read)(Builder&, Plugin&);
    bool one_sided;  // black from behind
};

constexpr Model models[] = {
    {"diffuse", diffuse, true},
    {"roughdiffuse", rough_diffuse, true},
    {"dielectric", [](Builder& b, Plugin& p) { return dielectric(b, p, false, false); }, false},
    {"roughdielectric", [](Builder& b, Plugin& p) { return dielectric(b, p, true, false); }, false},
    {"thindielectric", [](Builder& b, Plugin& p) { return dielectric(b, p, false, true); }, false},
    {"conductor", [](Builder& b, Plugin& p) { return conductor(b, p, false); }, true},
    {"roughconductor", [](Builder& b, Plugin& p) { return conductor(b, p, true); }, true},
    {"plastic", [](Builder& b, Plugin& p) { return plastic(b, p, false); }, true},
    {"roughplastic", [](Builder& b, Plugin& p) { return plastic(b, p, true); }, true},
    {"principled", [](Builder& b, Plugin& p) { return principled(b, p, false); }, false},
    {"principledthin", [](Builder& b, Plugin& p) { return principled(b, p, true); }, false},
    {"phong", lobes, true},
    {"ward", lobes, true},
    {"difftrans", translucent, false},
    {"measured", measured_grey, true},
    {"measured_polarized", measured_grey, true},
    {"hair", measured_grey, false},
};

}  // namespace

std::optional<scene::Material> bsdf_of(Builder& builder, Plugin& plugin) {
    for (const Model& model : models) {
        if (model.name == plugin.type()) {
            scene::Material material = model.read(builder, plugin);
            material.one_sided = model.one_sided;
            return material;
        }
    }
    return std::nullopt;
}

std::vector<std::string> bsdf_names() {
    std::vector<std::string> names;
    for (const Model& model : models) {
        names.emplace_back(model.name);
    }
    return names;
}

}  // namespace lancer::mitsuba
