// Photometric files of lamps: ANSI/IES LM-63, ".ies". See SUPPORT.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/lights.h"

namespace lancer {

// Intensities in candela, all factors of the file multiplied in, all around the lamp whatever symmetry the file makes use of. Nothing, and at least
// one error, when the file can't be read.
std::optional<scene::Photometry> read_ies(std::string_view text, const std::string& file, Diagnostics& diagnostics);

}  // namespace lancer
