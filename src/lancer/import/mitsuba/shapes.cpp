#include "lancer/import/mitsuba/shapes.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/import/mitsuba/materials.h"
#include "lancer/import/mitsuba/media.h"
#include "lancer/import/mitsuba/meshes.h"
#include "lancer/import/mitsuba/textures.h"

namespace lancer::mitsuba {

namespace {

// What all shapes have: where they are, what they are made of, and whether they shine.
struct Common {
    glm::dmat4 to_world{1.0};
    const Element* bsdf = nullptr;
    const Element* emitter = nullptr;
    const Element* interior = nullptr;  // media
    const Element* exterior = nullptr;
};

Common common(Builder& builder, Plugin& plugin) {
    Common all;
    all.to_world = plugin.transform("to_world").value_or(glm::dmat4(1.0));
    for (const auto& [name, element] : plugin.children({"bsdf"})) {
        all.bsdf = element;
    }
    for (const auto& [name, element] : plugin.children({"emitter"})) {
        all.emitter = element;
    }
    for (const auto& [name, element] : plugin.children({"medium"})) {
        (name == "exterior" ? all.exterior : all.interior) = element;
    }
    for (const auto& [name, element] : plugin.children({"sensor"})) {
        builder.context.report.dropped(fmt::format("sensor {} on a shape", quoted(element->attribute("type"))), "no such camera",
                                       element->position);
    }
    for (const auto& [name, element] : plugin.children({"subsurface"})) {
        builder.context.report.dropped(fmt::format("subsurface {}", quoted(element->attribute("type"))), "media are not there",
                                       element->position);
    }
    plugin.ignore("silhouette_sampling_weight");
    return all;
}

void place_shape(Builder& builder, Plugin& plugin, const Common& all, scene::Shape shape, const glm::dmat4& to_parent, Place place) {
    if (is_nothing(all.bsdf) && !all.emitter && !all.interior && !all.exterior) {
        builder.context.report.honoured("bsdf \"null\"", all.bsdf->position);
        return;
    }
    scene::Object object;
    object.name = plugin.id();
    object.shape = std::move(shape);
    object.material = material_of(builder, all.bsdf, all.emitter, plugin.position());
    // What is outside is what light has come through to get here.
    if (const auto medium = all.interior ? medium_of(builder, *all.interior) : std::nullopt) {
        object.material = filled_material(builder, object.material, *medium);
    }
    object.to_parent = to_parent;
    object.position = plugin.position();
    place.objects.push_back(std::move(object));
}

void add_mesh(Builder& builder, Plugin& plugin, std::shared_ptr<const scene::TriangleMesh> data, Place place) {
    const Common all = common(builder, plugin);
    if (data) {
        place_shape(builder, plugin, all, scene::Mesh{std::move(data), true}, all.to_world, place);
    }
    builder.honoured(plugin);
}

void add_file(Builder& builder, Plugin& plugin, Place place) {
    plugin.ignore("max_smooth_angle");
    plugin.ignore("collapse");
    const Common all = common(builder, plugin);
    const std::string attribute = plugin.type() == "ply" ? attribute_used(builder, all.bsdf) : std::string();
    if (auto data = mesh_from_file(builder, plugin, attribute)) {
        place_shape(builder, plugin, all, scene::Mesh{std::move(data), true}, all.to_world, place);
    }
    builder.honoured(plugin);
}

void add_curves(Builder& builder, Plugin& plugin, Place place) {
    add_mesh(builder, plugin, curves_from_file(builder, plugin), place);
    builder.approximated(plugin, "tubes of triangles");
}

std::shared_ptr<const scene::TriangleMesh> facing(Plugin& plugin, std::shared_ptr<const scene::TriangleMesh> mesh) {
    return plugin.flag("flip_normals", false) ? std::make_shared<const scene::TriangleMesh>(turned(*mesh)) : mesh;
}

void add_rectangle(Builder& builder, Plugin& plugin, Place place) { add_mesh(builder, plugin, facing(plugin, rectangle_mesh()), place); }
void add_cube(Builder& builder, Plugin& plugin, Place place) { add_mesh(builder, plugin, facing(plugin, cube_mesh()), place); }

void add_sphere(Builder& builder, Plugin& plugin, Place place) {
    const Common all = common(builder, plugin);
    const glm::dvec3 center = plugin.vector("center", glm::dvec3(0.0));
    const double radius = plugin.number("radius", 1.0, 1e-12, 1e12);
    if (plugin.flag("flip_normals", false)) {
        builder.approximated(plugin, "\"flip_normals\" is passed over: a sphere's normals point outwards");
    } else {
        builder.honoured(plugin);
    }
    // Mitsuba's spheres have their poles along z, ours along y.
    const glm::dmat4 poles(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(0, -1, 0, 0), glm::dvec4(0, 0, 0, 1));
    place_shape(builder, plugin, all, scene::Sphere{glm::dvec3(0.0), radius},
                all.to_world * glm::translate(glm::dmat4(1.0), center) * poles, place);
}

void add_disk(Builder& builder, Plugin& plugin, Place place) {
    const Common all = common(builder, plugin);
    const double side = plugin.flag("flip_normals", false) ? -1.0 : 1.0;
    place_shape(builder, plugin, all, scene::Disk{glm::dvec3(0.0), glm::dvec3(0.0, 0.0, side), 1.0}, all.to_world, place);
    builder.honoured(plugin);
}

void add_cylinder(Builder& builder, Plugin& plugin, Place place) {
    const Common all = common(builder, plugin);
    scene::Cylinder cylinder;
    cylinder.from = plugin.vector("p0", glm::dvec3(0.0));
    cylinder.to = plugin.vector("p1", glm::dvec3(0.0, 0.0, 1.0));
    cylinder.radius = plugin.number("radius", 1.0, 1e-12, 1e12);
    cylinder.capped = false;
    if (!(glm::distance(cylinder.from, cylinder.to) > 0.0)) {
        builder.error(plugin.position(), "\"p0\" and \"p1\" are the same point");
        return;
    }
    if (plugin.flag("flip_normals", false)) {
        builder.approximated(plugin, "\"flip_normals\" is passed over: a cylinder's normals point outwards");
    } else {
        builder.honoured(plugin);
    }
    place_shape(builder, plugin, all, cylinder, all.to_world, place);
}

// Puts the shapes of a group into a group of ours; a number of scene.groups.
int group_of(Builder& builder, const Element& element) {
    if (const auto found = builder.groups.find(&element); found != builder.groups.end()) {
        return found->second;
    }
    Plugin plugin = builder.plugin(element);
    scene::Group group;
    group.name = plugin.id();
    for (const auto& [name, shape] : plugin.children({"shape"})) {
        add_shape(builder, *shape, {group.objects, group.placements});
    }
    plugin.ignore("to_world");
    plugin.finish();
    builder.honoured(plugin);
    const int number = static_cast<int>(builder.scene.groups.size());
    builder.scene.groups.push_back(std::move(group));
    builder.groups.emplace(&element, number);
    return number;
}

void add_instance(Builder& builder, Plugin& plugin, Place place) {
    const auto groups = plugin.children({"shape"});
    if (groups.size() != 1 || groups.front().element->attribute("type") != "shapegroup") {
        builder.error(plugin.position(), "an instance needs one <ref> to a shape group");
        return;
    }
    scene::Placement placement;
    placement.group = group_of(builder, *groups.front().element);
    placement.to_parent = plugin.transform("to_world").value_or(glm::dmat4(1.0));
    placement.position = plugin.position();
    place.placements.push_back(placement);
    builder.honoured(plugin);
}

void add_merged(Builder& builder, Plugin& plugin, Place place) {
    for (const auto& [name, shape] : plugin.children({"shape"})) {
        add_shape(builder, *shape, place);
    }
    builder.honoured(plugin);
}

struct Kind {
    std::string_view name;
    void (*add)(Builder&, Plugin&, Place);
};

constexpr Kind kinds[] = {
    {"obj", add_file},      {"ply", add_file},        {"rectangle", add_rectangle}, {"cube", add_cube},
    {"sphere", add_sphere}, {"disk", add_disk},       {"cylinder", add_cylinder},   {"instance", add_instance},
    {"merge", add_merged},  {"serialized", add_file}, {"bsplinecurve", add_curves}, {"linearcurve", add_curves},
};

}  // namespace

void add_shape(Builder& builder, const Element& element, Place place) {
    const Nesting nesting(builder, element.position);
    if (nesting.too_deep()) {
        return;
    }
    Plugin plugin = builder.plugin(element);
    if (plugin.type() == "shapegroup") {
        return;  // waits for its instances
    }
    for (const Kind& kind : kinds) {
        if (kind.name == plugin.type()) {
            kind.add(builder, plugin, place);
            plugin.finish();
            return;
        }
    }
    std::vector<std::string> names = {"shapegroup"};
    for (const Kind& kind : kinds) {
        names.emplace_back(kind.name);
    }
    builder.dropped(plugin, "such a shape is not there");
    builder.context.diagnostics.warning(
        element.position, fmt::format("no shape {} is known here: it is left out{}", quoted(plugin.type()), hint(plugin.type(), names)));
}

}  // namespace lancer::mitsuba
