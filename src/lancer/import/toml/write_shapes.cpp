// Shapes, where they stand, and placements of groups.
#include <fmt/format.h>

#include "lancer/import/toml/write_context.h"

namespace lancer::notation {

namespace {

const char* write_shape(Fields& fields, WriteContext&, const scene::Sphere& sphere) {
    const auto& [center, radius] = sphere;
    fields.vector("center", center, glm::dvec3(0.0));
    fields.number("radius", radius);
    return "sphere";
}

const char* write_shape(Fields& fields, WriteContext&, const scene::Box& box) {
    const auto& [min, max] = box;
    fields.vector("min", min);
    fields.vector("max", max);
    return "box";
}

const char* write_shape(Fields& fields, WriteContext&, const scene::Plane& plane) {
    const auto& [point, normal] = plane;
    fields.vector("point", point);
    fields.vector("normal", normal);
    return "plane";
}

const char* write_shape(Fields& fields, WriteContext&, const scene::Disk& disk) {
    const auto& [center, normal, radius] = disk;
    fields.vector("center", center, glm::dvec3(0.0));
    fields.vector("normal", normal);
    fields.number("radius", radius);
    return "disk";
}

const char* write_shape(Fields& fields, WriteContext&, const scene::Cylinder& cylinder) {
    const auto& [from, to, radius, capped] = cylinder;
    fields.vector("from", from);
    fields.vector("to", to);
    fields.number("radius", radius);
    fields.flag("capped", capped, true);
    return "cylinder";
}

const char* write_shape(Fields& fields, WriteContext&, const scene::Cone& cone) {
    const auto& [from, to, radius, top_radius, capped] = cone;
    fields.vector("from", from);
    fields.vector("to", to);
    fields.number("radius", radius);
    fields.number("top_radius", top_radius);
    fields.flag("capped", capped, true);
    return "cone";
}

const char* write_shape(Fields& fields, WriteContext& context, const scene::Mesh& mesh) {
    const auto& [data, smooth] = mesh;
    const auto [part, is_new] = context.parts.try_emplace(data.get(), context.meshes.size());
    if (is_new) {
        context.meshes.push_back(data);
    }
    fields.text("file", context.mesh_file());
    fields.number("part", static_cast<double>(part->second));
    fields.flag("smooth", smooth, true);
    return "mesh";
}

}  // namespace

void add_transform(Fields& fields, const glm::dmat4& map) {
    glm::dmat4 unmoved = map;
    unmoved[3] = glm::dvec4(0.0, 0.0, 0.0, 1.0);
    const glm::dvec3 moved(map[3]);
    if (unmoved == glm::dmat4(1.0)) {
        fields.vector("translate", moved, glm::dvec3(0.0));
        return;
    }
    std::vector<double> rows;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            rows.push_back(map[column][row]);
        }
    }
    fields.raw("matrix", list_text(rows));
}

std::string write_object(WriteContext& context, const scene::Object& object, const std::string& prefix) {
    const auto& [name, shape, material, to_parent, position] = object;
    static_cast<void>(position);
    Fields fields;
    fields.text("name", name, "");
    const std::string kind = std::visit([&](const auto& s) { return write_shape(fields, context, s); }, shape);
    // Shapes without a material get the default one.
    if (!context.scene.materials[static_cast<std::size_t>(material)].is_default) {
        fields.text("material", context.material(material));
    }
    add_transform(fields, to_parent);
    return fmt::format("\n[[{}{}]]\n{}", prefix, kind, fields.lines());
}

std::string write_placement(const WriteContext& context, const scene::Placement& placement, const std::string& prefix) {
    const auto& [group, to_parent, material, position] = placement;
    static_cast<void>(position);
    Fields fields;
    fields.text("group", context.groups[static_cast<std::size_t>(group)]);
    if (material) {
        fields.text("material", context.material(*material));
    }
    add_transform(fields, to_parent);
    return fmt::format("\n[[{}place]]\n{}", prefix, fields.lines());
}

}  // namespace lancer::notation
