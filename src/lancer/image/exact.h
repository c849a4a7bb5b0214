// Whether two pictures are the same to the last bit.
#pragma once

#include <string>

#include "lancer/image/layers.h"

namespace lancer {

// Throws std::runtime_error with a sentence when sizes differ; the names are those of the files.
void check_same_size(const LayeredImage& a, const std::string& name_a, const LayeredImage& b, const std::string& name_b);

// The first difference of the channels and their pixels, bit by bit, in words; empty when there is none. Metadata are not looked at. Throws as
// `check_same_size` does.
std::string exact_difference(const LayeredImage& a, const std::string& name_a, const LayeredImage& b, const std::string& name_b);

}  // namespace lancer
