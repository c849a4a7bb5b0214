// The parameters of one directive, by name and with their types checked.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/import/pbrt/syntax.h"
#include "lancer/import/reader.h"

namespace lancer::pbrt {

class Parameters {
public:
    // `owner` is what messages call it: Shape "sphere". Of the defaults, which Attribute gave, only those count that are not among `own`.
    Parameters(ImportContext& context, std::string owner, SourcePosition position, std::vector<Parameter> own,
               const std::vector<Parameter>* defaults = nullptr);

    ImportContext& context() const { return *context_; }
    const std::string& owner() const { return owner_; }
    const SourcePosition& position() const { return position_; }
    static SourcePosition position_of(const Parameter& parameter) { return parameter.text->position(parameter.name); }

    // Null when there is none. Counts as used.
    const Parameter* find(std::string_view name) const;
    bool has(std::string_view name) const { return find(name) != nullptr; }

    // One value; nothing when it is not there, or is no such value, which is an error.
    std::optional<double> number(std::string_view name) const;
    std::optional<int> integer(std::string_view name) const;
    std::optional<bool> boolean(std::string_view name) const;
    std::optional<std::string> string(std::string_view name) const;
    std::optional<glm::dvec3> triple(std::string_view name) const;  // point3, vector3, normal

    double number(std::string_view name, double otherwise) const { return number(name).value_or(otherwise); }
    int integer(std::string_view name, int otherwise) const { return integer(name).value_or(otherwise); }
    bool boolean(std::string_view name, bool otherwise) const { return boolean(name).value_or(otherwise); }
    std::string string(std::string_view name, const std::string& otherwise) const { return string(name).value_or(otherwise); }

    // Lists; empty when not there or not well-formed, which is an error.
    std::vector<double> numbers(std::string_view name) const;
    std::vector<float> floats(std::string_view name) const;
    std::vector<int> integers(std::string_view name) const;
    std::vector<glm::vec3> triples(std::string_view name) const;
    std::vector<glm::vec2> pairs(std::string_view name) const;
    std::vector<std::string> strings(std::string_view name) const;

    // The same of a parameter at hand.
    std::vector<double> numbers_of(const Parameter& parameter) const;
    std::vector<std::string> strings_of(const Parameter& parameter) const;

    void error(const Parameter& parameter, const std::string& message) const;

    // Read on purpose without a meaning: no word about it.
    void pass_over(std::initializer_list<std::string_view> names) const;

    // Warns of what nobody has asked for.
    void warn_of_unused() const;

private:
    template <class T>
    std::vector<T> list_of(const Parameter& parameter) const;
    template <class Vector>
    std::vector<Vector> vectors(std::string_view name, std::string_view expected) const;

    ImportContext* context_;
    std::string owner_;
    SourcePosition position_;
    std::vector<Parameter> parameters_;
    std::size_t own_count_;  // those after them are defaults, which need not be used
    mutable std::vector<bool> used_;
    mutable std::vector<std::string_view> asked_;
};

}  // namespace lancer::pbrt
