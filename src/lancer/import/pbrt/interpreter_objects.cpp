// Shapes, and objects that are defined once and placed many times.
#include <fmt/format.h>

#include "lancer/import/pbrt/interpreter.h"
#include "lancer/import/pbrt/transforms.h"
#include "lancer/import/pbrt/words.h"

namespace lancer::pbrt {

namespace {

constexpr std::size_t most_things = 4'000'000;  // objects and placements: some hundred bytes each

}  // namespace

bool Interpreter::has_room(const SourcePosition& position) {
    if (++things_ > most_things && !full_) {
        context_.diagnostics.error(position, fmt::format("more than {} shapes and placed objects", most_things));
        full_ = true;
    }
    return !full_;
}

void Interpreter::begin_object(const Syntax& syntax, const Directive& directive) {
    const SourcePosition position = syntax.position(directive.word);
    if (object_) {
        context_.diagnostics.error(position, "an object stands inside of another: close that one with ObjectEnd first");
        return;
    }
    open(syntax, directive, Keyword::object_begin);
    const std::string name = unescaped(directive.strings[0]);
    object_ = static_cast<int>(scene_.groups.size());
    scene_.groups.push_back({name, {}, {}});
    if (!objects_.insert_or_assign(name, *object_).second) {
        context_.diagnostics.warning(position, fmt::format("there is an object \"{}\" already: from here on this one is meant", name));
    }
}

void Interpreter::end_object(const Syntax& syntax, const Directive& directive) {
    if (!object_) {
        context_.diagnostics.error(syntax.position(directive.word), "ObjectEnd without ObjectBegin");
        return;
    }
    object_.reset();
    close(syntax, directive, Keyword::object_begin);
}

void Interpreter::place_object(const Syntax& syntax, const Directive& directive) {
    const SourcePosition position = syntax.position(directive.word);
    const std::string name = unescaped(directive.strings[0]);
    const auto found = objects_.find(name);
    if (object_) {
        context_.diagnostics.error(position, "an object can't be placed while another is being defined");
    } else if (found == objects_.end()) {
        std::vector<std::string> known;
        for (const auto& [other, group] : objects_) {
            known.push_back(other);
        }
        context_.diagnostics.error(position, fmt::format("there is no object \"{}\"{}", name, did_you_mean(name, known)));
    } else if (has_room(position)) {
        if (!is_usable(state_.at_opening)) {
            context_.diagnostics.warning(position, "the transform squeezes space flat: the object is left out");
            return;
        }
        scene_.placements.push_back({found->second, to_scene_ * state_.at_opening, std::nullopt, position});
        context_.report.honoured("ObjectInstance", position);
    }
}

void Interpreter::add_shape(const Syntax& syntax, const Directive& directive) {
    const Recipe shape = recipe(syntax, directive, Target::shape);
    const Parameters& given = shape.parameters;
    if (!has_room(given.position())) {
        return;
    }
    // What a file that is included again describes again need not be made again.
    std::optional<BuiltShape> built;
    const auto key = std::make_pair(&directive, state_.reverse_orientation);
    const bool plain = state_.defaults[static_cast<std::size_t>(Target::shape)] == nullptr;
    if (const auto known = plain ? shapes_.find(key) : shapes_.end(); known != shapes_.end()) {
        built = known->second;
    } else {
        built = build_shape(given, shape.type, state_.reverse_orientation);
        if (plain) {
            shapes_.emplace(key, built);
        }
    }
    if (!built) {
        return;
    }
    const glm::dmat4 to_world = state_.at_opening * built->to_object;
    if (!is_usable(to_world)) {
        context_.diagnostics.warning(given.position(), "the transform squeezes space flat: the shape is left out");
        return;
    }
    const bool shines = state_.area_light >= 0 && !object_;
    if (state_.area_light >= 0 && object_) {
        context_.report.dropped("AreaLightSource in an object", "pbrt does not let placed objects shine", given.position());
    }
    const int material = materials_.material_for({state_.material, shines ? state_.area_light : -1, state_.inside, state_.outside}, shape,
                                                 shines ? surface_area(built->shape, to_world) : 0.0);
    std::vector<scene::Object>& objects = object_ ? scene_.groups[static_cast<std::size_t>(*object_)].objects : scene_.objects;
    objects.push_back({{}, built->shape, material, object_ ? to_world : to_scene_ * to_world, given.position()});
    context_.report.honoured(given.owner(), given.position());
    given.warn_of_unused();
}

}  // namespace lancer::pbrt
