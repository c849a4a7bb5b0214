#include "lancer/import/mitsuba/materials.h"

#include <fmt/format.h>

#include "lancer/import/made_picture.h"
#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/import/mitsuba/bsdfs.h"
#include "lancer/import/mitsuba/colors.h"
#include "lancer/import/mitsuba/emitters.h"
#include "lancer/import/mitsuba/textures.h"

namespace lancer::mitsuba {

namespace {

scene::Material material_from(Builder& builder, const Element& element);

// The BSDF inside of another one.
scene::Material nested(Builder& builder, Plugin& plugin) {
    const auto children = plugin.children({"bsdf"});
    if (children.empty()) {
        builder.error(plugin.position(), fmt::format("{} needs a BSDF inside of it", plugin.title()));
        return {plugin.id(), scene::DiffuseMaterial{Color(0.5)}, plugin.position()};
    }
    scene::Material material = material_from(builder, *children.front().element);
    material.name = plugin.id().empty() ? material.name : plugin.id();
    return material;
}

int add(Builder& builder, scene::Material material) {
    builder.scene.materials.push_back(std::move(material));
    return static_cast<int>(builder.scene.materials.size()) - 1;
}

scene::Material two_sided(Builder& builder, Plugin& plugin) {
    const auto children = plugin.children({"bsdf"});
    scene::Material material = nested(builder, plugin);
    material.one_sided = false;
    if (children.size() > 1) {
        scene::Material behind = material_from(builder, *children[1].element);
        behind.one_sided = false;
        material.behind = add(builder, std::move(behind));
    }
    builder.honoured(plugin);
    return material;
}

scene::Material mask(Builder& builder, Plugin& plugin) {
    scene::Material material = nested(builder, plugin);
    material.opacity = value_or(builder, plugin, "opacity", 0.5);
    builder.honoured(plugin);
    return material;
}

scene::Material blend(Builder& builder, Plugin& plugin) {
    const auto children = plugin.children({"bsdf"});
    if (children.size() != 2) {
        builder.error(plugin.position(), fmt::format("{} needs two BSDFs inside of it", plugin.title()));
        return {plugin.id(), scene::DiffuseMaterial{Color(0.5)}, plugin.position()};
    }
    scene::Material first = material_from(builder, *children[0].element);
    scene::Material second = material_from(builder, *children[1].element);
    scene::MixMaterial mix;
    const bool one_sided = first.one_sided && second.one_sided;
    mix.first = add(builder, std::move(first));
    mix.second = add(builder, std::move(second));
    mix.share = value_or(builder, plugin, "weight", 0.5);
    builder.honoured(plugin);
    scene::Material material{plugin.id(), mix, plugin.position()};
    material.one_sided = one_sided;
    return material;
}

// The texture of a bump or normal map has any name.
const Element* only_texture(Builder& builder, Plugin& plugin) {
    const auto textures = plugin.children({"texture"});
    if (textures.size() != 1) {
        builder.error(plugin.position(), fmt::format("{} needs one texture", plugin.title()));
        return nullptr;
    }
    return textures.front().element;
}

scene::Material bump(Builder& builder, Plugin& plugin) {
    scene::Material material = nested(builder, plugin);
    const double scale = plugin.number("scale", 1.0);
    if (const Element* texture = only_texture(builder, plugin)) {
        scene::Value heights = value_of(builder, *texture);
        heights.number *= scale;
        heights.scale *= scale;
        material.relief.heights = heights;
    }
    material.relief.shadows = plugin.flag("use_shadowing_function", true);
    plugin.ignore("flip_invalid_normals");
    builder.honoured(plugin);
    return material;
}

scene::Material normal_map(Builder& builder, Plugin& plugin) {
    scene::Material material = nested(builder, plugin);
    if (const Element* texture = only_texture(builder, plugin)) {
        const scene::Texture normals = texture_of(builder, *texture, Role::index);
        if (const auto* everywhere = std::get_if<scene::Color>(&normals)) {
            const Color color = visible(*everywhere, Role::index);
            if (color != Color(0.5, 0.5, 1.0)) {
                const Image pixel{1, 1, 3, {static_cast<float>(color.x), static_cast<float>(color.y), static_cast<float>(color.z)}};
                material.relief.normals = made_picture(pixel, plugin.position());
            }
        } else {
            material.relief.normals = normals;
        }
        material.relief.crosswise = material.relief.normals.has_value();
    }
    material.relief.shadows = plugin.flag("use_shadowing_function", true);
    plugin.ignore("flip_invalid_normals");
    builder.honoured(plugin);
    return material;
}

// What changes another BSDF in a way that we can't follow.
scene::Material unchanged(Builder& builder, Plugin& plugin) {
    scene::Material material = nested(builder, plugin);
    for (const std::string_view name : {"weights", "thickness", "sigma_a", "int_ior", "ext_ior", "alpha", "distribution"}) {
        plugin.ignore(name);
    }
    builder.approximated(plugin, "the BSDF inside of it alone");
    return material;
}

struct Wrapper {
    std::string_view name;
    scene::Material (*read)(Builder&, Plugin&);
};

constexpr Wrapper wrappers[] = {
    {"twosided", two_sided},    {"mask", mask},         {"blendbsdf", blend},
    {"bumpmap", bump},          {"bump", bump},         {"normalmap", normal_map},
    {"mixturebsdf", unchanged}, {"coating", unchanged}, {"roughcoating", unchanged},
};

std::optional<scene::Material> wrapper_of(Builder& builder, Plugin& plugin) {
    for (const Wrapper& wrapper : wrappers) {
        if (wrapper.name == plugin.type()) {
            return wrapper.read(builder, plugin);
        }
    }
    return std::nullopt;
}

scene::Material material_from(Builder& builder, const Element& element) {
    const Nesting nesting(builder, element.position);
    Plugin plugin = builder.plugin(element);
    scene::Material material{plugin.id(), scene::DiffuseMaterial{Color(0.5)}, element.position};
    if (nesting.too_deep()) {
        return material;
    }
    if (auto wrapper = wrapper_of(builder, plugin)) {
        material = std::move(*wrapper);
    } else if (auto known = bsdf_of(builder, plugin)) {
        material = std::move(*known);
    } else {
        builder.approximated(plugin, "a grey diffuse surface");
        builder.context.diagnostics.warning(element.position, fmt::format("no BSDF {} is known here: it is grey{}", quoted(plugin.type()),
                                                                          hint(plugin.type(), bsdf_names())));
        return material;
    }
    plugin.finish();
    return material;
}

}  // namespace

int material_of(Builder& builder, const Element* bsdf, const Element* emitter, const SourcePosition& shape) {
    const auto [found, is_new] = builder.materials.try_emplace({bsdf, emitter}, 0);
    if (!is_new) {
        return found->second;
    }
    scene::Material material{{}, scene::DiffuseMaterial{Color(0.5)}, shape};
    material.one_sided = true;
    if (is_nothing(bsdf) && !emitter) {
        material.model = scene::NullMaterial{};
        material.one_sided = false;
        builder.context.report.honoured("bsdf \"null\"", bsdf->position);
    } else if (bsdf) {
        material = material_from(builder, *bsdf);
    }
    if (emitter) {
        material.emission = emission_of(builder, *emitter);
    }
    const int number = static_cast<int>(builder.scene.materials.size());
    builder.scene.materials.push_back(std::move(material));
    builder.materials[{bsdf, emitter}] = number;
    return number;
}

int filled_material(Builder& builder, int material, int medium) {
    const auto [found, is_new] = builder.filled.try_emplace({material, medium}, static_cast<int>(builder.scene.materials.size()));
    if (is_new) {
        scene::Material copy = builder.scene.materials[static_cast<std::size_t>(material)];
        copy.interior = medium;
        builder.scene.materials.push_back(std::move(copy));
    }
    return found->second;
}

bool is_nothing(const Element* bsdf) { return bsdf && bsdf->attribute("type") == "null"; }

}  // namespace lancer::mitsuba
