#include "lancer/import/pbrt/textures.h"

#include <algorithm>

#include <fmt/format.h>

#include "lancer/import/pbrt/files.h"
#include "lancer/import/pbrt/words.h"

namespace lancer::pbrt {

namespace {

scene::Rgb mean_color(const scene::Texture& texture) {
    if (const auto* color = std::get_if<scene::Color>(&texture)) {
        return color->rgb;
    }
    if (const auto* checker = std::get_if<scene::Checker>(&texture)) {
        return 0.5 * (checker->first + checker->second);
    }
    return scene::Rgb(0.5);
}

}  // namespace

// The last definition before the owner; else, since version 4 does not mind the order, the first after it.
const TextureRecipe* Textures::find(const Recipe& owner, const Parameter& parameter) const {
    const std::vector<std::string> names = owner.parameters.strings_of(parameter);
    const auto found = names.size() == 1 ? by_name_.find(names[0]) : by_name_.end();
    if (found == by_name_.end()) {
        std::vector<std::string> known;
        for (const auto& [name, texture] : by_name_) {
            known.push_back(name);
        }
        const std::string name = names.empty() ? "" : names[0];
        owner.parameters.error(parameter, fmt::format("there is no texture \"{}\"{}", name, did_you_mean(name, known)));
        return nullptr;
    }
    const TextureRecipe* best = &found->second.front();
    for (const TextureRecipe& texture : found->second) {
        best = texture.recipe.sequence < owner.sequence ? &texture : best;
    }
    return best;
}

std::optional<scene::Texture> Textures::color_of(const Recipe& owner, std::string_view name, Path& path) const {
    const Parameter* parameter = owner.parameters.find(name);
    if (parameter == nullptr) {
        return std::nullopt;
    }
    if (parameter->type != "texture") {
        const auto share = read_share(owner.parameters, *parameter, owner.space);
        return share ? std::optional<scene::Texture>(*share) : std::nullopt;
    }
    const TextureRecipe* texture = find(owner, *parameter);
    if (texture == nullptr) {
        return std::nullopt;
    }
    if (std::find(path.begin(), path.end(), texture) != path.end()) {
        owner.parameters.error(*parameter, "this texture needs itself");
        return std::nullopt;
    }
    path.push_back(texture);
    auto result = color_of(*texture, path);
    path.pop_back();
    return result;
}

std::optional<double> Textures::number_of(const Recipe& owner, std::string_view name, Path& path) const {
    const Parameter* parameter = owner.parameters.find(name);
    if (parameter == nullptr) {
        return std::nullopt;
    }
    if (parameter->type != "texture") {
        return owner.parameters.number(name);
    }
    const TextureRecipe* texture = find(owner, *parameter);
    if (texture == nullptr) {
        return std::nullopt;
    }
    if (std::find(path.begin(), path.end(), texture) != path.end()) {
        owner.parameters.error(*parameter, "this texture needs itself");
        return std::nullopt;
    }
    path.push_back(texture);
    const auto result = number_of(*texture, path);
    path.pop_back();
    return result;
}

std::optional<scene::Texture> Textures::image(const TextureRecipe& texture) const {
    const Parameters& parameters = texture.recipe.parameters;
    const Parameter* parameter = parameters.find("filename");
    const auto name = parameters.string("filename");
    if (!name) {
        context_.diagnostics.error(parameters.position(), parameters.owner() + " needs \"string filename\"");
        return std::nullopt;
    }
    scene::ImageTexture image;
    image.position = Parameters::position_of(*parameter);
    image.file = find_file(context_, *name, *parameter->text);
    context_.files.image(image, image.position);
    const std::string wrap = parameters.string("wrap", "repeat");
    image.wrap = wrap == "repeat" ? scene::Wrap::repeat : scene::Wrap::clamp;
    image.linear = parameters.string("encoding", "sRGB") == "linear";
    image.scale = {parameters.number("uscale", 1.0), parameters.number("vscale", 1.0)};
    image.offset = {parameters.number("udelta", 0.0), parameters.number("vdelta", 0.0)};
    parameters.pass_over({"filter", "trilinear", "maxanisotropy", "gamma", "mapping"});
    return image;
}

std::optional<scene::Texture> Textures::color_of(const TextureRecipe& texture, Path& path) const {
    const Recipe& recipe = texture.recipe;
    ImportReport& report = context_.report;
    const auto part = [&](std::string_view name, double otherwise) { return color_of(recipe, name, path).value_or(scene::Rgb(otherwise)); };
    if (recipe.type == "constant") {
        report.honoured(recipe.parameters.owner(), recipe.parameters.position());
        return part("value", 1.0);
    }
    if (recipe.type == "imagemap") {
        report.honoured(recipe.parameters.owner(), recipe.parameters.position());
        return image(texture);
    }
    if (recipe.type == "scale") {
        const scene::Texture one = part(recipe.parameters.has("tex") ? "tex" : "tex1", 1.0);
        const scene::Texture other = part(recipe.parameters.has("scale") ? "scale" : "tex2", 1.0);
        return scene::Rgb(mean_color(one) * mean_color(other));
    }
    return std::nullopt;
}

std::optional<double> Textures::number_of(const TextureRecipe& texture, Path& path) const {
    if (texture.recipe.type == "constant") {
        return number_of(texture.recipe, "value", path).value_or(1.0);
    }
    return std::nullopt;
}

std::optional<scene::Texture> Textures::color(const Recipe& owner, std::string_view name) const {
    Path path;
    return color_of(owner, name, path);
}

scene::Texture Textures::color(const Recipe& owner, std::string_view name, const scene::Rgb& otherwise) const {
    return color(owner, name).value_or(otherwise);
}

std::optional<double> Textures::number(const Recipe& owner, std::string_view name) const {
    Path path;
    return number_of(owner, name, path);
}

double Textures::number(const Recipe& owner, std::string_view name, double otherwise) const {
    return number(owner, name).value_or(otherwise);
}

}  // namespace lancer::pbrt
