#include "lancer/import/mitsuba/plugin.h"

#include <algorithm>

#include <fmt/format.h>

#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/import/mitsuba/values.h"

namespace lancer::mitsuba {

// ---- Ids --------------------------------------------------------------------------------------------------------------------------

void Ids::add(const Element& root, Diagnostics& diagnostics) {
    std::vector<const Element*> todo = {&root};
    std::vector<const Element*> aliases;
    while (!todo.empty()) {
        const Element& element = *todo.back();
        todo.pop_back();
        if (element.tag == "alias") {
            aliases.push_back(&element);
        } else if (element.tag != "ref" && element.find("id")) {
            const auto [found, is_new] = elements_.try_emplace(element.attribute("id"), &element);
            if (!is_new) {
                diagnostics.error(element.position, fmt::format("there are two things with the id {}", quoted(element.attribute("id"))));
            }
        }
        for (auto child = element.children.rbegin(); child != element.children.rend(); ++child) {
            todo.push_back(&*child);
        }
    }
    for (const Element* alias : aliases) {
        const auto found = elements_.find(alias->attribute("id"));
        if (found == elements_.end()) {
            diagnostics.error(alias->position, fmt::format("nothing has the id {}", quoted(alias->attribute("id"))));
        } else {
            elements_.try_emplace(alias->attribute("as"), found->second);
        }
    }
}

const Element* Ids::find(const Element& reference, Diagnostics& diagnostics) const {
    const std::string& id = reference.attribute("id");
    const auto found = elements_.find(id);
    if (found != elements_.end()) {
        return found->second;
    }
    if (missed_.insert(&reference).second) {
        std::vector<std::string> known;
        for (const auto& element : elements_) {
            known.push_back(element.first);
        }
        diagnostics.error(reference.position, fmt::format("nothing has the id {}{}", quoted(id), hint(id, known)));
    }
    return nullptr;
}

std::string hint(const std::string& word, const std::vector<std::string>& candidates) {
    const std::string question = did_you_mean(word, candidates);
    return question.empty() ? question : ";" + question;
}

// ---- Plugins ----------------------------------------------------------------------------------------------------------------------

Plugin::Plugin(const Element& element, const Ids& ids, ImportContext& context)
    : element_(element), ids_(ids), context_(context), asked_(element.children.size(), false) {}

std::string Plugin::title() const { return type().empty() ? element_.tag : fmt::format("{} {}", element_.tag, quoted(type())); }

const Element* Plugin::target(std::size_t child) {
    const Element& element = element_.children[child];
    return element.tag == "ref" ? ids_.find(element, context_.diagnostics) : &element;
}

const Element* Plugin::find(std::string_view name) {
    for (std::size_t i = 0; i < element_.children.size(); ++i) {
        if (element_.children[i].attribute("name") == name) {
            asked_[i] = true;
            return target(i);
        }
    }
    return nullptr;
}

const Element* Plugin::find(std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
        if (const Element* element = find(name)) {
            return element;
        }
    }
    return nullptr;
}

double Plugin::number(std::string_view name, double preset) {
    const Element* element = find(name);
    if (!element) {
        return preset;
    }
    const auto number = parse_number(element->attribute("value"));
    if (!number) {
        context_.diagnostics.error(element->position,
                                   fmt::format("\"{}\": expected a number, found {}", name, quoted(element->attribute("value"))));
    }
    return number.value_or(preset);
}

double Plugin::number(std::string_view name, double preset, double least, double most) {
    const double value = number(name, preset);
    if (value < least || value > most) {
        context_.diagnostics.error(find(name)->position, fmt::format("\"{}\" is {}: expected {} to {}", name, value, least, most));
        return preset;
    }
    return value;
}

int Plugin::integer(std::string_view name, int preset) {
    const Element* element = find(name);
    if (!element) {
        return preset;
    }
    const auto number = parse_integer(element->attribute("value"));
    if (!number) {
        context_.diagnostics.error(element->position,
                                   fmt::format("\"{}\": expected a whole number, found {}", name, quoted(element->attribute("value"))));
    }
    return number.value_or(preset);
}

bool Plugin::flag(std::string_view name, bool preset) {
    const Element* element = find(name);
    if (!element) {
        return preset;
    }
    const std::string& value = element->attribute("value");
    if (value != "true" && value != "false" && value != "True" && value != "False") {
        context_.diagnostics.error(element->position, fmt::format("\"{}\": expected true or false, found {}", name, quoted(value)));
        return preset;
    }
    return value == "true" || value == "True";
}

std::string Plugin::text(std::string_view name, std::string_view preset) {
    const Element* element = find(name);
    return element ? element->attribute("value") : std::string(preset);
}

glm::dvec3 Plugin::vector(std::string_view name, const glm::dvec3& preset) {
    const Element* element = find(name);
    return element ? vector_of(*element, 0.0, context_.diagnostics) : preset;
}

std::optional<glm::dmat4> Plugin::transform(std::string_view name) {
    const Element* element = find(name);
    return element ? std::optional(transform_of(*element, context_.diagnostics)) : std::nullopt;
}

std::vector<Plugin::Child> Plugin::children(std::initializer_list<std::string_view> tags) {
    std::vector<Child> found;
    for (std::size_t i = 0; i < element_.children.size(); ++i) {
        const Element& written = element_.children[i];
        const bool wanted = std::find(tags.begin(), tags.end(), written.tag) != tags.end();
        if (!wanted && written.tag != "ref") {
            continue;
        }
        const Element* element = target(i);
        if (element && std::find(tags.begin(), tags.end(), element->tag) != tags.end()) {
            asked_[i] = true;
            found.push_back({written.attribute("name"), element});
        }
        asked_[i] = asked_[i] || !element;
    }
    return found;
}

void Plugin::finish() {
    for (std::size_t i = 0; i < asked_.size(); ++i) {
        const Element& child = element_.children[i];
        if (asked_[i] || child.tag == "alias") {
            continue;
        }
        const std::string name = child.find("name") ? quoted(child.attribute("name")) : fmt::format("<{}>", child.tag);
        context_.diagnostics.warning(child.position, fmt::format("{}: {} means nothing here", title(), name));
        context_.report.dropped(fmt::format("{}: {}", title(), name), "unknown here", child.position);
    }
}

}  // namespace lancer::mitsuba
