// Layered pictures as OpenEXR files.
#pragma once

#include <cstdint>
#include <string>

#include "lancer/image/layers.h"

namespace lancer {

// The bytes of the file. Throws std::exception with the reason.
std::string encode_exr_layers(const LayeredImage& image);

// Throws std::exception with the reason, without the path.
LayeredImage read_exr_layers(const std::string& path, std::uint64_t file_bytes);

}  // namespace lancer
