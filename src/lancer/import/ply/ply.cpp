#include "lancer/import/ply/ply.h"

#include <fmt/format.h>

#include <algorithm>

#include "lancer/image/image.h"
#include "lancer/import/mesh/mesh_check.h"
#include "lancer/import/mesh/polygon.h"
#include "lancer/import/ply/ply_data.h"

namespace lancer {

namespace {

using namespace ply;

// The header must promise what a mesh needs.
void check_header(const Header& header, MeshMessages& messages) {
    const Element* vertices = nullptr;
    for (const Element& element : header.elements) {
        const Meaning meaning = meaning_of(element);
        if (meaning == Meaning::vertices) {
            vertices = &element;
            const Columns columns = vertex_columns(element);
            if (columns[x] < 0 || columns[y] < 0 || columns[z] < 0) {
                messages.error(element.line, 1, "the vertices need the properties x, y and z");
            }
            if (element.count > 0xfffffffe) {
                messages.error(element.line, 1, fmt::format("too many vertices: {}", element.count));
            }
        } else if ((meaning == Meaning::faces || meaning == Meaning::strips) && element.count > 0 && corner_list(element) < 0) {
            messages.error(element.line, 1,
                           fmt::format("{} needs a list of whole numbers named vertex_indices or vertex_index", quoted(element.name)));
        }
    }
    if (!vertices) {
        messages.error(header.lines, 1, "the header has no element \"vertex\"");
    }
}

// Larger faces become triangles, now that all vertices are known.
void cut_faces(Data& data, MeshMessages& messages) {
    std::vector<glm::vec3> points;
    std::vector<std::array<std::size_t, 3>> cut;
    std::size_t begin = 0;
    for (std::size_t end : data.face_ends) {
        points.clear();
        cut.clear();
        for (std::size_t i = begin; i < end; ++i) {
            if (data.corners[i] >= data.mesh.positions.size()) {
                return messages.error(0, 0,
                                      fmt::format("a face names vertex {}, but there are {} vertices, counted from 0",
                                                  static_cast<std::int32_t>(data.corners[i]), data.mesh.positions.size()));
            }
            points.push_back(data.mesh.positions[data.corners[i]]);
        }
        cut_polygon(points, cut);
        for (const auto& triangle : cut) {
            data.mesh.triangles.push_back(
                {data.corners[begin + triangle[0]], data.corners[begin + triangle[1]], data.corners[begin + triangle[2]]});
        }
        begin = end;
    }
}

// Whole numbers are what displays take, of full scale 255 or 65535; others are linear light.
void decode_colors(const Header& header, std::vector<glm::vec4>& colors) {
    for (const Element& element : header.elements) {
        if (meaning_of(element) != Meaning::vertices || colors.empty()) {
            continue;
        }
        const Columns columns = vertex_columns(element);
        for (int channel = 0; channel < 4; ++channel) {
            const int column = columns[static_cast<std::size_t>(red + channel)];
            if (column < 0 || !is_whole(element.properties[static_cast<std::size_t>(column)].type)) {
                continue;
            }
            const std::size_t size = size_of(element.properties[static_cast<std::size_t>(column)].type);
            const float full = size == 1 ? 255.0f : size == 2 ? 65535.0f : 4294967295.0f;
            for (glm::vec4& color : colors) {
                const float share = std::clamp(color[channel] / full, 0.0f, 1.0f);
                color[channel] = channel < 3 ? srgb_decode(share) : share;
            }
        }
    }
}

}  // namespace

std::optional<scene::TriangleMesh> read_ply(std::string_view bytes, const std::string& file, Diagnostics& diagnostics) {
    MeshMessages messages(file, diagnostics);
    const std::optional<Header> header = read_header(bytes, messages);
    if (header) {
        check_header(*header, messages);
    }
    if (!header || messages.has_errors()) {
        return std::nullopt;
    }

    Data data;
    const std::string_view body = bytes.substr(header->size);
    header->format == Format::ascii ? read_ascii(body, *header, data, messages) : read_binary(body, *header, data, messages);
    if (messages.has_errors()) {
        return std::nullopt;
    }
    cut_faces(data, messages);
    decode_colors(*header, data.mesh.colors);
    if (data.small_faces > 0) {
        messages.warning(0, 0, fmt::format("{} faces with less than three corners are left out", data.small_faces));
    }
    if (!check_mesh(data.mesh, messages)) {
        return std::nullopt;
    }
    return std::move(data.mesh);
}

}  // namespace lancer
