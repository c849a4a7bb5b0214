#include "lancer/world/textures.h"

#include <limits>
#include <stdexcept>

#include "lancer/image/image.h"

namespace lancer {

CompiledTexture Textures::add(const scene::Texture& texture) {
    return std::visit([&](const auto& kind) { return compile(kind); }, texture);
}

CompiledTexture Textures::compile(const scene::Color& color) { return {-1, color}; }

CompiledTexture Textures::compile(const scene::Checker& checker) {
    kernel::TextureRecord texture{};
    texture.kind = checker.solid ? kernel::TEXTURE_CHECKER_SOLID : kernel::TEXTURE_CHECKER_UV;
    texture.first = kernel::vec3(checker.first);
    texture.second = kernel::vec3(checker.second);
    texture.size = static_cast<float>(checker.size);
    return push(texture);
}

CompiledTexture Textures::compile(const scene::ImageTexture& image) {
    kernel::TextureRecord texture{};
    texture.kind = kernel::TEXTURE_IMAGE;
    const Texels texels = load(image);
    texture.first_texel = texels.first;
    texture.width = texels.width;
    texture.height = texels.height;
    texture.size = 1.0f;
    texture.wrap = image.wrap == scene::Wrap::repeat  ? kernel::WRAP_REPEAT
                   : image.wrap == scene::Wrap::clamp ? kernel::WRAP_CLAMP
                                                      : kernel::WRAP_MIRROR;
    texture.nearest = image.filter == scene::Filter::nearest ? 1 : 0;
    texture.scale = kernel::vec2(image.scale);
    texture.offset = kernel::vec2(image.offset);
    return push(texture);
}

CompiledTexture Textures::push(const kernel::TextureRecord& texture) {
    world_.textures.push_back(texture);
    return {static_cast<int>(world_.textures.size()) - 1, scene::Rgb(1.0)};
}

Textures::Texels Textures::load(const scene::ImageTexture& image) {
    const auto key = std::make_pair(image.file, image.linear);
    if (const auto known = images_.find(key); known != images_.end()) {
        return known->second;
    }
    Texels texels{0, 1, 1};
    try {
        const Image pixels = read_image(image.file, image.linear ? Encoding::linear : Encoding::automatic);
        texels = {static_cast<int>(world_.texels.size()), pixels.width, pixels.height};
        const std::size_t count = static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height);
        if (world_.texels.size() + count > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
            throw std::runtime_error("the scene's images together have more than 2147483647 pixels");
        }
        const auto channels = static_cast<std::size_t>(pixels.channels);
        const std::size_t colors = channels >= 3 ? 3 : 1;
        world_.texels.reserve(world_.texels.size() + count);
        for (std::size_t i = 0; i < count; ++i) {
            const float* p = &pixels.pixels[i * channels];
            world_.texels.push_back(colors == 3 ? kernel::vec3(p[0], p[1], p[2]) : kernel::vec3(p[0]));
        }
    } catch (const std::runtime_error& problem) {
        diagnostics_.error(image.position, problem.what());
    }
    images_[key] = texels;
    return texels;
}

}  // namespace lancer
