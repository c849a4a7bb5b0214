// Colours and textures.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/import/toml/context.h"
#include "lancer/import/toml/table_reader.h"

namespace lancer::notation {

// "#rgb", "#rrggbb" or one of color_names(), decoded from sRGB; nothing when it is neither.
std::optional<scene::Rgb> parse_color(std::string_view text);
const std::vector<std::string>& color_names();  // the seventeen of CSS 2.1

// The value of a key of Kind::rgb. On a mistake: an error and nothing, or the default.
std::optional<scene::Rgb> read_rgb(Messages& messages, const toml::node& node, const Key& key);
scene::Rgb read_rgb(TableReader& reader, std::string_view key);

// The same of a key of Kind::color, where a spectrum may stand, too.
std::optional<scene::Color> read_color(Context& context, const toml::node& node, const Key& key);
scene::Color read_color(Context& context, TableReader& reader, std::string_view key);
std::optional<scene::Color> read_color_if_written(Context& context, TableReader& reader, std::string_view key);

// Of Kind::texture. `data`: the texture holds numbers and no colours, so bytes are linear where nothing else is written.
scene::Texture read_texture(Context& context, TableReader& reader, std::string_view key, bool data = false);

// Of Kind::value.
scene::Value read_value(Context& context, TableReader& reader, std::string_view key);

}  // namespace lancer::notation
