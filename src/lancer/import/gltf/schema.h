// What glTF's JSON may hold [Khronos 2021]: tables of every object's properties, and the check of a file against them.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string_view>

namespace lancer::gltf {

enum class Type {
    any,
    boolean,
    integer,
    number,
    text,
    object,      // described by the schema `of`
    index,       // into the file's array `of`
    numbers,     // arrays
    indices,     // into the file's array `of`; none twice
    objects,     // each described by the schema `of`
    texts,       // none twice
    index_map,   // an object of indices, such as the attributes of a primitive
    index_maps,  // an array of such objects
};

inline constexpr double unbounded = std::numeric_limits<double>::infinity();
inline constexpr std::size_t any_number = static_cast<std::size_t>(-1);

struct Property {
    std::string_view name;
    Type type = Type::any;
    std::string_view of = {};
    bool required = false;
    double low = -unbounded;
    double high = unbounded;
    std::string_view allowed = {};  // values, between spaces; empty: all
    std::size_t fewest = 1;         // items of arrays
    std::size_t most = any_number;
};

// The properties that every object may have, `extensions` and `extras`, are not listed.
struct Schema {
    std::string_view name;
    std::span<const Property> properties;
};

// "gltf" is the whole file; extensions are named after what they extend: "material/KHR_materials_unlit". Null for what we do not know.
const Schema* find_schema(std::string_view name);

// Of the core, and of extensions.
std::span<const Schema> core_schemas();
std::span<const Schema> extension_schemas();

}  // namespace lancer::gltf
