// Measured curves from text files: ".csv", ".spd", ".txt".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/base/diagnostic.h"
#include "lancer/spectrum/curve.h"

namespace lancer {

// A wavelength in nm and `columns` values on each line, separated by commas, semicolons, tabs or spaces; decimal points. `#` begins a comment,
// empty lines do not count, and one line of column names may come first. Any order of wavelengths, each once.
// The result has one curve a column. What is wrong is an error at its line and column in `file`, and then there is no result; curves that miss
// the visible wavelengths are worth a warning.
std::optional<std::vector<SpectralCurve>> parse_curves(std::string_view text, const std::string& file, int columns,
                                                       SpectralCurve::Beyond beyond, Diagnostics& diagnostics);

// The same from a file of at most 16 MiB that the user named at `named_at`.
std::optional<SpectralCurve> read_curve(const std::string& path, const SourcePosition& named_at, SpectralCurve::Beyond beyond,
                                        Diagnostics& diagnostics);

}  // namespace lancer
