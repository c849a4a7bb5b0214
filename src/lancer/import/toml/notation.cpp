#include "lancer/import/toml/notation.h"

#include <fmt/format.h>

#include <cmath>

namespace lancer::notation {

bool Range::holds(double value) const {
    const bool low = above_least ? value > least : value >= least;
    const bool high = below_most ? value < most : value <= most;
    return low && high;
}

std::string to_words(const Range& range) {
    const bool low = std::isfinite(range.least);
    const bool high = std::isfinite(range.most);
    if (low && high && !range.above_least && !range.below_most) {
        return fmt::format("from {} to {}", range.least, range.most);
    }
    std::string text;
    if (low) {
        text = fmt::format("{} {}", range.above_least ? "more than" : "at least", range.least);
    }
    if (high) {
        text += fmt::format("{}{} {}", low ? " and " : "", range.below_most ? "less than" : "at most", range.most);
    }
    return text;
}

const Key* Table::find(std::string_view key) const {
    for (const Key& candidate : keys) {
        if (candidate.name == key) {
            return &candidate;
        }
    }
    return nullptr;
}

std::span<const Table* const> shapes() {
    static const Table* const all[] = {&sphere(), &box(), &plane(), &disk(), &cylinder(), &cone(), &mesh()};
    return all;
}

std::span<const Table* const> lights() {
    static const Table* const all[] = {&point_light(),     &spot_light(),        &directional_light(),
                                       &projector_light(), &goniometric_light(), &ies_light()};
    return all;
}

std::span<const Table* const> materials() {
    static const Table* const all[] = {&whitted_material(),    &diffuse_material(), &conductor_material(),
                                       &dielectric_material(), &plastic_material(), &principled_material(),
                                       &burley_material(),     &mix_material(),     &null_material()};
    return all;
}

namespace {

std::vector<Section> with_shapes(std::vector<Section> sections) {
    for (const Table* table : shapes()) {
        sections.push_back({Form::list, table->name, {table}});
    }
    return sections;
}

}  // namespace

std::span<const Section> file_sections() {
    static const std::vector<Section> all = with_shapes({{Form::camera, "camera", {&camera()}},
                                                         {Form::list, "light", {lights().begin(), lights().end()}},
                                                         {Form::named, "material", {materials().begin(), materials().end()}},
                                                         {Form::named, "medium", {&medium()}},
                                                         {Form::list, "group", {&group()}},
                                                         {Form::list, "place", {&place()}},
                                                         {Form::list, "include", {&include()}},
                                                         {Form::color, "background", {&background()}},
                                                         {Form::single, "sky", {&clear_sky()}},
                                                         {Form::color, "ambient", {&ambient()}},
                                                         {Form::single, "render", {&render()}}});
    return all;
}

std::span<const Section> group_sections() {
    static const std::vector<Section> all = with_shapes({{Form::list, "place", {&place()}}});
    return all;
}

}  // namespace lancer::notation
