// PNG files: the program's own output and the commonest textures, so that neither needs the module.
#pragma once

#include <cstdint>
#include <string>

#include "lancer/image/image.h"

namespace lancer {

// The bytes of a file with 8 bits a channel, marked as sRGB, and the metadata as text chunks. Throws std::runtime_error with the reason.
std::string encode_png(const ByteImage& image, const Metadata& metadata);

// Reads in two steps, so that the caller can refuse a size before memory is taken for it. Throws std::runtime_error with the reason.
class PngReader {
public:
    explicit PngReader(const std::string& path);
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader();

    int width() const { return width_; }
    int height() const { return height_; }
    int channels() const { return channels_; }
    int bits() const { return bits_; }  // 8 or 16

    // width * height * channels values n / (2^bits - 1), as stored, interleaved, top row first.
    void read(float* pixels);

private:
    struct State;
    State* state_;
    int width_ = 0;
    int height_ = 0;
    int channels_ = 0;
    int bits_ = 0;
};

}  // namespace lancer
