#include "lancer/import/toml/contents.h"

#include <fmt/format.h>

#include <algorithm>

#include "lancer/import/toml/shapes.h"
#include "lancer/import/toml/transforms.h"

namespace lancer::notation {

namespace {

NamedPlacement read_placement(Context& context, Materials& materials, const toml::table& table) {
    TableReader reader(context.messages, table, place());
    NamedPlacement result;
    result.group = reader.text("group");
    result.group_position = reader.position("group");
    result.placement.position = reader.position();
    if (const int material = materials.read(reader, "material"); material >= 0) {
        result.placement.material = material;
    }
    result.placement.to_parent = read_transform(reader);
    return result;
}

template <class Thing>
void sort_as_written(std::vector<Thing>& things, SourcePosition (*position)(const Thing&)) {
    const auto place_of = [&](const Thing& thing) {
        const SourcePosition at = position(thing);
        return std::pair(at.line, at.column);
    };
    std::stable_sort(things.begin(), things.end(), [&](const Thing& a, const Thing& b) { return place_of(a) < place_of(b); });
}

}  // namespace

std::vector<const toml::table*> tables_of(Messages& messages, const toml::table& parent, std::string_view name) {
    std::vector<const toml::table*> tables;
    const toml::node* node = parent.get(name);
    if (!node) {
        return tables;
    }
    const toml::array* array = node->as_array();
    if (!array) {
        messages.error(messages.at(*node), fmt::format("there may be several, so write [[{}]] instead of {}", name,
                                                       node->is_table() ? fmt::format("[{}]", name) : std::string(what_it_is(*node))));
        return tables;
    }
    for (const toml::node& element : *array) {
        if (const toml::table* table = element.as_table()) {
            tables.push_back(table);
        } else {
            messages.error(messages.at(element), fmt::format("\"{}\" must hold tables, not {}", name, what_it_is(element)));
        }
    }
    return tables;
}

Contents read_contents(Context& context, Materials& materials, const toml::table& table) {
    Contents contents;
    for (std::size_t kind = 0; kind < shapes().size(); ++kind) {
        for (const toml::table* shape : tables_of(context.messages, table, shapes()[kind]->name)) {
            if (auto object = read_object(context, materials, *shape, kind)) {
                contents.objects.push_back(std::move(*object));
            }
        }
    }
    for (const toml::table* placement : tables_of(context.messages, table, place().name)) {
        contents.placements.push_back(read_placement(context, materials, *placement));
    }
    sort_as_written<scene::Object>(contents.objects, [](const scene::Object& object) { return object.position; });
    sort_as_written<NamedPlacement>(contents.placements, [](const NamedPlacement& named) { return named.placement.position; });
    return contents;
}

}  // namespace lancer::notation
