#include "lancer/import/mitsuba/media.h"

#include <algorithm>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/import/mitsuba/colors.h"

namespace lancer::mitsuba {

namespace {

// A colour in space, or the same everywhere.
struct Quantity {
    scene::Color color;
    std::optional<scene::Grid> grid;
};

std::optional<scene::Grid> grid_volume(Builder& builder, Plugin& plugin) {
    const std::string path = builder.document.resolve(plugin.text("filename", ""), plugin.position());
    const glm::dmat4 to_world = plugin.transform("to_world").value_or(glm::dmat4(1.0));
    const bool own_box = plugin.flag("use_grid_bbox", false);
    if (plugin.text("filter_type", "trilinear") != "trilinear") {
        builder.approximated(plugin, "straight lines between the cells");
    }
    for (const std::string_view name : {"wrap_mode", "raw", "accel", "data"}) {
        plugin.ignore(name);
    }
    auto file = builder.context.files.voxels(path, {}, plugin.position());
    if (!file) {
        return std::nullopt;
    }
    return scene::Grid{std::move(file->data), own_box ? to_world * file->to_world : to_world, false};
}

scene::Grid one_cell(const glm::dmat4& to_world) {
    auto one = std::make_shared<scene::VoxelData>();
    one->values = {1.0f};
    return {one, to_world, false};
}

Quantity quantity(Builder& builder, Plugin& plugin, std::string_view name, double preset, Role role) {
    const Element* element = plugin.find(name);
    if (!element) {
        return {scene::Rgb(preset), std::nullopt};
    }
    if (element->tag != "volume") {
        return {color_of(builder, *element, role).value_or(scene::Rgb(preset)), std::nullopt};
    }
    Plugin volume = builder.plugin(*element);
    Quantity result{scene::Rgb(1.0), std::nullopt};
    if (volume.type() == "constvolume") {
        result.color = color_or(builder, volume, "value", scene::Rgb(1.0), role);
        const auto to_world = volume.transform("to_world");
        if (plugin.type() == "heterogeneous") {  // it fills its own box and no more
            result.grid = one_cell(to_world.value_or(glm::dmat4(1.0)));
        }
        builder.honoured(volume);
    } else if (volume.type() == "gridvolume") {
        result.grid = grid_volume(builder, volume);
        if (result.grid) {
            builder.honoured(volume);
        }
    } else {
        builder.dropped(volume, "no such volume is known here: it is 1 everywhere");
    }
    volume.finish();
    return result;
}

void set_phase(Builder& builder, Plugin& plugin, scene::Medium& medium) {
    for (const auto& [name, element] : plugin.children({"phase"})) {
        Plugin phase = builder.plugin(*element);
        if (phase.type() == "hg") {
            medium.asymmetry = std::clamp(phase.number("g", 0.8), -0.999, 0.999);
        } else if (phase.type() == "rayleigh") {
            medium.phase = scene::Phase::rayleigh;
        }
        if (phase.type() == "hg" || phase.type() == "rayleigh" || phase.type() == "isotropic") {
            builder.honoured(phase);
            phase.finish();
        } else {
            builder.approximated(phase, "to all sides alike");
        }
    }
}

scene::Medium medium_from(Builder& builder, Plugin& plugin) {
    scene::Medium medium;
    medium.name = plugin.id();
    medium.position = plugin.position();
    medium.scale = plugin.number("scale", 1.0, 0.0, 1e12);
    if (plugin.has("sigma_a") || plugin.has("sigma_s")) {
        medium.coefficients = scene::AbsorbingScattering{color_or(builder, plugin, "sigma_a", Color(0.0), Role::index),
                                                         color_or(builder, plugin, "sigma_s", Color(0.0), Role::index)};
    } else {
        Quantity extinction = quantity(builder, plugin, plugin.has("density") ? "density" : "sigma_t", 1.0, Role::index);
        Quantity albedo = quantity(builder, plugin, "albedo", 0.75, Role::share);
        const bool colored = albedo.grid && albedo.grid->data->values.size() > 1;
        medium.coefficients = scene::ExtinctionAlbedo{extinction.color, albedo.color};
        medium.density = std::move(extinction.grid);
        if (colored) {
            medium.albedo = std::move(albedo.grid);
            medium.density = medium.density ? medium.density : one_cell(medium.albedo->to_world);
        }
    }
    set_phase(builder, plugin, medium);
    for (const std::string_view name :
         {"sample_emitters", "has_spectral_extinction", "method", "majorant_resolution_factor", "majorant_factor"}) {
        plugin.ignore(name);
    }
    return medium;
}

}  // namespace

std::optional<int> medium_of(Builder& builder, const Element& element) {
    const auto [found, is_new] = builder.media.try_emplace(&element, std::nullopt);
    if (!is_new) {
        return found->second;
    }
    Plugin plugin = builder.plugin(element);
    if (plugin.type() != "homogeneous" && plugin.type() != "heterogeneous") {
        builder.dropped(plugin, "no such medium is known here");
        return std::nullopt;
    }
    scene::Medium medium = medium_from(builder, plugin);
    plugin.finish();
    builder.honoured(plugin);
    const int number = static_cast<int>(builder.scene.media.size());
    builder.scene.media.push_back(std::move(medium));
    builder.media[&element] = number;
    return number;
}

}  // namespace lancer::mitsuba
