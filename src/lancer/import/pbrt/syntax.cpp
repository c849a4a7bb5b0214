#include "lancer/import/pbrt/syntax.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "lancer/import/pbrt/words.h"

namespace lancer::pbrt {

namespace {

struct Form {
    std::string_view word;
    Keyword keyword;
    int fewest_strings;
    int most_strings;
    int numbers;
    bool parameters;
};

// In alphabetical order.
constexpr std::array forms = {
    Form{"Accelerator", Keyword::accelerator, 1, 1, 0, true},
    Form{"ActiveTransform", Keyword::active_transform, 1, 1, 0, false},
    Form{"AreaLightSource", Keyword::area_light_source, 1, 1, 0, true},
    Form{"Attribute", Keyword::attribute, 1, 1, 0, true},
    Form{"AttributeBegin", Keyword::attribute_begin, 0, 0, 0, false},
    Form{"AttributeEnd", Keyword::attribute_end, 0, 0, 0, false},
    Form{"Camera", Keyword::camera, 1, 1, 0, true},
    Form{"ColorSpace", Keyword::color_space, 1, 1, 0, false},
    Form{"ConcatTransform", Keyword::concat_transform, 0, 0, 16, false},
    Form{"CoordSysTransform", Keyword::coord_sys_transform, 1, 1, 0, false},
    Form{"CoordinateSystem", Keyword::coordinate_system, 1, 1, 0, false},
    Form{"Film", Keyword::film, 1, 1, 0, true},
    Form{"Identity", Keyword::identity, 0, 0, 0, false},
    Form{"Import", Keyword::import, 1, 1, 0, false},
    Form{"Include", Keyword::include, 1, 1, 0, false},
    Form{"Integrator", Keyword::integrator, 1, 1, 0, true},
    Form{"LightSource", Keyword::light_source, 1, 1, 0, true},
    Form{"LookAt", Keyword::look_at, 0, 0, 9, false},
    Form{"MakeNamedMaterial", Keyword::make_named_material, 1, 1, 0, true},
    Form{"MakeNamedMedium", Keyword::make_named_medium, 1, 1, 0, true},
    Form{"Material", Keyword::material, 1, 1, 0, true},
    Form{"MediumInterface", Keyword::medium_interface, 1, 2, 0, false},
    Form{"NamedMaterial", Keyword::named_material, 1, 1, 0, false},
    Form{"ObjectBegin", Keyword::object_begin, 1, 1, 0, false},
    Form{"ObjectEnd", Keyword::object_end, 0, 0, 0, false},
    Form{"ObjectInstance", Keyword::object_instance, 1, 1, 0, false},
    Form{"Option", Keyword::option, 0, 0, 0, true},
    Form{"PixelFilter", Keyword::pixel_filter, 1, 1, 0, true},
    Form{"ReverseOrientation", Keyword::reverse_orientation, 0, 0, 0, false},
    Form{"Rotate", Keyword::rotate, 0, 0, 4, false},
    Form{"Sampler", Keyword::sampler, 1, 1, 0, true},
    Form{"Scale", Keyword::scale, 0, 0, 3, false},
    Form{"Shape", Keyword::shape, 1, 1, 0, true},
    Form{"Texture", Keyword::texture, 3, 3, 0, true},
    Form{"Transform", Keyword::transform, 0, 0, 16, false},
    Form{"TransformBegin", Keyword::transform_begin, 0, 0, 0, false},
    Form{"TransformEnd", Keyword::transform_end, 0, 0, 0, false},
    Form{"TransformTimes", Keyword::transform_times, 0, 0, 2, false},
    Form{"Translate", Keyword::translate, 0, 0, 3, false},
    Form{"WorldBegin", Keyword::world_begin, 0, 0, 0, false},
    Form{"WorldEnd", Keyword::world_end, 0, 0, 0, false},
};

constexpr int most_errors = 20;  // in one file: what follows is mostly no pbrt file at all

const Form* find_form(std::string_view word) {
    const auto found =
        std::lower_bound(forms.begin(), forms.end(), word, [](const Form& form, std::string_view w) { return form.word < w; });
    return found != forms.end() && found->word == word ? &*found : nullptr;
}

std::string shown(std::string_view word) {
    constexpr std::size_t longest = 40;
    return word.empty() ? "the file ends" : fmt::format("found {}{}", word.substr(0, longest), word.size() > longest ? "..." : "");
}

class Parser {
public:
    Parser(std::shared_ptr<const SourceText> text, Diagnostics& diagnostics) : words_(text->view()), diagnostics_(diagnostics) {
        syntax_.text = std::move(text);
    }

    Syntax parse() {
        for (std::string_view word = words_.next(); !word.empty() && errors_ < most_errors; word = words_.next()) {
            if (const Form* form = find_form(word)) {
                lost_ = false;
                read_directive(word, *form);
            } else if (!lost_) {
                refuse(word, fmt::format("expected a directive such as Shape, {}{}", shown(word), hint(word)));
            }
        }
        if (errors_ == most_errors) {
            diagnostics_.error(syntax_.position(words_.next()), "too many errors: the rest of this file is not read");
        }
        return std::move(syntax_);
    }

private:
    // One message until the next directive.
    void refuse(std::string_view where, const std::string& message) {
        diagnostics_.error(syntax_.position(where), message);
        ++errors_;
        lost_ = true;
    }

    static std::string hint(std::string_view word) {
        std::vector<std::string> known;
        for (const Form& form : forms) {
            known.emplace_back(form.word);
        }
        const std::string question = word.size() < 40 ? did_you_mean(std::string(word), known) : "";
        return question.empty() ? "" : ";" + question;
    }

    void read_directive(std::string_view word, const Form& form) {
        Directive directive;
        directive.keyword = form.keyword;
        directive.word = word;
        if (!read_strings(form, directive) || !read_numbers(form, directive)) {
            return;
        }
        const std::size_t first = syntax_.parameters.size();
        if (form.parameters && !read_parameters()) {
            syntax_.parameters.resize(first);
            return;
        }
        directive.first_parameter = static_cast<std::uint32_t>(first);
        directive.parameter_count = static_cast<std::uint32_t>(syntax_.parameters.size() - first);
        syntax_.directives.push_back(directive);
    }

    bool read_strings(const Form& form, Directive& directive) {
        while (directive.string_count < form.most_strings) {
            const std::string_view next = words_.peek();
            const bool bare = form.keyword == Keyword::active_transform && !next.empty();
            if (!is_quoted(next) && !bare) {
                if (directive.string_count >= form.fewest_strings) {
                    return true;
                }
                refuse(next, fmt::format("{} needs {} quoted word{}: {}", form.word, form.fewest_strings,
                                         form.fewest_strings == 1 ? "" : "s", shown(next)));
                return false;
            }
            directive.strings[static_cast<std::size_t>(directive.string_count++)] = without_quotes(words_.next());
        }
        return true;
    }

    bool read_numbers(const Form& form, Directive& directive) {
        if (form.numbers == 0) {
            return true;
        }
        if (words_.peek() == "[") {
            words_.next();
            bool closed = false;
            directive.numbers = words_.up_to_bracket(closed);
            if (!closed) {
                refuse(directive.numbers.substr(0, 1), fmt::format("{}: the bracket is not closed", form.word));
            }
            return closed;
        }
        const char* begin = words_.peek().data();
        for (int i = 0; i < form.numbers; ++i) {
            const std::string_view next = words_.peek();
            if (next.empty() || next.front() == '"' || next == "[" || next == "]" || find_form(next)) {
                refuse(next, fmt::format("{} needs {} numbers: {}", form.word, form.numbers, shown(next)));
                return false;
            }
            words_.next();
        }
        directive.numbers = {begin, static_cast<std::size_t>(words_.here() - begin)};
        return true;
    }

    bool read_parameters() {
        while (true) {
            const std::string_view declaration = words_.peek();
            if (declaration.empty() || declaration.front() != '"') {
                return true;
            }
            words_.next();
            Parameter parameter;
            parameter.text = syntax_.text.get();
            Words inside(without_quotes(declaration));
            parameter.type = inside.next();
            parameter.name = inside.next();
            if (!is_quoted(declaration) || parameter.name.empty() || !inside.next().empty()) {
                refuse(declaration, fmt::format("expected a parameter such as \"float radius\", {}", shown(declaration)));
                return false;
            }
            std::string_view value = words_.peek();
            if (value == "[") {
                words_.next();
                bool closed = false;
                parameter.values = words_.up_to_bracket(closed);
                if (!closed) {
                    refuse(value, fmt::format("the bracket of \"{}\" is not closed", parameter.name));
                    return false;
                }
            } else if (value.empty() || value == "]" || find_form(value)) {
                refuse(value, fmt::format("\"{}\" needs a value: {}", parameter.name, shown(value)));
                return false;
            } else {
                parameter.values = words_.next();
            }
            syntax_.parameters.push_back(parameter);
        }
    }

    Words words_;
    Diagnostics& diagnostics_;
    Syntax syntax_;
    int errors_ = 0;
    bool lost_ = false;
};

}  // namespace

Syntax parse_syntax(std::shared_ptr<const SourceText> text, Diagnostics& diagnostics) {
    return Parser(std::move(text), diagnostics).parse();
}

}  // namespace lancer::pbrt
