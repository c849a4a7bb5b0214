// What a picture says of itself.
#pragma once

#include <string>
#include <string_view>

#include "lancer/image/image.h"

namespace lancer {

// The texts that lancer writes into PNG ("tEXt", "iTXt"), HDR (lines of the header), JPEG and TIFF (lines "key: value" of the description), by their
// keys; of HDR, JPEG and TIFF only keys that begin with "lancer:", and the first line of their values. EXR files: see read_layers. Whatever the
// bytes, what can't be read is left out.
Metadata texts_in_picture(std::string_view bytes);

}  // namespace lancer
