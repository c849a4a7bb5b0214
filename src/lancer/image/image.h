// Pixels on the way to and from files.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace lancer {

// Linear floats, row-major, top row first, channels interleaved.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 3;  // 1 grey, 2 grey + alpha, 3 RGB, 4 RGBA
    std::vector<float> pixels;
};

// The same for eight bits a channel: colours as a display takes them, encoded as sRGB; alpha only scaled.
struct ByteImage {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::vector<std::uint8_t> pixels;
};

// Facts written into the file: "Software", "lancer:command", "lancer:scene", "lancer:hash", ...
using Metadata = std::map<std::string, std::string>;

// File endings that can be written, with the dot: ".png", ".jpg", ".jpeg", ".exr", ".hdr", ".tif", ".tiff".
const std::vector<std::string>& writable_endings();

// Writes beside the target and renames, so that nobody reads half a file. EXR, HDR and TIFF hold linear floats; PNG and JPEG are encoded as
// sRGB, clipped to [0, 1]. EXR is half float, unless a finite value needs more range. Formats without alpha lose it. The same arguments give
// the same bytes. Throws MachineFailure with the path and the reason; what stood at `path` is untouched then.
void write_image(const std::string& path, const Image& image, const Metadata& metadata);

// As above for pixels that are encoded already: ".png", ".jpg" and ".jpeg" only.
void write_image(const std::string& path, const ByteImage& image, const Metadata& metadata);

// How colours are stored in the file that is read.
enum class Encoding { automatic, linear, srgb };  // automatic: 8- and 16-bit integers are sRGB, floats linear

// Reads PNG, JPEG, EXR, HDR, TIFF, BMP, TGA, PNM, PFM and WebP; the first bytes say which, not the name. Alpha is as the file
// has it, never sRGB. Throws std::runtime_error with a sentence when the file is missing, broken or too large, MachineFailure when what
// reads images is not installed.
Image read_image(const std::string& path, Encoding encoding = Encoding::automatic);
// The same for a file's bytes in memory; `name` is for messages.
Image read_image(std::string_view bytes, const std::string& name, Encoding encoding);

// The same as the file has it: nothing is decoded. Integers of `bits` bits, 8 or 16, come as n / (2^bits - 1); floats have 0 bits.
struct StoredPixels {
    Image image;
    int bits = 0;
};
StoredPixels read_stored_pixels(const std::string& path);

// The same for a file's bytes in memory; `name` is for messages.
StoredPixels read_stored_pixels(std::string_view bytes, const std::string& name);

// The sRGB transfer curve [IEC 61966-2-1], both ways, for one value; not clipped, straight below zero.
float srgb_encode(float linear);
float srgb_decode(float encoded);

}  // namespace lancer
