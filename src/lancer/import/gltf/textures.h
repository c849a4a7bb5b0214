// Textures of materials: pictures, samplers and KHR_texture_transform.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "lancer/import/gltf/buffers.h"
#include "lancer/import/gltf/document.h"
#include "lancer/import/gltf/geometry.h"
#include "lancer/import/scene_files.h"
#include "lancer/scene/textures.h"

namespace lancer::gltf {

class Textures {
public:
    Textures(Document& document, Buffers& buffers, SceneFiles& files) : document_(document), buffers_(buffers), files_(files) {}

    // What a "textureInfo" stands for; nothing where it is missing or can't be used, which has been said. `linear`: numbers, not colours. The
    // texture's set of coordinates goes into `wishes`.
    std::optional<scene::ImageTexture> of(Json info, bool linear, Wishes& wishes);

private:
    // A picture: a file, or bytes within this one.
    struct Picture {
        bool is_usable = false;
        std::string name;
        std::shared_ptr<const std::string> bytes;
    };

    const Picture& picture(std::size_t index);
    Picture open(Json image, std::size_t index);
    void set_sampler(Json sampler, scene::ImageTexture& texture) const;
    void set_transform(Json info, scene::ImageTexture& texture);
    int uv_set(Json info, Wishes& wishes);

    Document& document_;
    Buffers& buffers_;
    SceneFiles& files_;
    std::map<std::size_t, Picture> pictures_;
};

}  // namespace lancer::gltf
