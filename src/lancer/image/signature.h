// What can be known of an image file before a library touches it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace lancer {

// OpenImageIO's name of the format; empty when unknown. `ending` (with its dot, lower case) decides for TGA, which has no signature.
std::string image_format(std::string_view first_bytes, std::string_view ending);

// Whether each attribute of an OpenEXR file's headers fits into the file: OpenEXR takes the memory that an attribute claims before it reads it.
bool exr_attributes_fit(const std::string& path, std::uint64_t file_bytes);

}  // namespace lancer
