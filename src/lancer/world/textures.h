// Textures as records, and the images behind them.
#pragma once

#include <map>
#include <string>
#include <tuple>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"
#include "lancer/world/world.h"

namespace lancer {

struct CompiledTexture {
    int number = -1;                       // into world.textures; -1: `color` everywhere
    scene::Color color = scene::Rgb(1.0);  // 1 where there is a texture
};

// Fills world.textures and the tables of texels. Each image file is read once, however many materials use it.
class Textures {
public:
    Textures(World& world, Diagnostics& diagnostics) : world_(world), diagnostics_(diagnostics) {}

    CompiledTexture add(const scene::Texture& texture);

private:
    // A picture in the tables.
    struct Texels {
        int storage = 0;
        bool encoded = false;
        int first_level = 0;
        int level_count = 0;
    };

    Texels load(const scene::ImageTexture& image);
    CompiledTexture compile(const scene::Color& color);
    CompiledTexture compile(const scene::Checker& checker);
    CompiledTexture compile(const scene::ImageTexture& image);
    CompiledTexture compile(const scene::MeshColors& colors);
    CompiledTexture push(const kernel::TextureRecord& texture);

    World& world_;
    Diagnostics& diagnostics_;
    std::map<std::tuple<std::string, bool, bool>, Texels>
        images_;  // by file, whether its colours are linear, and whether it has smaller copies
};

}  // namespace lancer
