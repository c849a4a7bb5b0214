#include "lancer/import/gltf/textures.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include "lancer/import/gltf/uri.h"

namespace lancer::gltf {

namespace {

// OpenGL's numbers, which glTF uses.
constexpr std::size_t nearest = 9728;
constexpr std::size_t linear_filter = 9729;
constexpr std::size_t nearest_of_mipmaps = 9984;
constexpr std::size_t clamp_to_edge = 33071;
constexpr std::size_t mirrored_repeat = 33648;

scene::Wrap wrap_of(std::size_t number) {
    return number == clamp_to_edge ? scene::Wrap::clamp : number == mirrored_repeat ? scene::Wrap::mirror : scene::Wrap::repeat;
}

glm::dvec2 vec2_or(Json json, std::string_view key, const glm::dvec2& otherwise) {
    const std::vector<double> v = json.numbers(key);
    return v.size() == 2 ? glm::dvec2(v[0], v[1]) : otherwise;
}

}  // namespace

std::optional<scene::ImageTexture> Textures::of(Json info, bool linear, Wishes& wishes) {
    const Json texture = document_.item("textures", info, "index");
    if (!texture) {
        return std::nullopt;
    }
    const Json webp = document_.extension(texture, "EXT_texture_webp");
    const auto source = (webp ? webp : texture).natural("source");
    if (!source || *source >= document_.items("images").size()) {
        document_.dropped("texture without a picture", "no extension that lancer knows gives it one", texture);
        return std::nullopt;
    }
    const Picture& found = picture(*source);
    if (!found.is_usable) {
        return std::nullopt;
    }
    scene::ImageTexture result;
    result.file = found.name;
    result.bytes = found.bytes;
    result.linear = linear;
    result.position = document_.position(info);
    result.uv_set = uv_set(info, wishes);
    set_sampler(document_.item("samplers", texture, "sampler"), result);
    set_transform(info, result);
    return result;
}

// Meshes have two sets of coordinates; a material may use any two of the file's.
int Textures::uv_set(Json info, Wishes& wishes) {
    const Json transform = document_.extension(info, "KHR_texture_transform");
    const std::size_t wanted = (transform["texCoord"] ? transform : info).natural("texCoord").value_or(0);
    const auto known = std::find(wishes.uv_sets.begin(), wishes.uv_sets.end(), wanted);
    if (known != wishes.uv_sets.end()) {
        return static_cast<int>(known - wishes.uv_sets.begin());
    }
    if (wishes.uv_sets.size() == 2) {
        document_.approximated("more than two sets of texture coordinates", "the first one stands for the third", info);
        return 0;
    }
    wishes.uv_sets.push_back(wanted);
    return static_cast<int>(wishes.uv_sets.size()) - 1;
}

void Textures::set_sampler(Json sampler, scene::ImageTexture& texture) const {
    texture.wrap = wrap_of(sampler.natural("wrapS").value_or(0));
    if (const scene::Wrap down = wrap_of(sampler.natural("wrapT").value_or(0)); down != texture.wrap) {
        texture.wrap_v = down;
    }
    const std::size_t larger = sampler.natural("magFilter").value_or(linear_filter);
    const std::size_t smaller = sampler.natural("minFilter").value_or(nearest_of_mipmaps);
    texture.filter = larger == nearest          ? scene::Filter::nearest
                     : smaller == linear_filter ? scene::Filter::bilinear
                                                : scene::Filter::mipmaps;
}

// In the file, v grows downwards; ours grows upwards: v = 1 - v of the file, before and after.
void Textures::set_transform(Json info, scene::ImageTexture& texture) {
    const Json transform = document_.extension(info, "KHR_texture_transform");
    if (!transform) {
        return;
    }
    const glm::dvec2 offset = vec2_or(transform, "offset", glm::dvec2(0.0));
    const double angle = transform.number("rotation", 0.0);
    texture.scale = vec2_or(transform, "scale", glm::dvec2(1.0));
    texture.rotation = glm::degrees(angle);
    texture.offset = {offset.x + std::sin(angle) * texture.scale.y, 1.0 - std::cos(angle) * texture.scale.y - offset.y};
    document_.honoured("KHR_texture_transform", transform);
}

const Textures::Picture& Textures::picture(std::size_t index) {
    const auto [known, is_new] = pictures_.try_emplace(index);
    if (is_new) {
        known->second = open(document_.items("images")[index], index);
    }
    return known->second;
}

Textures::Picture Textures::open(Json image, std::size_t index) {
    Picture picture;
    const std::string_view uri = image.text("uri");
    if (image["bufferView"]) {
        const auto view = image.natural("bufferView");
        if (const auto bytes = view ? buffers_.view(*view) : std::nullopt) {
            picture.bytes = std::make_shared<const std::string>(*bytes);
        }
    } else if (const auto data = split_data_uri(uri)) {
        if (auto bytes = decode(*data)) {
            picture.bytes = std::make_shared<const std::string>(std::move(*bytes));
        } else {
            document_.error(image["uri"], "the data URI is no valid base64");
        }
    } else if (!image["uri"]) {
        document_.error(image, "expected a \"uri\" or a \"bufferView\"");
    } else if (!scheme_of(uri).empty()) {
        document_.error(image["uri"], fmt::format("\"{}\": lancer reads no files from the network", uri.substr(0, 80)));
    } else if (const auto name = decode_percent(uri); name && name->find('\0') == std::string::npos && !name->empty()) {
        picture.name = path_beside(document_.path(), *name);
        picture.is_usable = true;
        if (!files_.image(picture.name, document_.position(image["uri"]))) {
            // Errors have been said; where there are none, a magenta picture of one pixel was asked for.
            picture.bytes = std::make_shared<const std::string>("P6 1 1 255\n\xff\x01\xff");
        }
        return picture;
    } else {
        document_.error(image["uri"], "expected a file's name, with %XX for characters that URIs don't allow");
    }
    if (picture.bytes) {
        // A name for messages, and to tell pictures apart.
        picture.name = fmt::format("{}#/images/{}", document_.path(), index);
        picture.is_usable = true;
    }
    return picture;
}

}  // namespace lancer::gltf
