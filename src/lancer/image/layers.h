// Pictures of any number of named channels: colour, what the camera saw beside it (normals, depth, ...), how sure it is, spectra.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/image/image.h"

namespace lancer {

// How a channel stands in the file. Half holds 11 bits of a number up to 65504.
enum class Stored { half, float32, uint32 };

// One plane of the picture, row-major, top row first. Names are those of OpenEXR: "R", "G", "B", "A" for the picture itself, "layer.part" for
// everything beside it: "albedo.R", "normal.X", "depth.Z", "variance.R" (of the pixel's mean, not of a sample), "samples" (how many).
struct Channel {
    std::string name;
    Stored stored = Stored::half;
    std::vector<float> values;           // width * height of them, unless stored as uint32
    std::vector<std::uint32_t> numbers;  // in their place if stored as uint32
};

struct LayeredImage {
    int width = 0;
    int height = 0;
    std::vector<Channel> channels;  // in any order; each name once
    Metadata metadata;              // string attributes; keys that OpenEXR uses itself are written as "text:key"
    bool display = false;           // read from integers that are encoded for displays (PNG, JPEG, ...): nothing above 1 could be stored
};

// Null when there is none of this name.
const Channel* find_channel(const LayeredImage& image, std::string_view name);

// The channel of one of `count` even parts of the visible, 360 to 830 nm, by its middle: "S0.594,500000nm".
std::string spectral_channel(int bin, int count);

// The channels `names` (one to four) interleaved; missing ones are filled with zeros.
Image picture_of(const LayeredImage& image, const std::vector<std::string>& names);

// The other way round: "R", "G", "B" or "Y", and "A", as float32.
LayeredImage split_channels(const Image& image);

// Writes OpenEXR (the ending must be ".exr"), ZIP compressed, beside the target and renamed into place. A layer whose finite values overflow a
// half is stored as float32 as a whole. The same image gives the same bytes, whatever the order of its channels. Throws MachineFailure with
// the path and the reason; what stood at `path` is untouched then.
void write_layers(const std::string& path, const LayeredImage& image);

// Reads every flat OpenEXR file: scanlines or tiles, half, float or uint. Of several parts, those of the first one's size; their channels are
// named "part.channel" when the plain name is taken. Other formats come as "R", "G", "B" or "Y", and "A", decoded to linear light as by
// `read_image`. Throws as `read_image` does.
LayeredImage read_layers(const std::string& path);

}  // namespace lancer
