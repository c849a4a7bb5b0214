// Directives that change what comes after them.
#include <algorithm>

#include <fmt/format.h>

#include "lancer/import/pbrt/interpreter.h"
#include "lancer/import/pbrt/numbers.h"
#include "lancer/import/pbrt/transforms.h"

namespace lancer::pbrt {

namespace {

constexpr std::size_t deepest_nesting = 10'000;

}  // namespace

void Interpreter::transform(const Syntax& syntax, const Directive& directive) {
    std::vector<double> n;
    const std::string_view wrong = for_each_number<double>(directive.numbers, [&](double number) { n.push_back(number); });
    const auto expect = [&](std::size_t count) {
        if (!wrong.empty() || n.size() != count) {
            context_.diagnostics.error(syntax.position(wrong.empty() ? directive.word : wrong),
                                       fmt::format("{} needs {} numbers", directive.word, count));
            return false;
        }
        return true;
    };
    const auto sixteen = [&] {
        std::array<double, 16> values{};
        std::copy(n.begin(), n.end(), values.begin());
        return from_sixteen(values);
    };
    const auto then = [&](const glm::dmat4& map) { state_.change([&](const glm::dmat4& so_far) { return so_far * map; }); };
    switch (directive.keyword) {
        case Keyword::identity:
            return state_.change([](const glm::dmat4&) { return glm::dmat4(1.0); });
        case Keyword::translate:
            return expect(3) ? then(translation({n[0], n[1], n[2]})) : void();
        case Keyword::scale:
            return expect(3) ? then(scaling({n[0], n[1], n[2]})) : void();
        case Keyword::rotate:
            return expect(4) ? then(rotation(n[0], {n[1], n[2], n[3]})) : void();
        case Keyword::transform:
            return expect(16) ? state_.change([&](const glm::dmat4&) { return sixteen(); }) : void();
        case Keyword::concat_transform:
            return expect(16) ? then(sixteen()) : void();
        case Keyword::look_at: {
            if (!expect(9)) {
                return;
            }
            const auto map = look_at({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]});
            if (map) {
                then(*map);
            } else {
                context_.diagnostics.error(
                    syntax.position(directive.word),
                    "LookAt needs two different points, and a direction for up that does not point from one to the other");
            }
            return;
        }
        case Keyword::active_transform: {
            const std::string_view which = directive.strings[0];
            if (which != "StartTime" && which != "EndTime" && which != "All") {
                context_.diagnostics.error(syntax.position(which), "ActiveTransform needs StartTime, EndTime or All");
            }
            state_.changes_opening = which != "EndTime";
            state_.changes_closing = which != "StartTime";
            context_.report.approximated("ActiveTransform", "what moves stands still, as it is at the start",
                                         syntax.position(directive.word));
            return;
        }
        default:  // TransformTimes: when the start is does not matter
            return;
    }
}

void Interpreter::coordinate_system(const Syntax& syntax, const Directive& directive) {
    const std::string name(directive.strings[0]);
    if (directive.keyword == Keyword::coordinate_system) {
        coordinate_systems_.insert_or_assign(name, state_);
        return;
    }
    const auto found = coordinate_systems_.find(name);
    if (found == coordinate_systems_.end()) {
        std::vector<std::string> known;
        for (const auto& [other, state] : coordinate_systems_) {
            known.push_back(other);
        }
        context_.diagnostics.error(syntax.position(directive.strings[0]),
                                   fmt::format("there is no coordinate system \"{}\"{}", name, did_you_mean(name, known)));
        return;
    }
    state_.at_opening = found->second.at_opening;
    state_.at_closing = found->second.at_closing;
}

void Interpreter::open(const Syntax& syntax, const Directive& directive, Keyword keyword) {
    if (saved_.size() >= deepest_nesting) {
        context_.diagnostics.error(syntax.position(directive.word),
                                   fmt::format("more than {} blocks inside of one another", deepest_nesting));
        full_ = true;
        return;
    }
    saved_.push_back({keyword, syntax.position(directive.word), state_});
}

void Interpreter::close(const Syntax& syntax, const Directive& directive, Keyword keyword) {
    if (saved_.empty() || saved_.back().opened != keyword) {
        const std::string why =
            saved_.empty() ? "nothing is open here" : fmt::format("what is open was begun at {}", to_string(saved_.back().position));
        context_.diagnostics.error(syntax.position(directive.word), fmt::format("{}: {}", directive.word, why));
        return;
    }
    if (keyword == Keyword::transform_begin) {
        state_.at_opening = saved_.back().state.at_opening;
        state_.at_closing = saved_.back().state.at_closing;
        state_.changes_opening = saved_.back().state.changes_opening;
        state_.changes_closing = saved_.back().state.changes_closing;
    } else {
        state_ = std::move(saved_.back().state);
    }
    saved_.pop_back();
}

void Interpreter::set_defaults(const Syntax& syntax, const Directive& directive) {
    constexpr std::array<std::string_view, target_count> names = {"shape", "light", "material", "medium", "texture"};
    const auto found = std::find(names.begin(), names.end(), directive.strings[0]);
    if (found == names.end()) {
        context_.diagnostics.error(syntax.position(directive.strings[0]), "Attribute is for shape, light, material, medium or texture");
        return;
    }
    auto& slot = state_.defaults[static_cast<std::size_t>(found - names.begin())];
    auto defaults = slot ? std::make_shared<std::vector<Parameter>>(*slot) : std::make_shared<std::vector<Parameter>>();
    for (std::uint32_t i = 0; i < directive.parameter_count; ++i) {
        const Parameter& given = syntax.parameters[directive.first_parameter + i];
        std::erase_if(*defaults, [&](const Parameter& p) { return p.name == given.name; });
        defaults->push_back(given);
    }
    slot = std::move(defaults);
    context_.report.honoured(fmt::format("Attribute \"{}\"", *found), syntax.position(directive.word));
}

}  // namespace lancer::pbrt
