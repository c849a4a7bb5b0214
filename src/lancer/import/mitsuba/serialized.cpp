#include "lancer/import/mitsuba/serialized.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include "lancer/import/mesh/mesh_check.h"
#include "lancer/import/mesh/mesh_messages.h"

namespace lancer::mitsuba {

namespace {

constexpr std::uint16_t magic = 0x041c;
constexpr std::uint32_t has_normals = 0x0001;
constexpr std::uint32_t has_uvs = 0x0002;
constexpr std::uint32_t has_colors = 0x0008;
constexpr std::uint32_t is_faceted = 0x0010;
constexpr std::uint32_t is_double = 0x2000;

// zlib makes at most this many bytes of one: counts beyond it are lies.
constexpr std::uint64_t largest_ratio = 1032;

template <class T>
std::optional<T> load(std::string_view bytes, std::size_t at) {
    if (at > bytes.size() || bytes.size() - at < sizeof(T)) {
        return std::nullopt;
    }
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof(T));
    return value;
}

// A zlib stream, read from piece by piece.
class Inflater {
public:
    explicit Inflater(std::string_view bytes) {
        bytes = bytes.substr(0, std::min<std::size_t>(bytes.size(), 0xfffffff0u));
        stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
        stream_.avail_in = static_cast<uInt>(bytes.size());
        open_ = inflateInit(&stream_) == Z_OK;
    }
    ~Inflater() {
        if (open_) {
            inflateEnd(&stream_);
        }
    }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    bool read(void* to, std::size_t size) {
        auto* place = static_cast<Bytef*>(to);
        while (open_ && size > 0) {
            const auto part = static_cast<uInt>(std::min<std::size_t>(size, std::size_t{1} << 30));
            stream_.next_out = place;
            stream_.avail_out = part;
            const int state = inflate(&stream_, Z_NO_FLUSH);
            const std::size_t got = part - stream_.avail_out;
            place += got;
            size -= got;
            if ((state != Z_OK && state != Z_STREAM_END) || (got == 0 && size > 0) || (state == Z_STREAM_END && size > 0)) {
                return false;
            }
        }
        return open_;
    }
    template <class T>
    bool read(T& value) {
        return read(&value, sizeof(T));
    }
    // `count` numbers of one kind as floats.
    bool read(std::vector<float>& values, std::size_t count, bool doubles) {
        values.resize(count);
        if (!doubles) {
            return read(values.data(), count * sizeof(float));
        }
        std::vector<double> wide(count);
        if (!read(wide.data(), count * sizeof(double))) {
            return false;
        }
        std::transform(wide.begin(), wide.end(), values.begin(), [](double v) { return static_cast<float>(v); });
        return true;
    }

private:
    z_stream stream_{};
    bool open_ = false;
};

bool read_mesh(Inflater& stream, std::uint16_t version, std::uint64_t most_bytes, scene::TriangleMesh& mesh) {
    std::uint32_t flags = 0;
    char letter = 1;
    std::uint64_t vertices = 0, triangles = 0;
    bool good = stream.read(flags);
    while (good && version >= 4 && letter != 0) {
        good = stream.read(letter);
    }
    if (!good || !stream.read(vertices) || !stream.read(triangles)) {
        return false;
    }
    const bool doubles = (flags & is_double) != 0;
    const auto floats = static_cast<std::uint64_t>(3 + ((flags & has_normals) != 0 ? 3 : 0) + ((flags & has_uvs) != 0 ? 2 : 0) +
                                                   ((flags & has_colors) != 0 ? 3 : 0));
    if (vertices == 0 || triangles == 0 || vertices > 0xffffffffu || vertices > most_bytes / (floats * (doubles ? 8 : 4)) ||
        triangles > most_bytes / 12) {
        return false;
    }
    const auto count = static_cast<std::size_t>(vertices);
    std::vector<float> numbers;
    if (!stream.read(numbers, 3 * count, doubles)) {
        return false;
    }
    mesh.positions.resize(count);
    std::memcpy(mesh.positions.data(), numbers.data(), 12 * count);
    if ((flags & has_normals) != 0) {
        if (!stream.read(numbers, 3 * count, doubles)) {
            return false;
        }
        mesh.normals.resize((flags & is_faceted) != 0 ? 0 : count);
        std::memcpy(mesh.normals.data(), numbers.data(), 12 * mesh.normals.size());
    }
    if ((flags & has_uvs) != 0) {
        if (!stream.read(numbers, 2 * count, doubles)) {
            return false;
        }
        mesh.uvs.resize(count);
        std::memcpy(mesh.uvs.data(), numbers.data(), 8 * count);
    }
    if ((flags & has_colors) != 0 && !stream.read(numbers, 3 * count, doubles)) {
        return false;
    }
    mesh.triangles.resize(static_cast<std::size_t>(triangles));
    return stream.read(mesh.triangles.data(), 12 * mesh.triangles.size());
}

}  // namespace

std::optional<scene::TriangleMesh> read_serialized(std::string_view bytes, int number, const std::string& file, Diagnostics& diagnostics) {
    MeshMessages messages(file, diagnostics);
    const auto first = load<std::uint16_t>(bytes, 0);
    const auto version = load<std::uint16_t>(bytes, 2);
    if (first != magic || !version || *version < 3 || *version > 4) {
        messages.error(0, 0, "expected a serialized mesh of version 3 or 4");
        return std::nullopt;
    }
    // The file ends with the places of its meshes and their count.
    const auto meshes = bytes.size() < 4 ? std::nullopt : load<std::uint32_t>(bytes, bytes.size() - 4);
    const std::size_t width = *version == 4 ? 8 : 4;
    if (!meshes || *meshes > (bytes.size() - 4) / width || number < 0 || static_cast<std::uint32_t>(number) >= *meshes) {
        messages.error(0, 0, fmt::format("there is no mesh number {} in this file", number));
        return std::nullopt;
    }
    const std::size_t entry = bytes.size() - 4 - width * (*meshes - static_cast<std::size_t>(number));
    const std::uint64_t begin =
        *version == 4 ? load<std::uint64_t>(bytes, entry).value_or(0) : load<std::uint32_t>(bytes, entry).value_or(0);
    if (begin > bytes.size() || bytes.size() - begin < 4) {
        messages.error(0, 0, fmt::format("mesh number {} begins behind the end of the file", number));
        return std::nullopt;
    }
    const std::string_view packed = bytes.substr(static_cast<std::size_t>(begin) + 4);
    Inflater stream(packed);
    scene::TriangleMesh mesh;
    if (!read_mesh(stream, *version, std::min<std::uint64_t>(packed.size() * largest_ratio, std::uint64_t{1} << 30), mesh)) {
        messages.error(0, 0, fmt::format("mesh number {} is damaged, or too large", number));
        return std::nullopt;
    }
    return check_mesh(mesh, messages) ? std::optional(std::move(mesh)) : std::nullopt;
}

}  // namespace lancer::mitsuba
