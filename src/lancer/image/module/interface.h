// What the program and the module that reads and writes the less common image formats say to each other. C linkage and plain data: the module
// is loaded when it is needed, since linking OpenImageIO costs every start of the program 200 ms and 134 MB.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

// Raised when anything below changes.
inline constexpr int lancer_images_version = 1;

struct LancerImageHeader {
    std::int32_t width;
    std::int32_t height;
    std::int32_t channels;  // 1 grey, 2 grey + alpha, 3 RGB, 4 RGBA
    std::int32_t bits;      // of a stored integer; 0 for floats
    std::uint64_t stored;   // bytes of all the pixels, uncompressed, as the file declares them
};

struct LancerText {
    const char* key;
    const char* value;
};

struct LancerImageToWrite {
    const char* format;  // "jpeg", "tiff"
    std::int32_t width;
    std::int32_t height;
    std::int32_t channels;
    const float* floats;        // one of the two
    const std::uint8_t* bytes;  // sRGB
    const LancerText* texts;
    std::size_t text_count;
};

// Receives a sentence, or parts of the written file.
using LancerSink = void (*)(void* receiver, const char* data, std::size_t size);

// A reader, or null and the reason. `format` is OpenImageIO's name.
using LancerOpenImage = void* (*)(const char* path, const char* format, LancerImageHeader* header, void* receiver, LancerSink reason);
// Fills width * height * channels floats, interleaved, top row first; false and the reason when the file is broken.
using LancerReadImage = bool (*)(void* reader, float* pixels, void* receiver, LancerSink reason);
using LancerCloseImage = void (*)(void* reader);
// The bytes of the file; false and the reason when it can't be encoded.
using LancerEncodeImage = bool (*)(const LancerImageToWrite* image, void* receiver, LancerSink bytes, void* reason_receiver,
                                   LancerSink reason);

// The one symbol that the module exports, "lancer_images".
struct LancerImages {
    int version;
    LancerOpenImage open;
    LancerReadImage read;
    LancerCloseImage close;
    LancerEncodeImage encode;
};
}
