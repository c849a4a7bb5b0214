// Spectra and curves over wavelength.
#pragma once

#include <optional>

#include "lancer/import/toml/context.h"
#include "lancer/import/toml/table_reader.h"

namespace lancer::notation {

// Whether a table that stands for a colour is a spectrum: it has one of a spectrum's own keys.
bool is_spectrum(const toml::table& table);

// The table as the value of `key`, whose range and unit say what it is for: a share from 0 to 1, an absorption in 1/m, or a light. On a mistake:
// an error and nothing.
std::optional<scene::Spectrum> read_spectrum(Context& context, const toml::table& table, const Key& key);

// The value of a key of Kind::curve: a number, a file's name, or the table curve(). Each value keeps to the key's range. On a mistake as above.
std::optional<scene::MeasuredSpectrum> read_curve(Context& context, const toml::node& node, const Key& key);

}  // namespace lancer::notation
