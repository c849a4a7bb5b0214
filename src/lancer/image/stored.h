// Files of pixels as they are found: what can be said before and while they are read.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "lancer/image/image.h"

namespace lancer {

// The name of the format as `image_format` has it, and the file's size in bytes. Throws std::runtime_error with a sentence when there is no such
// file, or when it is no image.
struct FoundImage {
    std::string format;
    std::uint64_t bytes = 0;
};
FoundImage find_image(const std::string& path);

// Throws std::runtime_error when the picture is larger than any that is read, or could not come from so small a file: `stored` is the size of
// all the pixels, uncompressed.
void check_size(std::int64_t width, std::int64_t height, std::uint64_t stored, std::uint64_t file_bytes);

// "cannot read the image PATH: REASON"
[[noreturn]] void fail_to_read(const std::string& path, const std::string& reason);

// As `read_image`; `encoded` tells whether the colours were stored as integers for a display.
Image read_image(const std::string& path, Encoding encoding, bool& encoded);

}  // namespace lancer
