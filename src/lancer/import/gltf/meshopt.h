// Buffer views compressed as EXT_meshopt_compression says [Kapoulkine 2021].
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace lancer::gltf {

struct MeshoptView {
    std::string_view bytes;
    std::size_t count = 0;   // elements
    std::size_t stride = 0;  // bytes of each
    std::string_view mode;   // ATTRIBUTES, TRIANGLES or INDICES
    std::string_view filter = "NONE";
};

// count * stride bytes, or nothing and the problem in a sentence.
std::optional<std::string> decode_meshopt(const MeshoptView& view, std::string& problem);

}  // namespace lancer::gltf
