#include "lancer/world/textures.h"

#include <cmath>
#include <stdexcept>

#include <glm/trigonometric.hpp>

#include "lancer/world/texels.h"

namespace lancer {

namespace {

int wrap_of(scene::Wrap wrap) {
    return wrap == scene::Wrap::repeat ? kernel::WRAP_REPEAT : wrap == scene::Wrap::clamp ? kernel::WRAP_CLAMP : kernel::WRAP_MIRROR;
}

int look_of(scene::Filter filter) {
    return filter == scene::Filter::nearest    ? kernel::LOOK_NEAREST
           : filter == scene::Filter::bilinear ? kernel::LOOK_BILINEAR
                                               : kernel::LOOK_MIPMAPS;
}

kernel::TextureRecord plain_texture(int kind) {
    kernel::TextureRecord texture{};
    texture.kind = kind;
    texture.size = 1.0f;
    texture.row_u = kernel::vec3(1.0f, 0.0f, 0.0f);
    texture.row_v = kernel::vec3(0.0f, 1.0f, 0.0f);
    return texture;
}

void set_tint(const scene::Rgb& tint, kernel::TextureRecord& texture) {
    texture.first = kernel::vec3(tint);
    texture.tint = tint == scene::Rgb(1.0) ? kernel::TINT_NONE : kernel::TINT_FIRST;
}

}  // namespace

CompiledTexture Textures::add(const scene::Texture& texture) {
    return std::visit([&](const auto& kind) { return compile(kind); }, texture);
}

CompiledTexture Textures::compile(const scene::Color& color) { return {-1, color}; }

CompiledTexture Textures::compile(const scene::Checker& checker) {
    kernel::TextureRecord texture = plain_texture(checker.solid ? kernel::TEXTURE_CHECKER_SOLID : kernel::TEXTURE_CHECKER_UV);
    texture.first = kernel::vec3(checker.first);
    texture.second = kernel::vec3(checker.second);
    texture.size = static_cast<float>(checker.size);
    return push(texture);
}

CompiledTexture Textures::compile(const scene::MeshColors& colors) {
    kernel::TextureRecord texture = plain_texture(colors.of_faces ? kernel::TEXTURE_FACE_COLOR : kernel::TEXTURE_VERTEX_COLOR);
    set_tint(colors.tint, texture);
    return push(texture);
}

CompiledTexture Textures::compile(const scene::ImageTexture& image) {
    kernel::TextureRecord texture = plain_texture(kernel::TEXTURE_IMAGE);
    const Texels texels = load(image);
    texture.storage = texels.storage;
    texture.encoded = texels.encoded ? 1 : 0;
    texture.first_level = texels.first_level;
    texture.level_count = texels.level_count;
    texture.wrap_u = wrap_of(image.wrap);
    texture.wrap_v = wrap_of(image.wrap_v.value_or(image.wrap));
    texture.look = look_of(image.filter);
    texture.uv_set = image.uv_set;
    set_tint(image.tint, texture);
    if (image.times_mesh_colors) {
        texture.tint = kernel::TINT_VERTEX_COLORS;
    }
    const double angle = glm::radians(image.rotation);
    const double cosine = image.rotation == 0.0 ? 1.0 : std::cos(angle);
    const double sine = image.rotation == 0.0 ? 0.0 : std::sin(angle);
    texture.row_u = kernel::vec3(glm::dvec3(cosine * image.scale.x, -sine * image.scale.y, image.offset.x));
    texture.row_v = kernel::vec3(glm::dvec3(sine * image.scale.x, cosine * image.scale.y, image.offset.y));
    return push(texture);
}

CompiledTexture Textures::push(const kernel::TextureRecord& texture) {
    world_.textures.push_back(texture);
    return {static_cast<int>(world_.textures.size()) - 1, scene::Rgb(1.0)};
}

Textures::Texels Textures::load(const scene::ImageTexture& image) {
    const bool halves = image.filter == scene::Filter::mipmaps;
    const auto key = std::make_tuple(image.file, image.linear, halves);
    if (const auto known = images_.find(key); known != images_.end()) {
        return known->second;
    }
    Texels texels;
    try {
        const StoredPixels pixels = image.bytes ? read_stored_pixels(*image.bytes, image.file) : read_stored_pixels(image.file);
        const bool encoded = !image.linear && pixels.bits != 0;
        texels.storage = storage_of(pixels);
        texels.encoded = encoded && pixels.bits == 8;
        texels.first_level = static_cast<int>(world_.levels.size() / 3);
        texels.level_count = add_texels(pixels, encoded, halves, world_);
    } catch (const std::runtime_error& problem) {
        diagnostics_.error(image.position, problem.what());
    }
    images_[key] = texels;
    return texels;
}

}  // namespace lancer
