// The bytes that a glTF file is about: from files beside it, from data URIs, from its binary chunk.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/base/file.h"
#include "lancer/import/gltf/document.h"
#include "lancer/import/scene_files.h"

namespace lancer::gltf {

class Buffers {
public:
    Buffers(Document& document, SceneFiles& files);

    // All bytes of an item of "bufferViews", decompressed where it is compressed; nothing after an error. Valid as long as this object.
    std::optional<std::string_view> view(std::size_t index);

    // What has been read so far, in bytes: what memory the reader may take goes by this.
    std::size_t total() const { return total_; }

private:
    // Read when first asked for.
    struct Kept {
        bool is_known = false;
        std::optional<std::string_view> bytes;
        FileBytes file;
        std::string decoded;
    };

    std::optional<std::string_view> buffer(std::size_t index);
    void load(std::size_t index, Kept& kept);
    void load_uri(Json buffer, Kept& kept);
    void decompress(Json compression, Kept& kept);
    std::optional<std::string_view> part(Json view);

    Document& document_;
    SceneFiles& files_;
    std::vector<Kept> buffers_;
    std::vector<Kept> views_;
    std::size_t total_ = 0;
};

}  // namespace lancer::gltf
