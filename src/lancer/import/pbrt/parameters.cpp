#include "lancer/import/pbrt/parameters.h"

#include <algorithm>

#include <fmt/format.h>

#include "lancer/import/pbrt/numbers.h"

namespace lancer::pbrt {

Parameters::Parameters(ImportContext& context, std::string owner, SourcePosition position, std::vector<Parameter> own,
                       const std::vector<Parameter>* defaults)
    : context_(&context), owner_(std::move(owner)), position_(std::move(position)), parameters_(std::move(own)) {
    own_count_ = parameters_.size();
    if (defaults != nullptr) {
        for (const Parameter& given : *defaults) {
            const auto same = [&](const Parameter& p) { return p.name == given.name; };
            if (std::none_of(parameters_.begin(), parameters_.end(), same)) {
                parameters_.push_back(given);
            }
        }
    }
    used_.resize(parameters_.size());
}

// Where a name stands twice, the last one counts.
const Parameter* Parameters::find(std::string_view name) const {
    const Parameter* found = nullptr;
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
        if (parameters_[i].name == name) {
            used_[i] = true;
            found = &parameters_[i];
        }
    }
    if (found == nullptr) {
        asked_.push_back(name);
    }
    return found;
}

void Parameters::error(const Parameter& parameter, const std::string& message) const {
    context_->diagnostics.error(position_of(parameter), fmt::format("{}: {}", owner_, message));
}

template <class T>
std::vector<T> Parameters::list_of(const Parameter& parameter) const {
    std::vector<T> list;
    const std::string_view wrong = for_each_number<T>(parameter.values, [&](T number) { list.push_back(number); });
    if (!wrong.empty()) {
        context_->diagnostics.error(parameter.text->position(wrong),
                                    fmt::format("{}: \"{}\" needs {}numbers, found {}", owner_, parameter.name,
                                                std::is_integral_v<T> ? "whole " : "", wrong.substr(0, 40)));
        list.clear();
    }
    return list;
}

template <class Vector>
std::vector<Vector> Parameters::vectors(std::string_view name, std::string_view expected) const {
    std::vector<Vector> list;
    const Parameter* parameter = find(name);
    if (parameter == nullptr) {
        return list;
    }
    constexpr int size = Vector::length();
    Vector vector;
    int part = 0;
    const std::string_view wrong = for_each_number<float>(parameter->values, [&](float number) {
        vector[part++] = number;
        if (part == size) {
            list.push_back(vector);
            part = 0;
        }
    });
    if (!wrong.empty()) {
        context_->diagnostics.error(parameter->text->position(wrong),
                                    fmt::format("{}: \"{}\" needs numbers, found {}", owner_, name, wrong.substr(0, 40)));
        list.clear();
    } else if (part != 0) {
        error(*parameter, fmt::format("\"{}\" needs {}: their number is no multiple of {}", name, expected, size));
        list.clear();
    }
    return list;
}

std::optional<double> Parameters::number(std::string_view name) const {
    const Parameter* parameter = find(name);
    if (parameter == nullptr) {
        return std::nullopt;
    }
    const std::vector<double> list = list_of<double>(*parameter);
    if (list.size() != 1) {
        error(*parameter, fmt::format("\"{}\" needs one number", name));
        return std::nullopt;
    }
    return list[0];
}

std::optional<int> Parameters::integer(std::string_view name) const {
    const Parameter* parameter = find(name);
    if (parameter == nullptr) {
        return std::nullopt;
    }
    const std::vector<int> list = list_of<int>(*parameter);
    if (list.size() != 1) {
        error(*parameter, fmt::format("\"{}\" needs one whole number", name));
        return std::nullopt;
    }
    return list[0];
}

// Version 3 wrote them in quotes.
std::optional<bool> Parameters::boolean(std::string_view name) const {
    const Parameter* parameter = find(name);
    if (parameter == nullptr) {
        return std::nullopt;
    }
    Words words(parameter->values);
    const std::string_view word = without_quotes(words.next());
    if ((word != "true" && word != "false") || !words.next().empty()) {
        error(*parameter, fmt::format("\"{}\" must be true or false", name));
        return std::nullopt;
    }
    return word == "true";
}

std::optional<std::string> Parameters::string(std::string_view name) const {
    const Parameter* parameter = find(name);
    if (parameter == nullptr) {
        return std::nullopt;
    }
    std::vector<std::string> list = strings_of(*parameter);
    if (list.size() != 1) {
        error(*parameter, fmt::format("\"{}\" needs one word in quotes", name));
        return std::nullopt;
    }
    return std::move(list[0]);
}

std::optional<glm::dvec3> Parameters::triple(std::string_view name) const {
    const Parameter* parameter = find(name);
    if (parameter == nullptr) {
        return std::nullopt;
    }
    const std::vector<double> list = list_of<double>(*parameter);
    if (list.size() != 3) {
        error(*parameter, fmt::format("\"{}\" needs three numbers", name));
        return std::nullopt;
    }
    return glm::dvec3(list[0], list[1], list[2]);
}

std::vector<double> Parameters::numbers_of(const Parameter& parameter) const { return list_of<double>(parameter); }

std::vector<double> Parameters::numbers(std::string_view name) const {
    const Parameter* parameter = find(name);
    return parameter == nullptr ? std::vector<double>() : list_of<double>(*parameter);
}

std::vector<float> Parameters::floats(std::string_view name) const {
    const Parameter* parameter = find(name);
    return parameter == nullptr ? std::vector<float>() : list_of<float>(*parameter);
}

std::vector<int> Parameters::integers(std::string_view name) const {
    const Parameter* parameter = find(name);
    return parameter == nullptr ? std::vector<int>() : list_of<int>(*parameter);
}

std::vector<glm::vec3> Parameters::triples(std::string_view name) const { return vectors<glm::vec3>(name, "points of three numbers"); }
std::vector<glm::vec2> Parameters::pairs(std::string_view name) const { return vectors<glm::vec2>(name, "points of two numbers"); }

std::vector<std::string> Parameters::strings_of(const Parameter& parameter) const {
    std::vector<std::string> list;
    Words words(parameter.values);
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        if (!is_quoted(word)) {
            context_->diagnostics.error(parameter.text->position(word), fmt::format("{}: \"{}\" needs words in quotes, found {}", owner_,
                                                                                    parameter.name, word.substr(0, 40)));
            return {};
        }
        list.push_back(unescaped(word));
    }
    return list;
}

std::vector<std::string> Parameters::strings(std::string_view name) const {
    const Parameter* parameter = find(name);
    return parameter == nullptr ? std::vector<std::string>() : strings_of(*parameter);
}

void Parameters::pass_over(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names) {
        find(name);
    }
}

void Parameters::warn_of_unused() const {
    for (std::size_t i = 0; i < own_count_; ++i) {
        if (used_[i]) {
            continue;
        }
        const std::string name(parameters_[i].name.substr(0, 60));
        const std::string question = did_you_mean(name, {asked_.begin(), asked_.end()});
        context_->diagnostics.warning(position_of(parameters_[i]), fmt::format("{} has no parameter \"{}\": it is passed over{}", owner_,
                                                                               name, question.empty() ? "" : ";" + question));
    }
}

}  // namespace lancer::pbrt
