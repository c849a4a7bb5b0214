// What a PLY file says about itself before its data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/import/mesh/mesh_messages.h"

namespace lancer::ply {

enum class Format { ascii, little_endian, big_endian };

enum class Type : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::size_t size_of(Type type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

constexpr bool is_whole(Type type) { return type < Type::float32; }

struct Property {
    std::string name;
    Type type = Type::float32;
    bool is_list = false;
    Type count_type = Type::uint8;  // of a list
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
    int line = 0;

    // -1 when there is none of that name.
    int find(std::string_view property) const;
    bool has_lists() const;
    // Bytes of one in binary data, lists being empty.
    std::size_t smallest_size() const;
};

struct Header {
    Format format = Format::ascii;
    std::vector<Element> elements;
    std::size_t size = 0;  // bytes before the data
    int lines = 0;
};

// Nothing when there are errors.
std::optional<Header> read_header(std::string_view bytes, MeshMessages& messages);

}  // namespace lancer::ply
