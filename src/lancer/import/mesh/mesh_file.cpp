#include "lancer/import/mesh/mesh_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include <fmt/format.h>

namespace lancer {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

constexpr std::string_view signature = "lancer meshes 1\n";
constexpr float farthest = 1e15f;  // metres: squares stay finite in single precision

// All arrays of a mesh, in the order of the file: a new one does not compile before it stands here.
template <class Mesh, class Function>
void for_each_array(Mesh& mesh, const Function& function) {
    auto& [positions, normals, uvs, triangles, second_uvs, tangents, colors, face_colors] = mesh;
    function(positions);
    function(normals);
    function(uvs);
    function(second_uvs);
    function(tangents);
    function(colors);
    function(face_colors);
    function(triangles);
}

void put_count(std::string& bytes, std::uint64_t count) {
    char raw[sizeof(count)];
    std::memcpy(raw, &count, sizeof(count));
    bytes.append(raw, sizeof(count));
}

class MeshBytes {
public:
    MeshBytes(std::string_view bytes, const std::string& file, Diagnostics& diagnostics)
        : bytes_(bytes), file_(file), diagnostics_(diagnostics) {}

    std::vector<std::shared_ptr<const scene::TriangleMesh>> read() {
        std::vector<std::shared_ptr<const scene::TriangleMesh>> meshes;
        if (!bytes_.starts_with(signature)) {
            fail("this is no file of meshes: it should begin with \"lancer meshes 1\"");
            return {};
        }
        at_ = signature.size();
        const std::optional<std::uint64_t> count = read_count();
        if (!count || *count > bytes_.size() / 64) {
            fail("the number of meshes is larger than the file");
            return {};
        }
        for (std::uint64_t i = 0; i < *count && !failed_; ++i) {
            meshes.push_back(read_mesh(i));
        }
        if (!failed_ && at_ != bytes_.size()) {
            fail("there is more in this file than its meshes");
        }
        return failed_ ? std::vector<std::shared_ptr<const scene::TriangleMesh>>() : meshes;
    }

private:
    void fail(std::string what) {
        if (!failed_) {
            diagnostics_.error({file_, 0, 0, static_cast<std::int64_t>(at_)}, std::move(what));
        }
        failed_ = true;
    }

    std::optional<std::uint64_t> read_count() {
        std::uint64_t count = 0;
        if (bytes_.size() - at_ < sizeof(count)) {
            return std::nullopt;
        }
        std::memcpy(&count, bytes_.data() + at_, sizeof(count));
        at_ += sizeof(count);
        return count;
    }

    std::shared_ptr<const scene::TriangleMesh> read_mesh(std::uint64_t number) {
        auto mesh = std::make_shared<scene::TriangleMesh>();
        std::array<std::uint64_t, 8> counts{};
        for (std::uint64_t& count : counts) {
            const auto read = read_count();
            if (!read) {
                fail(fmt::format("the file ends in mesh {}", number));
                return nullptr;
            }
            count = *read;
        }
        std::size_t next = 0;
        for_each_array(*mesh, [&](auto& array) {
            using Element = typename std::decay_t<decltype(array)>::value_type;
            const std::uint64_t count = counts[next++];
            if (failed_ || count > (bytes_.size() - at_) / sizeof(Element)) {
                fail(fmt::format("mesh {} says that it has more than the file holds", number));
                return;
            }
            array.resize(count);
            if (count > 0) {
                std::memcpy(static_cast<void*>(array.data()), bytes_.data() + at_, count * sizeof(Element));
            }
            at_ += count * sizeof(Element);
        });
        if (!failed_) {
            check(*mesh, number);
        }
        return mesh;
    }

    template <class Vector>
    void check_numbers(const std::vector<Vector>& array, std::uint64_t number, const char* what, float most) {
        for (std::size_t i = 0; i < array.size(); ++i) {
            for (int k = 0; k < Vector::length(); ++k) {
                if (!(std::abs(array[i][k]) <= most)) {
                    fail(fmt::format("mesh {}: {} {} is {}; expected at most {:g}", number, what, i, array[i][k], most));
                    return;
                }
            }
        }
    }

    void check(const scene::TriangleMesh& mesh, std::uint64_t number) {
        const std::size_t vertices = mesh.positions.size();
        const auto fits = [&](std::size_t count) { return count == 0 || count == vertices; };
        if (!fits(mesh.normals.size()) || !fits(mesh.uvs.size()) || !fits(mesh.second_uvs.size()) || !fits(mesh.tangents.size()) ||
            !fits(mesh.colors.size()) || !(mesh.face_colors.empty() || mesh.face_colors.size() == mesh.triangles.size())) {
            fail(fmt::format("mesh {}: what belongs to its vertices or triangles must be as many as they are", number));
            return;
        }
        if (mesh.triangles.empty()) {
            fail(fmt::format("mesh {} has no triangles", number));
        }
        check_numbers(mesh.positions, number, "position", farthest);
        check_numbers(mesh.normals, number, "normal", 2.0f);
        check_numbers(mesh.uvs, number, "texture coordinate", std::numeric_limits<float>::max());
        check_numbers(mesh.second_uvs, number, "texture coordinate", std::numeric_limits<float>::max());
        check_numbers(mesh.tangents, number, "tangent", 2.0f);
        check_numbers(mesh.colors, number, "colour", std::numeric_limits<float>::max());
        check_numbers(mesh.face_colors, number, "colour", std::numeric_limits<float>::max());
        for (const glm::uvec3& triangle : mesh.triangles) {
            if (std::max({triangle.x, triangle.y, triangle.z}) >= vertices) {
                fail(fmt::format("mesh {}: a triangle names vertex {} of {}", number, std::max({triangle.x, triangle.y, triangle.z}),
                                 vertices));
                return;
            }
        }
    }

    std::string_view bytes_;
    const std::string& file_;
    Diagnostics& diagnostics_;
    std::size_t at_ = 0;
    bool failed_ = false;
};

}  // namespace

std::string write_meshes(const std::vector<std::shared_ptr<const scene::TriangleMesh>>& meshes) {
    std::string bytes(signature);
    put_count(bytes, meshes.size());
    for (const auto& mesh : meshes) {
        for_each_array(*mesh, [&](const auto& array) { put_count(bytes, array.size()); });
        for_each_array(*mesh, [&](const auto& array) {
            bytes.append(reinterpret_cast<const char*>(array.data()), array.size() * sizeof(array.front()));
        });
    }
    return bytes;
}

std::vector<std::shared_ptr<const scene::TriangleMesh>> read_meshes(std::string_view bytes, const std::string& file,
                                                                    Diagnostics& diagnostics) {
    return MeshBytes(bytes, file, diagnostics).read();
}

}  // namespace lancer
