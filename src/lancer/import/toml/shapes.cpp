#include "lancer/import/toml/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include <glm/geometric.hpp>

#include "lancer/base/file.h"
#include "lancer/import/mesh/mesh_check.h"
#include "lancer/import/toml/transforms.h"

namespace lancer::notation {

namespace {

using MaybeShape = std::optional<scene::Shape>;

constexpr double shortest_axis = 1e-9;  // metres

MaybeShape read_sphere(TableReader& reader) { return scene::Sphere{reader.vector3("center"), reader.number("radius")}; }

MaybeShape read_box(TableReader& reader) {
    const scene::Box box{reader.vector3("min"), reader.vector3("max")};
    for (int axis = 0; reader.good() && axis < 3; ++axis) {
        const double low = box.min[axis];
        const double high = box.max[axis];
        const char* at = reader.has("min") ? "min" : "max";
        if (low >= high) {
            reader.error(at, fmt::format("\"min\" must be less than \"max\": along {} they are {} and {}", "xyz"[axis], low, high));
        } else if (static_cast<float>(low) >= static_cast<float>(high)) {
            reader.error(at, fmt::format("this box is too thin for where it stands: along {} from {} to {}", "xyz"[axis], low, high));
        }
    }
    return box;
}

MaybeShape read_plane(TableReader& reader) { return scene::Plane{reader.vector3("point"), reader.direction("normal")}; }

MaybeShape read_disk(TableReader& reader) {
    return scene::Disk{reader.vector3("center"), reader.direction("normal"), reader.number("radius")};
}

void check_axis(TableReader& reader, const glm::dvec3& from, const glm::dvec3& to) {
    if (reader.good() && glm::distance(from, to) < shortest_axis) {
        reader.error(reader.has("to") ? "to" : "from", "\"from\" and \"to\" must be different points");
    }
}

MaybeShape read_cylinder(TableReader& reader) {
    const scene::Cylinder cylinder{reader.vector3("from"), reader.vector3("to"), reader.number("radius"), reader.flag("capped")};
    check_axis(reader, cylinder.from, cylinder.to);
    return cylinder;
}

MaybeShape read_cone(TableReader& reader) {
    const scene::Cone cone{reader.vector3("from"), reader.vector3("to"), reader.number("radius"), reader.number("top_radius"),
                           reader.flag("capped")};
    check_axis(reader, cone.from, cone.to);
    if (reader.good() && cone.radius == 0.0 && cone.top_radius == 0.0) {
        reader.error("radius", "\"radius\" and \"top_radius\" must not both be 0");
    }
    return cone;
}

void check_inline_corners(TableReader& reader, const scene::TriangleMesh& mesh) {
    const toml::array* list = reader.value("triangles", Kind::triangles)->as_array();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t corner = mesh.triangles[i][k];
            if (corner >= mesh.positions.size()) {
                const toml::node& node = *list->get(i)->as_array()->get(static_cast<std::size_t>(k));
                reader.error(reader.messages().at(node),
                             fmt::format("there is no corner {}: \"positions\" has {}, counted from 0", corner, mesh.positions.size()));
            }
        }
    }
}

std::vector<glm::vec4> read_colors(TableReader& reader, const char* key, std::size_t wanted, const char* of) {
    std::vector<glm::vec4> colors;
    for (const glm::vec3& rgb : reader.vectors3(key)) {
        colors.emplace_back(rgb, 1.0f);
    }
    if (reader.good() && !colors.empty() && colors.size() != wanted) {
        reader.error(key, fmt::format("\"{}\" must have one entry for each of the {} {}, not {}", key, wanted, of, colors.size()));
    }
    return colors;
}

std::shared_ptr<const scene::TriangleMesh> read_inline_mesh(Context& context, TableReader& reader) {
    auto mesh = std::make_shared<scene::TriangleMesh>();
    mesh->positions = reader.vectors3("positions");
    mesh->triangles = reader.triangles("triangles");
    mesh->normals = reader.vectors3("normals");
    mesh->uvs = reader.vectors2("uvs");
    for (const char* key : {"normals", "uvs"}) {
        const std::size_t count = key[0] == 'n' ? mesh->normals.size() : mesh->uvs.size();
        if (reader.good() && count != 0 && count != mesh->positions.size()) {
            reader.error(
                key, fmt::format("\"{}\" must have one entry for each of the {} positions, not {}", key, mesh->positions.size(), count));
        }
    }
    mesh->colors = read_colors(reader, "colors", mesh->positions.size(), "positions");
    mesh->face_colors = read_colors(reader, "face_colors", mesh->triangles.size(), "triangles");
    if (reader.good()) {
        check_inline_corners(reader, *mesh);
    }
    if (reader.good()) {
        MeshMessages messages(context.messages.file(), context.messages.diagnostics());
        const SourcePosition position = reader.position();
        if (check_mesh(*mesh, messages, position.line, position.column)) {
            return mesh;
        }
    }
    return nullptr;
}

MaybeShape read_mesh(Context& context, TableReader& reader) {
    scene::Mesh mesh;
    mesh.smooth = reader.flag("smooth");
    if (reader.has("file")) {
        for (const char* key : {"positions", "triangles", "normals", "uvs", "colors", "face_colors"}) {
            if (reader.has(key)) {
                reader.error(key, fmt::format("a mesh has either \"file\" or \"{}\"", key));
            }
        }
        const std::string file = reader.text("file");
        if (!file.empty()) {
            mesh.data = context.files.mesh(path_beside(context.messages.file(), file), reader.position("file"),
                                           static_cast<std::size_t>(reader.integer("part")));
        }
    } else if (!reader.has("positions") || !reader.has("triangles")) {
        reader.error(reader.position(), "a mesh needs \"file\", or \"positions\" and \"triangles\"");
    } else {
        mesh.data = read_inline_mesh(context, reader);
    }
    return mesh.data ? MaybeShape(mesh) : std::nullopt;
}

MaybeShape read_shape(Context& context, TableReader& reader) {
    const std::string_view name = reader.description().name;
    if (name == "sphere") {
        return read_sphere(reader);
    }
    if (name == "box") {
        return read_box(reader);
    }
    if (name == "plane") {
        return read_plane(reader);
    }
    if (name == "disk") {
        return read_disk(reader);
    }
    if (name == "cylinder") {
        return read_cylinder(reader);
    }
    if (name == "cone") {
        return read_cone(reader);
    }
    assert(name == "mesh");
    return read_mesh(context, reader);
}

}  // namespace

std::optional<scene::Object> read_object(Context& context, Materials& materials, const toml::table& table, std::size_t kind) {
    TableReader reader(context.messages, table, *shapes()[kind]);
    scene::Object object;
    object.position = reader.position();
    object.name = reader.text("name");
    MaybeShape shape = read_shape(context, reader);
    object.material = materials.read(reader, "material");
    if (object.material < 0) {
        object.material = materials.preset();
    }
    object.to_parent = read_transform(reader);
    if (!shape) {
        return std::nullopt;
    }
    object.shape = std::move(*shape);
    return object;
}

}  // namespace lancer::notation
