// Whether a TIFF file was cut short: what reads TIFF fills up what is missing, and says nothing.
#pragma once

#include <string_view>

namespace lancer {

// True where all pixel data that the file's directories speak of lies within it [TIFF 6.0, sections 2 and 15].
bool is_whole_tiff(std::string_view bytes);

}  // namespace lancer
