#include "lancer/world/textures.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

#include <glm/trigonometric.hpp>

#include "lancer/base/failure.h"
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

namespace {

std::tuple<std::string, bool, bool> name_of(const scene::ImageTexture& image) {
    return {image.file, image.linear, image.filter == scene::Filter::mipmaps};
}

}  // namespace

Textures::Read Textures::read(const scene::ImageTexture& image) {
    Read result;
    result.tables = std::make_unique<World>();
    try {
        const StoredPixels pixels = image.bytes ? read_stored_pixels(*image.bytes, image.file) : read_stored_pixels(image.file);
        const bool encoded = !image.linear && pixels.bits != 0;
        result.texels.storage = storage_of(pixels);
        result.texels.encoded = encoded && pixels.bits == 8;
        result.texels.level_count = add_texels(pixels, encoded, image.filter == scene::Filter::mipmaps, *result.tables);
    } catch (const std::exception&) {
        result.problem = std::current_exception();
    }
    return result;
}

// Which thread reads which picture shows nowhere: each fills tables of its own, and these are put together in the order of the scene.
void Textures::read_ahead(const Textures& probe) {
    std::vector<Read> read(probe.wanted_.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < read.size(); i = next++) {
            read[i] = Textures::read(*probe.wanted_[i].image);
        }
    };
    const std::size_t most = std::max(1u, std::min(std::thread::hardware_concurrency(), 16u));
    std::vector<std::thread> threads;
    for (std::size_t i = 1; i < std::min(most, read.size()); ++i) {
        threads.emplace_back(work);
    }
    work();
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (std::size_t i = 0; i < read.size(); ++i) {
        ready_.emplace(probe.wanted_[i].name, std::move(read[i]));
    }
}

// Their levels begin where ours end.
void Textures::append(const World& tables, const Texels& texels) {
    const std::size_t bytes_before = world_.texels.size(), floats_before = world_.float_texels.size();
    world_.texels.insert(world_.texels.end(), tables.texels.begin(), tables.texels.end());
    world_.float_texels.insert(world_.float_texels.end(), tables.float_texels.begin(), tables.float_texels.end());
    const bool has_floats = !tables.float_texels.empty();
    const std::size_t size = has_floats ? world_.float_texels.size() : world_.texels.size() * 4;
    if (size > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        throw std::runtime_error("the scene's images together have more pixels than can be numbered");
    }
    const std::size_t before = texels.storage == kernel::TEXELS_GREY8        ? bytes_before * 4
                               : texels.storage == kernel::TEXELS_RGBA8      ? bytes_before
                               : texels.storage == kernel::TEXELS_RGBA_FLOAT ? floats_before / 4
                                                                             : floats_before;
    for (std::size_t i = 0; i < tables.levels.size(); i += 3) {
        world_.levels.push_back(tables.levels[i] + static_cast<int>(before));
        world_.levels.push_back(tables.levels[i + 1]);
        world_.levels.push_back(tables.levels[i + 2]);
    }
    if (world_.decoding.empty()) {
        world_.decoding = tables.decoding;
    }
}

Textures::Texels Textures::load(const scene::ImageTexture& image) {
    const Name name = name_of(image);
    if (const auto known = images_.find(name); known != images_.end()) {
        return known->second;
    }
    Texels texels;
    if (notes_) {
        wanted_.push_back({name, &image});
        images_[name] = texels;
        return texels;
    }
    try {
        const auto ready = ready_.find(name);
        Read read = ready != ready_.end() ? std::move(ready->second) : Textures::read(image);
        if (read.problem) {
            std::rethrow_exception(read.problem);
        }
        texels = read.texels;
        texels.first_level = static_cast<int>(world_.levels.size() / 3);
        append(*read.tables, texels);
    } catch (const MachineFailure&) {
        throw;
    } catch (const std::runtime_error& problem) {
        diagnostics_.error(image.position, problem.what());
    }
    images_[name] = texels;
    return texels;
}

}  // namespace lancer
