#include "lancer/import/ply/ply_data.h"

#include <algorithm>

namespace lancer::ply {

void Data::add_face(const std::uint32_t* numbers, std::size_t count) {
    if (count == 3) {
        mesh.triangles.push_back({numbers[0], numbers[1], numbers[2]});
    } else {
        add_large_face(numbers, count);
    }
}

void Data::add_large_face(const std::uint32_t* numbers, std::size_t count) {
    if (count > 3) {
        corners.insert(corners.end(), numbers, numbers + count);
        face_ends.push_back(corners.size());
    } else {
        ++small_faces;
    }
}

void Data::add_strip(const std::uint32_t* numbers, std::size_t count) {
    constexpr std::uint32_t restart = 0xffffffffu;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (numbers[i] == restart) {
            begin = i + 1;
        } else if (i >= begin + 2) {
            const bool turned = (i - begin) % 2 == 1;
            mesh.triangles.push_back({numbers[i - 2], numbers[turned ? i : i - 1], numbers[turned ? i - 1 : i]});
        }
    }
}

Meaning meaning_of(const Element& element) {
    if (element.name == "vertex") {
        return Meaning::vertices;
    }
    if (element.name == "face") {
        return Meaning::faces;
    }
    return element.name == "tristrips" ? Meaning::strips : Meaning::nothing;
}

Columns vertex_columns(const Element& vertices) {
    constexpr std::array<std::array<const char*, 2>, 4> uv_names = {
        {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}};
    const auto scalar = [&](std::string_view name) {
        const int found = vertices.find(name);
        return found >= 0 && !vertices.properties[static_cast<std::size_t>(found)].is_list ? found : -1;
    };
    Columns columns{scalar("x"), scalar("y"), scalar("z"),   scalar("nx"),    scalar("ny"),   scalar("nz"),
                    -1,          -1,          scalar("red"), scalar("green"), scalar("blue"), scalar("alpha")};
    if (columns[nx] < 0 || columns[ny] < 0 || columns[nz] < 0) {
        columns[nx] = columns[ny] = columns[nz] = -1;
    }
    if (columns[red] < 0 || columns[green] < 0 || columns[blue] < 0) {
        columns[red] = columns[green] = columns[blue] = columns[alpha] = -1;
    }
    for (const auto& names : uv_names) {
        if (columns[u] < 0 && scalar(names[0]) >= 0 && scalar(names[1]) >= 0) {
            columns[u] = scalar(names[0]);
            columns[v] = scalar(names[1]);
        }
    }
    return columns;
}

int corner_list(const Element& faces) {
    for (const char* name : {"vertex_indices", "vertex_index"}) {
        const int found = faces.find(name);
        if (found >= 0) {
            const Property& property = faces.properties[static_cast<std::size_t>(found)];
            return property.is_list && is_whole(property.type) ? found : -1;
        }
    }
    return -1;
}

std::array<Destination, role_count> make_room(scene::TriangleMesh& mesh, std::size_t count, const Columns& columns) {
    std::array<Destination, role_count> to{};
    if (count == 0) {
        return to;
    }
    mesh.positions.resize(count);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        to[x + axis] = {&mesh.positions.data()->x + axis, 3};
    }
    if (columns[nx] >= 0) {
        mesh.normals.resize(count);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            to[nx + axis] = {&mesh.normals.data()->x + axis, 3};
        }
    }
    if (columns[u] >= 0) {
        mesh.uvs.resize(count);
        to[u] = {&mesh.uvs.data()->x, 2};
        to[v] = {&mesh.uvs.data()->x + 1, 2};
    }
    if (columns[red] >= 0) {
        mesh.colors.assign(count, glm::vec4(1.0f));
        for (std::size_t channel = 0; channel < 4; ++channel) {
            if (columns[red + channel] >= 0) {
                to[red + channel] = {&mesh.colors.data()->x + channel, 4};
            }
        }
    }
    return to;
}

}  // namespace lancer::ply
