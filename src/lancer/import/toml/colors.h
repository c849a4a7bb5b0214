// Colours and textures, as linear RGB.
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

// The value of a key of Kind::color. On a mistake: an error and nothing.
std::optional<scene::Rgb> read_color(Messages& messages, const toml::node& node, const Key& key);
scene::Rgb read_color(TableReader& reader, std::string_view key);
std::optional<scene::Rgb> read_color_if_written(TableReader& reader, std::string_view key);

// Of Kind::texture. `data`: the texture holds numbers and no colours, so bytes are linear where nothing else is written.
scene::Texture read_texture(Context& context, TableReader& reader, std::string_view key, bool data = false);

// Of Kind::value.
scene::Value read_value(Context& context, TableReader& reader, std::string_view key);

}  // namespace lancer::notation
