#include "lancer/import/mitsuba/optics.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lancer/import/mesh/mesh_messages.h"
#include "lancer/import/mitsuba/values.h"

namespace lancer::mitsuba {

namespace {

// Gases at 0 degrees and one atmosphere, liquids at 20 degrees, solids at room temperature; all for yellow light.
constexpr std::pair<std::string_view, double> indices[] = {
    {"vacuum", 1.0},      {"helium", 1.000036},        {"hydrogen", 1.000132},
    {"air", 1.000277},    {"carbon dioxide", 1.00045}, {"water", 1.3330},
    {"acetone", 1.36},    {"ethanol", 1.361},          {"carbon tetrachloride", 1.461},
    {"glycerol", 1.4729}, {"benzene", 1.501},          {"silicone oil", 1.52045},
    {"bromine", 1.661},   {"water ice", 1.31},         {"fused quartz", 1.458},
    {"pyrex", 1.470},     {"acrylic glass", 1.49},     {"polypropylene", 1.49},
    {"bk7", 1.5046},      {"sodium chloride", 1.544},  {"amber", 1.55},
    {"pet", 1.5750},      {"diamond", 2.419},
};

}  // namespace

std::optional<double> find_index(std::string_view name) {
    for (const auto& [known, index] : indices) {
        if (known == name) {
            return index;
        }
    }
    return std::nullopt;
}

double index_or(Builder& builder, Plugin& plugin, std::string_view name, std::string_view preset) {
    const Element* element = plugin.find(name);
    const std::string written = element ? element->attribute("value") : std::string(preset);
    if (const auto number = parse_number(written)) {
        if (*number > 0.0) {
            return *number;
        }
        builder.error(element->position, fmt::format("\"{}\" is {}: expected an index above 0", name, *number));
        return 1.5;
    }
    if (const auto index = find_index(written)) {
        return *index;
    }
    std::vector<std::string> known;
    for (const auto& entry : indices) {
        known.emplace_back(entry.first);
    }
    builder.error(element->position, fmt::format("no material of an index is called {}{}", quoted(written), hint(written, known)));
    return 1.5;
}

}  // namespace lancer::mitsuba
