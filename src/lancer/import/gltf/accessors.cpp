#include "lancer/import/gltf/accessors.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

namespace lancer::gltf {

namespace {

std::size_t components_of(std::string_view type) {
    constexpr std::pair<std::string_view, std::size_t> types[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                                  {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    for (const auto& [name, components] : types) {
        if (name == type) {
            return components;
        }
    }
    return 0;
}

// Columns of matrices begin at multiples of 4 bytes.
std::size_t element_size(const Accessor& accessor) {
    const std::size_t column = accessor.rows * size_of(accessor.component);
    const std::size_t columns = accessor.components / accessor.rows;
    return columns == 1 ? column : (column + 3) / 4 * 4 * columns;
}

template <class Stored>
Stored load(const char* bytes) {
    Stored value;
    std::memcpy(&value, bytes, sizeof(Stored));
    return value;
}

// One component as a number. Normalized integers as [Khronos 2021, section 3.6.2.2] has them.
template <class Stored>
struct AsFloat {
    bool normalized;
    float operator()(const char* bytes) const {
        const auto value = static_cast<float>(load<Stored>(bytes));
        if constexpr (std::is_same_v<Stored, float>) {
            return value;
        } else {
            return normalized ? std::max(value / static_cast<float>(std::numeric_limits<Stored>::max()), -1.0f) : value;
        }
    }
};

template <class Stored>
struct AsNatural {
    std::uint32_t operator()(const char* bytes) const { return static_cast<std::uint32_t>(load<Stored>(bytes)); }
};

template <class Result, class Convert>
void convert_element(const Accessor& accessor, const char* bytes, Result* to, const Convert& convert) {
    const std::size_t size = size_of(accessor.component);
    const std::size_t columns = accessor.components / accessor.rows;
    const std::size_t column = columns == 1 ? 0 : (accessor.rows * size + 3) / 4 * 4;
    for (std::size_t c = 0; c < columns; ++c) {
        for (std::size_t r = 0; r < accessor.rows; ++r) {
            *to++ = convert(bytes + c * column + r * size);
        }
    }
}

std::size_t sparse_index(const Accessor& accessor, std::size_t i) {
    const char* bytes = accessor.sparse_indices.data() + i * size_of(accessor.sparse_component);
    return accessor.sparse_component == Component::u8    ? load<std::uint8_t>(bytes)
           : accessor.sparse_component == Component::u16 ? load<std::uint16_t>(bytes)
                                                         : load<std::uint32_t>(bytes);
}

template <class Result, class Convert>
void convert_all(const Accessor& accessor, std::vector<Result>& values, const Convert& convert) {
    if (!accessor.bytes.empty()) {
        for (std::size_t i = 0; i < accessor.count; ++i) {
            convert_element(accessor, accessor.bytes.data() + i * accessor.stride, &values[i * accessor.components], convert);
        }
    }
    for (std::size_t i = 0; i < accessor.sparse_count; ++i) {
        convert_element(accessor, accessor.sparse_values.data() + i * element_size(accessor),
                        &values[sparse_index(accessor, i) * accessor.components], convert);
    }
}

}  // namespace

std::size_t size_of(Component component) {
    switch (component) {
        case Component::i8:
        case Component::u8:
            return 1;
        case Component::i16:
        case Component::u16:
            return 2;
        default:
            return 4;
    }
}

std::string Accessors::kind(const Accessor& accessor) {
    constexpr std::pair<Component, std::string_view> names[] = {
        {Component::i8, "signed bytes"},           {Component::u8, "unsigned bytes"},
        {Component::i16, "signed 16-bit numbers"}, {Component::u16, "unsigned 16-bit numbers"},
        {Component::u32, "32-bit numbers"},        {Component::f32, "floats"},
    };
    for (const auto& [component, name] : names) {
        if (component == accessor.component) {
            return fmt::format("{} of {}{}", accessor.json.text("type"), accessor.normalized ? "normalized " : "", name);
        }
    }
    return {};
}

bool Accessors::allow(Json at, std::size_t bytes) {
    // A file may use its bytes several times over, for example for many primitives, but not without end.
    constexpr std::size_t always = std::size_t{256} << 20;
    constexpr std::size_t often = 16;
    const std::size_t most = std::min(always + often * buffers_.total(), std::max(std::size_t{1} << 30, 4 * buffers_.total()));
    if (bytes > most || taken_ > most - bytes) {
        document_.error(at, "the file asks for far more memory than its size explains");
        return false;
    }
    taken_ += bytes;
    return true;
}

std::optional<Accessor> Accessors::open(Json json) {
    if (!json) {
        return std::nullopt;
    }
    Accessor accessor;
    accessor.json = json;
    accessor.count = json.natural("count").value_or(0);
    accessor.components = components_of(json.text("type"));
    accessor.component = static_cast<Component>(json.natural("componentType").value_or(0));
    accessor.normalized = json.truth("normalized", false);
    if (accessor.components == 0 || accessor.count == 0) {
        document_.error(json, "the accessor has no elements that could be read");
        return std::nullopt;
    }
    const bool is_matrix = json.text("type").substr(0, 3) == "MAT";
    accessor.rows = !is_matrix ? accessor.components : accessor.components == 4 ? 2 : accessor.components == 9 ? 3 : 4;
    const std::size_t size = element_size(accessor);
    const auto view = json.natural("bufferView");
    const std::size_t offset = json.natural("byteOffset").value_or(0);
    if (view) {
        const auto bytes = buffers_.view(*view);
        if (!bytes) {
            return std::nullopt;
        }
        const Json view_json = document_.items("bufferViews")[*view];
        const Json packed = document_.extension(view_json, "EXT_meshopt_compression");
        accessor.stride = (packed ? packed : view_json).natural("byteStride").value_or(size);
        if (accessor.stride < size) {
            document_.error(json, fmt::format("elements of {} bytes every {} bytes", size, accessor.stride));
            return std::nullopt;
        }
        if (offset > bytes->size() || size > bytes->size() - offset ||
            (accessor.count - 1) > (bytes->size() - offset - size) / accessor.stride) {
            document_.error(json, fmt::format("{} elements of {} bytes every {} bytes from byte {} on, in a view of {} bytes",
                                              accessor.count, size, accessor.stride, offset, bytes->size()));
            return std::nullopt;
        }
        accessor.bytes = bytes->substr(offset);
    } else {
        accessor.stride = size;
    }
    if (json["sparse"] && !open_sparse(accessor)) {
        return std::nullopt;
    }
    return accessor;
}

bool Accessors::open_sparse(Accessor& accessor) {
    const Json sparse = accessor.json["sparse"];
    accessor.sparse_count = sparse.natural("count").value_or(0);
    accessor.sparse_component = static_cast<Component>(sparse["indices"].natural("componentType").value_or(5123));
    const auto part = [&](Json json, std::size_t size, std::string_view& bytes) {
        const auto number = json.natural("bufferView");
        const auto view = number && *number < document_.items("bufferViews").size() ? buffers_.view(*number) : std::nullopt;
        if (!view) {
            return false;
        }
        const std::size_t offset = json.natural("byteOffset").value_or(0);
        if (offset > view->size() || accessor.sparse_count > (view->size() - offset) / size) {
            document_.error(json, fmt::format("{} values of {} bytes from byte {} on, in a view of {} bytes", accessor.sparse_count, size,
                                              offset, view->size()));
            return false;
        }
        bytes = view->substr(offset);
        return true;
    };
    if (accessor.sparse_count > accessor.count) {
        document_.error(sparse["count"], fmt::format("{} of {} elements", accessor.sparse_count, accessor.count));
        return false;
    }
    if (!part(sparse["indices"], size_of(accessor.sparse_component), accessor.sparse_indices) ||
        !part(sparse["values"], element_size(accessor), accessor.sparse_values)) {
        return false;
    }
    for (std::size_t i = 0; i < accessor.sparse_count; ++i) {
        if (sparse_index(accessor, i) >= accessor.count || (i > 0 && sparse_index(accessor, i) <= sparse_index(accessor, i - 1))) {
            document_.error(sparse["indices"],
                            fmt::format("index {}: expected growing ones below {}", sparse_index(accessor, i), accessor.count));
            return false;
        }
    }
    return true;
}

std::optional<std::vector<float>> Accessors::floats(const Accessor& accessor) {
    const std::size_t most = static_cast<std::size_t>(-1) / 64;
    if (accessor.count > most || !allow(accessor.json, accessor.count * accessor.components * sizeof(float))) {
        return std::nullopt;
    }
    std::vector<float> values(accessor.count * accessor.components);
    const bool n = accessor.normalized;
    switch (accessor.component) {
        case Component::i8:
            convert_all(accessor, values, AsFloat<std::int8_t>{n});
            break;
        case Component::u8:
            convert_all(accessor, values, AsFloat<std::uint8_t>{n});
            break;
        case Component::i16:
            convert_all(accessor, values, AsFloat<std::int16_t>{n});
            break;
        case Component::u16:
            convert_all(accessor, values, AsFloat<std::uint16_t>{n});
            break;
        case Component::u32:
            convert_all(accessor, values, AsFloat<std::uint32_t>{n});
            break;
        case Component::f32:
            convert_all(accessor, values, AsFloat<float>{false});
            break;
    }
    return values;
}

std::optional<std::vector<std::uint32_t>> Accessors::naturals(const Accessor& accessor) {
    const std::size_t most = static_cast<std::size_t>(-1) / 64;
    if (accessor.count > most || !allow(accessor.json, accessor.count * accessor.components * sizeof(std::uint32_t))) {
        return std::nullopt;
    }
    std::vector<std::uint32_t> values(accessor.count * accessor.components);
    switch (accessor.component) {
        case Component::u8:
            convert_all(accessor, values, AsNatural<std::uint8_t>{});
            break;
        case Component::u16:
            convert_all(accessor, values, AsNatural<std::uint16_t>{});
            break;
        case Component::u32:
            convert_all(accessor, values, AsNatural<std::uint32_t>{});
            break;
        default:
            document_.error(accessor.json, fmt::format("{}: expected unsigned whole numbers", kind(accessor)));
            return std::nullopt;
    }
    return values;
}

}  // namespace lancer::gltf
