// One element as a plugin: its type, and its properties by name. What nobody asks for is told to the user in the end.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "lancer/import/mitsuba/element.h"
#include "lancer/import/reader.h"

namespace lancer::mitsuba {

// Elements by their ids, wherever in the scene they stand; of two with the same id, the first.
class Ids {
public:
    void add(const Element& root, Diagnostics& diagnostics);
    // What a <ref> names; null, with an error, when there is no such thing.
    const Element* find(const Element& reference, Diagnostics& diagnostics) const;

private:
    std::map<std::string, const Element*> elements_;
    mutable std::set<const Element*> missed_;  // references that were said to lead nowhere
};

// "; did you mean "sphere"?", or nothing.
std::string hint(const std::string& word, const std::vector<std::string>& candidates);

class Plugin {
public:
    Plugin(const Element& element, const Ids& ids, ImportContext& context);

    const Element& element() const { return element_; }
    const std::string& type() const { return element_.attribute("type"); }
    const std::string& id() const { return element_.attribute("id"); }
    const SourcePosition& position() const { return element_.position; }
    // In messages: bsdf "diffuse".
    std::string title() const;

    // The property of this name, with a reference followed; null when it is not written.
    const Element* find(std::string_view name);
    // The first of several names that is written.
    const Element* find(std::initializer_list<std::string_view> names);
    bool has(std::string_view name) { return find(name) != nullptr; }

    // Values of properties; `preset` when they are not written or, with an error, when they are something else.
    double number(std::string_view name, double preset);
    double number(std::string_view name, double preset, double least, double most);
    int integer(std::string_view name, int preset);
    bool flag(std::string_view name, bool preset);
    std::string text(std::string_view name, std::string_view preset);
    glm::dvec3 vector(std::string_view name, const glm::dvec3& preset);
    std::optional<glm::dmat4> transform(std::string_view name);

    // The nested elements with one of these tags, with references followed, in the order of writing.
    struct Child {
        std::string name;
        const Element* element;
    };
    std::vector<Child> children(std::initializer_list<std::string_view> tags);

    // Marks a property that changes no picture, such as a hint for speed.
    void ignore(std::string_view name) { find(name); }
    // Warns of everything that nobody has asked for, and reports it as dropped.
    void finish();

private:
    const Element* target(std::size_t child);

    const Element& element_;
    const Ids& ids_;
    ImportContext& context_;
    std::vector<bool> asked_;
};

}  // namespace lancer::mitsuba
