// Numbers of a material that may come from a texture.
#include <fmt/format.h>

#include "lancer/import/toml/colors.h"

namespace lancer::notation {

scene::Value read_value(Context& context, TableReader& reader, std::string_view name) {
    const Key& key = reader.described(name, Kind::value);
    scene::Value value(std::get<double>(key.preset));
    const toml::node* node = reader.value(name, Kind::value);
    if (!node) {
        return value;
    }
    if (const toml::table* table = node->as_table()) {
        TableReader inside(context.messages, *table, texture_value());
        if (inside.has("texture")) {
            value.texture = read_texture(context, inside, "texture", true);
        }
        value.channel = static_cast<scene::Channel>(inside.choice("channel"));
        value.scale = inside.number("scale");
        value.offset = inside.number("offset");
        if (!inside.good()) {
            reader.spoil();
        }
    } else if (!node->is_number()) {
        reader.error(name,
                     fmt::format("\"{}\" must be a number or {{ texture, channel, scale, offset }}, not {}", name, what_it_is(*node)));
    } else if (!read_number(context.messages, *node, key, value.number)) {
        reader.spoil();
    }
    return value;
}

}  // namespace lancer::notation
