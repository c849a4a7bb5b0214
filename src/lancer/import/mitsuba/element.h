// A scene file as a tree of elements: includes, defaults and parameters are already resolved, nothing is understood yet.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lancer/base/diagnostic.h"

namespace lancer::mitsuba {

struct Element {
    std::string tag;  // "shape", "float", ...
    std::vector<std::pair<std::string, std::string>> attributes;
    std::vector<Element> children;
    SourcePosition position;

    // The value of an attribute; null when it is not written.
    const std::string* find(std::string_view name) const {
        for (const auto& [key, value] : attributes) {
            if (key == name) {
                return &value;
            }
        }
        return nullptr;
    }
    // The same; empty when it is not written.
    const std::string& attribute(std::string_view name) const {
        static const std::string nothing;
        const std::string* value = find(name);
        return value ? *value : nothing;
    }
};

}  // namespace lancer::mitsuba
