// Textures as records, and the images behind them.
#pragma once

#include <exception>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/color.h"
#include "lancer/scene/textures.h"
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

    // Reads the pictures that `probe` was asked for, several at a time, so that `add` finds them ready.
    void read_ahead(const Textures& probe);
    // From now on, pictures are only noted down, and none is read.
    void only_note() { notes_ = true; }

private:
    // A picture in the tables.
    struct Texels {
        int storage = 0;
        bool encoded = false;
        int first_level = 0;
        int level_count = 0;
    };
    using Name = std::tuple<std::string, bool, bool>;  // the file, whether its colours are linear, and whether it has smaller copies
    struct Wanted {
        Name name;
        const scene::ImageTexture* image;
    };
    // A picture in tables of its own.
    struct Read {
        std::unique_ptr<World> tables;
        Texels texels;
        std::exception_ptr problem;
    };

    static Read read(const scene::ImageTexture& image);
    void append(const World& tables, const Texels& texels);

    Texels load(const scene::ImageTexture& image);
    CompiledTexture compile(const scene::Color& color);
    CompiledTexture compile(const scene::Checker& checker);
    CompiledTexture compile(const scene::ImageTexture& image);
    CompiledTexture compile(const scene::MeshColors& colors);
    CompiledTexture push(const kernel::TextureRecord& texture);

    World& world_;
    Diagnostics& diagnostics_;
    std::map<Name, Texels> images_;
    std::map<Name, Read> ready_;
    std::vector<Wanted> wanted_;
    bool notes_ = false;
};

}  // namespace lancer
