// Textures as records, and the images behind them.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"
#include "lancer/world/world.h"

namespace lancer {

struct CompiledTexture {
    int number = -1;                       // into world.textures; -1: `color` everywhere
    scene::Color color = scene::Rgb(1.0);  // 1 where there is a texture
};

// Fills world.textures and texels. Each image file is read once, however many materials use it.
class Textures {
public:
    Textures(World& world, Diagnostics& diagnostics) : world_(world), diagnostics_(diagnostics) {}

    CompiledTexture add(const scene::Texture& texture);

private:
    struct Texels {
        int first = 0;
        int width = 0;
        int height = 0;
    };

    CompiledTexture compile(const scene::Color& color);
    CompiledTexture compile(const scene::Checker& checker);
    CompiledTexture compile(const scene::ImageTexture& image);
    CompiledTexture push(const kernel::TextureRecord& texture);
    Texels load(const scene::ImageTexture& image);

    World& world_;
    Diagnostics& diagnostics_;
    std::map<std::pair<std::string, bool>, Texels> images_;
};

}  // namespace lancer
