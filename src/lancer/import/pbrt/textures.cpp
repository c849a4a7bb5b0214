#include "lancer/import/pbrt/textures.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "lancer/import/pbrt/files.h"
#include "lancer/import/pbrt/spectra.h"
#include "lancer/import/pbrt/words.h"

namespace lancer::pbrt {

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

// What a parameter gives: a number, a colour or a texture by name.
std::optional<TextureNode> Textures::node(const Recipe& owner, std::string_view name, Path& path) const {
    const Parameter* parameter = owner.parameters.find(name);
    if (parameter == nullptr) {
        return std::nullopt;
    }
    if (parameter->type == "float") {
        const auto number = owner.parameters.number(name);
        return number ? std::optional(constant_node(scene::Rgb(*number))) : std::nullopt;
    }
    if (parameter->type != "texture") {
        const auto share = read_share(owner.parameters, *parameter, owner.space);
        return share ? std::optional(constant_node(visible(*share))) : std::nullopt;
    }
    const TextureRecipe* texture = find(owner, *parameter);
    if (texture == nullptr) {
        return std::nullopt;
    }
    if (std::find(path.begin(), path.end(), texture) != path.end()) {
        owner.parameters.error(*parameter, "this texture needs itself");
        return std::nullopt;
    }
    constexpr std::size_t deepest = 64;
    if (path.size() >= deepest) {
        owner.parameters.error(*parameter, fmt::format("textures are made of textures more than {} deep", deepest));
        return std::nullopt;
    }
    if (const auto known = nodes_.find(texture); known != nodes_.end()) {
        return known->second;
    }
    path.push_back(texture);
    auto result = node(*texture, path);
    path.pop_back();
    constexpr int most_costly = 256;
    if (result && result->cost > most_costly) {
        owner.parameters.error(*parameter, fmt::format("this texture is made of more than {} others", most_costly));
        result.reset();
    }
    nodes_.emplace(texture, result);
    return result;
}

TextureNode Textures::node(const Recipe& owner, std::string_view name, double otherwise, Path& path) const {
    auto found = node(owner, name, path);
    return found ? std::move(*found) : constant_node(scene::Rgb(otherwise));
}

std::optional<TextureNode> Textures::node(const TextureRecipe& texture, Path& path) const {
    const Recipe& recipe = texture.recipe;
    const Parameters& parameters = recipe.parameters;
    ImportReport& report = context_.report;
    const auto mixed = [&](const TextureNode& amount) {
        const TextureNode one = node(recipe, "tex1", 0.0, path), other = node(recipe, "tex2", 1.0, path);
        const TextureNode first = combined_node(one, amount, [](const auto& color, const auto& share) { return color * (1.0 - share); });
        const TextureNode second = combined_node(other, amount, [](const auto& color, const auto& share) { return color * share; });
        return combined_node(first, second, [](const auto& a, const auto& b) { return a + b; });
    };
    std::optional<TextureNode> result;
    if (recipe.type == "constant") {
        result = node(recipe, "value", 1.0, path);
    } else if (recipe.type == "imagemap") {
        result = image(recipe);
    } else if (recipe.type == "scale") {
        const bool old = parameters.has("tex1") || parameters.has("tex2");
        result = combined_node(node(recipe, old ? "tex1" : "tex", 1.0, path), node(recipe, old ? "tex2" : "scale", 1.0, path),
                               [](const auto& a, const auto& b) { return a * b; });
    } else if (recipe.type == "mix") {
        result = mixed(node(recipe, "amount", 0.5, path));
    } else if (recipe.type == "directionmix") {
        result = mixed(constant_node(scene::Rgb(0.5)));
        parameters.pass_over({"dir"});
        result->exact = false;
    } else if (recipe.type == "checkerboard") {
        result = checkerboard(recipe, path);
    } else if (recipe.type == "bilerp") {
        result = bilerp(recipe, path);
    } else if (recipe.type == "dots") {
        result = dots(recipe, path);
    } else {
        // Those that fill space, and those of formats that we do not read: about what they are in the mean.
        const scene::Rgb mean = recipe.type == "marble"  ? scene::Rgb(0.58, 0.55, 0.5)
                                : recipe.type == "fbm"   ? scene::Rgb(0.0)
                                : recipe.type == "windy" ? scene::Rgb(0.15)
                                                         : scene::Rgb(0.5);
        result = constant_node(mean);
        report.approximated(parameters.owner(), "the same everywhere", parameters.position());
        return result;
    }
    if (result && result->exact) {
        report.honoured(parameters.owner(), parameters.position());
    } else if (result) {
        report.approximated(parameters.owner(), "what is near to it", parameters.position());
    }
    return result;
}

// How uv is laid over a texture. Nothing after an error.
std::optional<scene::ImageTexture> Textures::mapping(const Recipe& recipe) const {
    const Parameters& parameters = recipe.parameters;
    scene::ImageTexture mapping;
    mapping.position = parameters.position();
    const std::string kind = parameters.string("mapping", "uv");
    if (kind != "uv") {
        context_.report.approximated(fmt::format("{}, mapping \"{}\"", parameters.owner(), kind), "uv of the surface",
                                     parameters.position());
    }
    mapping.scale = {parameters.number("uscale", 1.0), parameters.number("vscale", 1.0)};
    mapping.offset = {parameters.number("udelta", 0.0), parameters.number("vdelta", 0.0)};
    parameters.pass_over({"v1", "v2"});
    const std::string wrap = parameters.string("wrap", "repeat");
    mapping.wrap = wrap == "repeat" ? scene::Wrap::repeat : scene::Wrap::clamp;
    if (wrap == "black" || wrap == "octahedralsphere") {
        context_.report.approximated(fmt::format("wrap \"{}\"", wrap), "wrap \"clamp\"", parameters.position());
    }
    return mapping;
}

std::optional<TextureNode> Textures::image(const Recipe& recipe) const {
    const Parameters& parameters = recipe.parameters;
    const Parameter* parameter = parameters.find("filename");
    const auto name = parameters.string("filename");
    if (!name) {
        context_.diagnostics.error(parameters.position(), parameters.owner() + " needs \"string filename\"");
        return std::nullopt;
    }
    auto laid = mapping(recipe);
    laid->position = Parameters::position_of(*parameter);
    laid->file = find_file(context_, *name, *parameter->text);
    const bool there = context_.files.image(*laid, laid->position) && laid->bytes == nullptr;
    const std::string filter = parameters.string("filter", "bilinear");
    laid->filter = filter == "point" ? scene::Filter::nearest : filter == "bilinear" ? scene::Filter::bilinear : scene::Filter::mipmaps;
    const std::string encoding = parameters.string("encoding", "sRGB");
    laid->linear = encoding == "linear" || !parameters.boolean("gamma", true);
    if (encoding.starts_with("gamma")) {
        context_.report.approximated(fmt::format("encoding \"{}\"", encoding), "sRGB", parameters.position());
    }
    parameters.pass_over({"trilinear", "maxanisotropy"});
    const double scale = parameters.number("scale", 1.0);
    const bool invert = parameters.boolean("invert", false);
    parameters.warn_of_unused();
    // Only pictures that are mixed with others are looked into here.
    const auto load = [this, file = laid->file, linear = laid->linear, there, position = laid->position]() -> std::shared_ptr<const Image> {
        auto& known = images_[file + (linear ? "\nlinear" : "")];
        if (!known) {
            Image pixels{1, 1, 3, {1.0f, 0.0f, 1.0f}};  // magenta
            try {
                pixels = there ? read_image(file, linear ? Encoding::linear : Encoding::automatic) : pixels;
            } catch (const std::runtime_error& problem) {
                context_.diagnostics.error(position, problem.what());
            }
            known = std::make_shared<const Image>(std::move(pixels));
        }
        return known;
    };
    return image_node(*laid, load, scale, invert);
}

// Cells of two colours that are the same everywhere: four texels tell all of it.
TextureNode Textures::checkerboard(const Recipe& recipe, Path& path) const {
    const TextureNode one = node(recipe, "tex1", 1.0, path), other = node(recipe, "tex2", 0.0, path);
    const scene::ImageTexture laid = *mapping(recipe);
    const bool solid = recipe.parameters.integer("dimension", 2) == 3;
    const auto at = [=, first = one.at, second = other.at](const glm::dvec2& uv) {
        const glm::dvec2 cell = glm::floor(laid.scale * uv + laid.offset);
        const double sum = cell.x + cell.y;
        return sum - 2.0 * std::floor(0.5 * sum) == 0.0 ? first(uv) : second(uv);
    };
    TextureNode result = procedural_node(at, 1024, false);
    result.cost = one.cost + other.cost;
    recipe.parameters.pass_over({"aamode"});
    if (!solid && one.constant && other.constant && laid.scale.x == laid.scale.y && laid.scale.x > 0.0 && laid.offset == glm::dvec2(0.0)) {
        result.exact = true;
        result.checker = scene::Checker{one.at({}), other.at({}), 1.0 / laid.scale.x, false};
    }
    return result;
}

TextureNode Textures::bilerp(const Recipe& recipe, Path& path) const {
    const scene::Rgb c00 = node(recipe, "v00", 0.0, path).at({}), c01 = node(recipe, "v01", 1.0, path).at({});
    const scene::Rgb c10 = node(recipe, "v10", 0.0, path).at({}), c11 = node(recipe, "v11", 1.0, path).at({});
    const scene::ImageTexture laid = *mapping(recipe);
    const auto at = [=](const glm::dvec2& uv) {
        const glm::dvec2 st = laid.scale * uv + laid.offset;
        return (c00 * (1.0 - st.x) + c10 * st.x) * (1.0 - st.y) + (c01 * (1.0 - st.x) + c11 * st.x) * st.y;
    };
    return procedural_node(at, 256, false);
}

// One round dot in most cells, here in all of them and in the middle.
TextureNode Textures::dots(const Recipe& recipe, Path& path) const {
    const TextureNode inside = node(recipe, "inside", 1.0, path), outside = node(recipe, "outside", 0.0, path);
    const scene::ImageTexture laid = *mapping(recipe);
    const auto at = [=, dot = inside.at, ground = outside.at](const glm::dvec2& uv) {
        const glm::dvec2 st = laid.scale * uv + laid.offset;
        const glm::dvec2 off = st - glm::floor(st) - 0.5;
        return off.x * off.x + off.y * off.y < 0.35 * 0.35 ? dot(uv) : ground(uv);
    };
    TextureNode result = procedural_node(at, 1024, false);
    result.cost = inside.cost + outside.cost;
    return result;
}

scene::Texture Textures::finished(const TextureNode& node, const TextureNode::Change& change, const Recipe& owner,
                                  std::string_view name) const {
    const SourcePosition position = Parameters::position_of(*owner.parameters.find(name));
    bool exact = true;
    scene::Texture texture = texture_of(node, change, position, exact);
    if (!exact) {
        context_.report.approximated(fmt::format("{}, \"{}\" from such a texture", owner.parameters.owner(), name), "what is near to it",
                                     position);
    }
    return texture;
}

std::optional<scene::Texture> Textures::color(const Recipe& owner, std::string_view name) const {
    const Parameter* parameter = owner.parameters.find(name);
    if (parameter == nullptr) {
        return std::nullopt;
    }
    if (parameter->type != "texture" && parameter->type != "float") {
        const auto share = read_share(owner.parameters, *parameter, owner.space);
        return share ? std::optional<scene::Texture>(*share) : std::nullopt;
    }
    Path path;
    const auto found = node(owner, name, path);
    return found ? std::optional(finished(*found, {}, owner, name)) : std::nullopt;
}

scene::Texture Textures::color(const Recipe& owner, std::string_view name, const Color& otherwise) const {
    return color(owner, name).value_or(otherwise);
}

scene::Value Textures::value(const Recipe& owner, std::string_view name, double otherwise, const Change& change) const {
    Path path;
    const auto found = node(owner, name, path);
    const auto changed = [&](double number) { return change ? change(number) : number; };
    if (!found) {
        return changed(otherwise);
    }
    if (found->constant) {
        return changed(found->at({}).x);
    }
    scene::Texture texture = finished(
        *found, change ? TextureNode::Change([&](const scene::Rgb& color) { return scene::Rgb(change(color.x)); }) : TextureNode::Change(),
        owner, name);
    if (const auto* everywhere = std::get_if<scene::Color>(&texture)) {
        return visible(*everywhere).x;
    }
    scene::Value value;
    value.texture = std::move(texture);
    return value;
}

double Textures::number(const Recipe& owner, std::string_view name, double otherwise) const {
    Path path;
    const auto found = node(owner, name, path);
    if (!found || found->constant) {
        return found ? found->at({}).x : otherwise;
    }
    context_.report.approximated(fmt::format("{}, \"{}\" from a texture", owner.parameters.owner(), name), "its mean",
                                 Parameters::position_of(*owner.parameters.find(name)));
    return mean_of(*found).x;
}

}  // namespace lancer::pbrt
