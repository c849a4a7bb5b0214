#include "lancer/import/gltf/meshopt.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "lancer/import/gltf/meshopt_filters.h"
#include "lancer/import/gltf/meshopt_indices.h"

namespace lancer::gltf {

namespace {

constexpr std::size_t group_size = 16;  // elements whose bytes are packed together
constexpr std::uint8_t attributes_header = 0xA0;

std::uint8_t from_zigzag(std::uint8_t v) { return static_cast<std::uint8_t>((v >> 1) ^ -(v & 1)); }

// Byte `k` of 16 elements, as differences: all 0, or of 2, 4 or 8 bits; the largest of the packed ones stands for a byte that follows them.
bool unpack_group(std::string_view& data, unsigned packing, std::uint8_t* differences) {
    if (packing == 0) {
        std::memset(differences, 0, group_size);
        return true;
    }
    const unsigned bits = packing == 1 ? 2 : packing == 2 ? 4 : 8;
    const std::size_t packed = group_size * bits / 8;
    if (data.size() < packed) {
        return false;
    }
    if (bits == 8) {
        std::memcpy(differences, data.data(), group_size);
        data.remove_prefix(packed);
        return true;
    }
    const unsigned escape = (1u << bits) - 1;
    std::size_t next = packed;
    for (std::size_t i = 0; i < group_size; ++i) {
        const auto byte = static_cast<unsigned char>(data[i * bits / 8]);
        const unsigned value = byte >> (8 - bits - i * bits % 8) & escape;
        if (value == escape) {
            if (next >= data.size()) {
                return false;
            }
            differences[i] = static_cast<std::uint8_t>(data[next++]);
        } else {
            differences[i] = static_cast<std::uint8_t>(value);
        }
    }
    data.remove_prefix(next);
    return true;
}

// [Kapoulkine 2021, mode 0]
bool decode_attributes(const MeshoptView& view, std::string& elements, std::string& problem) {
    const std::size_t stride = view.stride;
    const std::size_t tail = std::max<std::size_t>(stride, 32);
    if (stride == 0 || stride > 256 || stride % 4 != 0) {
        problem = fmt::format("elements of {} bytes: expected a multiple of 4 up to 256", stride);
        return false;
    }
    if (view.bytes.size() < 1 + tail || static_cast<std::uint8_t>(view.bytes[0]) != attributes_header) {
        problem = "these are no compressed attributes of the version that EXT_meshopt_compression uses";
        return false;
    }
    std::string_view data = view.bytes.substr(1, view.bytes.size() - 1 - tail);
    std::uint8_t before[256];
    std::memcpy(before, view.bytes.data() + view.bytes.size() - stride, stride);
    const std::size_t most = std::min<std::size_t>((8192 / stride) & ~(group_size - 1), 256);
    for (std::size_t first = 0; first < view.count; first += most) {
        const std::size_t count = std::min(most, view.count - first);
        const std::size_t groups = (count + group_size - 1) / group_size;
        for (std::size_t k = 0; k < stride; ++k) {
            const std::size_t header = (groups + 3) / 4;
            if (data.size() < header) {
                problem = "the compressed attributes end too early";
                return false;
            }
            const std::string_view packings = data.substr(0, header);
            data.remove_prefix(header);
            std::uint8_t value = before[k];
            for (std::size_t g = 0; g < groups; ++g) {
                std::uint8_t differences[group_size];
                const unsigned packing = static_cast<unsigned char>(packings[g / 4]) >> (g % 4 * 2) & 3;
                if (!unpack_group(data, packing, differences)) {
                    problem = "the compressed attributes end too early";
                    return false;
                }
                const std::size_t here = std::min(group_size, count - g * group_size);
                for (std::size_t i = 0; i < here; ++i) {
                    value = static_cast<std::uint8_t>(value + from_zigzag(differences[i]));
                    elements[(first + g * group_size + i) * stride + k] = static_cast<char>(value);
                }
            }
            before[k] = value;
        }
    }
    if (!data.empty()) {
        problem = fmt::format("{} bytes of the compressed attributes are left over", data.size());
        return false;
    }
    return true;
}

}  // namespace

std::optional<std::string> decode_meshopt(const MeshoptView& view, std::string& problem) {
    // Sixteen equal bytes take two bits, a triangle at least one byte: nothing unpacks to more.
    constexpr std::size_t best = 64;
    if (view.stride == 0 || view.count > (view.bytes.size() + 256) * best / view.stride) {
        problem = fmt::format("{} elements of {} bytes can't come from {} bytes", view.count, view.stride, view.bytes.size());
        return std::nullopt;
    }
    std::string elements(view.count * view.stride, '\0');
    bool decoded = false;
    if (view.mode == "ATTRIBUTES") {
        decoded = decode_attributes(view, elements, problem);
    } else if (view.stride != 2 && view.stride != 4) {
        problem = fmt::format("indices of {} bytes: expected 2 or 4", view.stride);
    } else if (view.mode == "TRIANGLES") {
        decoded = decode_triangles(view, elements, problem);
    } else if (view.mode == "INDICES") {
        decoded = decode_indices(view, elements, problem);
    } else {
        problem = fmt::format("\"{}\": expected ATTRIBUTES, TRIANGLES or INDICES", view.mode.substr(0, 80));
    }
    if (!decoded || !apply_filter(view, elements, problem)) {
        return std::nullopt;
    }
    return elements;
}

}  // namespace lancer::gltf
