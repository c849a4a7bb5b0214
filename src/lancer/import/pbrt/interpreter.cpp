#include "lancer/import/pbrt/interpreter.h"

#include <algorithm>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "lancer/import/pbrt/files.h"
#include "lancer/import/pbrt/transforms.h"
#include "lancer/import/pbrt/version3.h"
#include "lancer/import/pbrt/words.h"

namespace lancer::pbrt {

namespace {

constexpr std::size_t deepest_include = 64;
constexpr std::size_t most_directives = 20'000'000;  // carried out; a file may include others many times

bool is_for_options(Keyword keyword) {
    return keyword == Keyword::camera || keyword == Keyword::film || keyword == Keyword::sampler || keyword == Keyword::integrator ||
           keyword == Keyword::pixel_filter || keyword == Keyword::option || keyword == Keyword::accelerator;
}

}  // namespace

Interpreter::Interpreter(ImportContext& context, scene::Scene& scene)
    : context_(context), scene_(scene), options_(context), textures_(context), materials_(context, textures_), lights_(context, scene) {}

void Interpreter::run() {
    const Syntax* first = syntax_of(context_.path, {});
    if (first == nullptr || context_.diagnostics.has_errors()) {
        return;
    }
    if (const auto sign = sign_of_version3(*first)) {
        version3_ = true;
        context_.diagnostics.note(*sign, "this file is of pbrt version 3: its directives are taken as version 4 would say them");
    }
    options_.set_version3(version3_);
    materials_.set_version3(version3_);
    lights_.set_version3(version3_);
    open_files_.push_back(context_.path);
    carry_out(*first);
    if (!saved_.empty()) {
        context_.diagnostics.warning(saved_.back().position, "this is not closed before the file ends");
    }
    const double brightness = options_.finish(scene_);
    materials_.finish(scene_, brightness);
    materials_.surround_camera(around_camera_, scene_, brightness);
    lights_.finish(brightness);
    scene_.settings.rgb = !spectral_;
    if (!spectral_) {
        context_.report.approximated("wavelengths", "red, green and blue: no colour of this file is written as a spectrum",
                                     {context_.path, 0, 0});
    }
}

// A file is cut into directives once, however often it is included. Null after an error.
const Syntax* Interpreter::syntax_of(const std::string& path, const SourcePosition& named_at) {
    const auto [found, is_new] = files_.try_emplace(path);
    if (is_new) {
        if (auto bytes = context_.files.open(path, named_at)) {
            auto text = std::make_shared<const SourceText>(path, std::move(*bytes));
            found->second = std::make_unique<const Syntax>(parse_syntax(std::move(text), context_.diagnostics));
            const auto& parameters = found->second->parameters;
            spectral_ = spectral_ || std::any_of(parameters.begin(), parameters.end(),
                                                 [](const Parameter& p) { return p.type == "spectrum" || p.type == "blackbody"; });
        }
    }
    return found->second.get();
}

void Interpreter::carry_out(const Syntax& syntax) {
    for (const Directive& directive : syntax.directives) {
        if (++sequence_ > most_directives) {
            context_.diagnostics.error(syntax.position(directive.word), fmt::format("more than {} directives", most_directives));
            full_ = true;
        }
        if (full_) {
            return;
        }
        carry_out(syntax, directive);
    }
}

void Interpreter::include(const Syntax& syntax, const Directive& directive) {
    const SourcePosition position = syntax.position(directive.strings[0]);
    const std::string path = find_file(context_, unescaped(directive.strings[0]), *syntax.text);
    if (std::find(open_files_.begin(), open_files_.end(), path) != open_files_.end()) {
        context_.diagnostics.error(position, fmt::format("\"{}\" includes itself", path));
        return;
    }
    if (open_files_.size() >= deepest_include) {
        context_.diagnostics.error(position, fmt::format("files are included more than {} deep", deepest_include));
        return;
    }
    const Syntax* included = syntax_of(path, position);
    if (included == nullptr) {
        return;
    }
    open_files_.push_back(path);
    if (directive.keyword == Keyword::import) {  // what it changes ends with it
        GraphicsState before = state_;
        carry_out(*included);
        state_ = std::move(before);
    } else {
        carry_out(*included);
    }
    open_files_.pop_back();
    context_.report.honoured(std::string(directive.word), position);
}

Parameters Interpreter::parameters(const Syntax& syntax, const Directive& directive, std::optional<Target> target) const {
    const auto begin = syntax.parameters.begin() + static_cast<std::ptrdiff_t>(directive.first_parameter);
    const std::string type(directive.strings[directive.keyword == Keyword::texture ? 2 : 0]);
    const std::string owner = directive.string_count == 0 ? std::string(directive.word) : fmt::format("{} \"{}\"", directive.word, type);
    return {context_,
            owner,
            syntax.position(directive.word),
            {begin, begin + static_cast<std::ptrdiff_t>(directive.parameter_count)},
            target ? state_.defaults[static_cast<std::size_t>(*target)].get() : nullptr};
}

Recipe Interpreter::recipe(const Syntax& syntax, const Directive& directive, std::optional<Target> target) const {
    return {parameters(syntax, directive, target), unescaped(directive.strings[0]), state_.space, sequence_};
}

void Interpreter::carry_out(const Syntax& syntax, const Directive& directive) {
    if (is_for_options(directive.keyword)) {
        if (in_world_) {
            context_.diagnostics.warning(syntax.position(directive.word),
                                         fmt::format("{} stands after WorldBegin: it is passed over", directive.word));
            return;
        }
        if (directive.keyword == Keyword::camera) {
            coordinate_systems_["camera"] = state_;
            around_camera_ = state_.outside;
            coordinate_systems_["camera"].at_opening = glm::inverse(state_.at_opening);
            coordinate_systems_["camera"].at_closing = glm::inverse(state_.at_closing);
        }
        options_.set(directive.keyword, recipe(syntax, directive), state_.at_opening);
        return;
    }
    switch (directive.keyword) {
        case Keyword::identity:
        case Keyword::translate:
        case Keyword::scale:
        case Keyword::rotate:
        case Keyword::look_at:
        case Keyword::transform:
        case Keyword::concat_transform:
        case Keyword::active_transform:
        case Keyword::transform_times:
            return transform(syntax, directive);
        case Keyword::coordinate_system:
        case Keyword::coord_sys_transform:
            return coordinate_system(syntax, directive);
        case Keyword::attribute_begin:
        case Keyword::transform_begin:
            return open(syntax, directive, directive.keyword);
        case Keyword::attribute_end:
            return close(syntax, directive, Keyword::attribute_begin);
        case Keyword::transform_end:
            return close(syntax, directive, Keyword::transform_begin);
        case Keyword::reverse_orientation:
            state_.reverse_orientation = !state_.reverse_orientation;
            return;
        case Keyword::color_space:
            if (const auto space = find_color_space(directive.strings[0])) {
                state_.space = *space;
                context_.report.honoured(fmt::format("ColorSpace \"{}\"", directive.strings[0]), syntax.position(directive.word));
            } else {
                context_.diagnostics.error(syntax.position(directive.strings[0]),
                                           "expected one of the colour spaces srgb, rec2020, aces2065-1, dci-p3");
            }
            return;
        case Keyword::attribute:
            return set_defaults(syntax, directive);
        case Keyword::include:
        case Keyword::import:
            return include(syntax, directive);
        case Keyword::world_begin:
            in_world_ = true;
            state_.at_opening = state_.at_closing = glm::dmat4(1.0);
            to_scene_ = handedness(options_.is_left_handed());
            state_.changes_opening = state_.changes_closing = true;
            coordinate_systems_["world"] = state_;
            return;
        case Keyword::world_end:
            return;
        case Keyword::texture:
            return define_texture(syntax, directive);
        case Keyword::material:
            state_.material = {materials_.add(recipe(syntax, directive, Target::material)), {}, sequence_};
            return;
        case Keyword::make_named_material:
            return make_named_material(syntax, directive);
        case Keyword::named_material:
            state_.material = {-1, unescaped(directive.strings[0]), sequence_};
            return;
        case Keyword::make_named_medium:
            materials_.add_medium(unescaped(directive.strings[0]), recipe(syntax, directive, Target::medium),
                                  to_scene_ * state_.at_opening);
            return;
        case Keyword::medium_interface:
            state_.inside = unescaped(directive.strings[0]);
            state_.outside = directive.string_count > 1 ? unescaped(directive.strings[1]) : state_.inside;
            return;
        case Keyword::area_light_source:
            state_.area_light = materials_.add_area_light(recipe(syntax, directive, Target::light));
            return;
        case Keyword::light_source:
            return lights_.add(recipe(syntax, directive, Target::light), to_scene_ * state_.at_opening);
        case Keyword::shape:
            return add_shape(syntax, directive);
        case Keyword::object_begin:
            return begin_object(syntax, directive);
        case Keyword::object_end:
            return end_object(syntax, directive);
        case Keyword::object_instance:
            return place_object(syntax, directive);
        default:
            return;
    }
}

void Interpreter::make_named_material(const Syntax& syntax, const Directive& directive) {
    Recipe made = recipe(syntax, directive, Target::material);
    const auto type = made.parameters.string("type");
    if (!type) {
        context_.diagnostics.error(made.parameters.position(), made.parameters.owner() + " needs \"string type\"");
        return;
    }
    made.type = *type;
    materials_.add_named(unescaped(directive.strings[0]), std::move(made));
}

void Interpreter::define_texture(const Syntax& syntax, const Directive& directive) {
    const std::string_view kind = directive.strings[1];
    if (kind != "spectrum" && kind != "float" && kind != "color") {
        context_.diagnostics.error(syntax.position(kind), fmt::format("a texture is of \"spectrum\" or \"float\", not of \"{}\"", kind));
        return;
    }
    TextureRecipe texture{recipe(syntax, directive, Target::texture), kind != "float"};
    texture.recipe.type = unescaped(directive.strings[2]);
    textures_.define(unescaped(directive.strings[0]), std::move(texture));
}

}  // namespace lancer::pbrt
