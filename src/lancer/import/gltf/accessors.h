// Typed arrays in a glTF file's bytes: any component type, interleaved, sparse, normalized.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "lancer/import/gltf/buffers.h"
#include "lancer/import/gltf/document.h"

namespace lancer::gltf {

enum class Component : int { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

std::size_t size_of(Component component);

// An accessor whose bytes have been found to be there.
struct Accessor {
    Json json;
    std::size_t count = 0;
    std::size_t components = 0;  // of an element: 1 to 16
    std::size_t rows = 0;        // of a matrix's column; else as many as components
    Component component = Component::f32;
    bool normalized = false;
    std::string_view bytes;  // from the first element on; empty: zeros
    std::size_t stride = 0;

    // What stands at other places than the bytes say.
    std::size_t sparse_count = 0;
    Component sparse_component = Component::u16;
    std::string_view sparse_indices;
    std::string_view sparse_values;
};

class Accessors {
public:
    Accessors(Document& document, Buffers& buffers) : document_(document), buffers_(buffers) {}

    // Of an item of "accessors". Nothing after an error, which is said once.
    std::optional<Accessor> open(Json accessor);

    // count * components values, element after element; normalized integers become -1 to 1 or 0 to 1. Nothing when more memory would be taken
    // than the file's size explains.
    std::optional<std::vector<float>> floats(const Accessor& accessor);

    // The same for values that are whole by nature, such as indices; floats are errors.
    std::optional<std::vector<std::uint32_t>> naturals(const Accessor& accessor);

    // All bytes of an item of "bufferViews"; nothing after an error.
    std::optional<std::string_view> view(std::size_t index) { return buffers_.view(index); }

    // A short name of what its elements are: "VEC3 of f32".
    static std::string kind(const Accessor& accessor);

private:
    bool open_sparse(Accessor& accessor);
    bool allow(Json at, std::size_t bytes);

    Document& document_;
    Buffers& buffers_;
    std::size_t taken_ = 0;
};

}  // namespace lancer::gltf
