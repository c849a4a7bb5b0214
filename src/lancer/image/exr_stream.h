// What the writers of OpenEXR share: bytes in memory, and text in headers.
#pragma once

#include <ImfHeader.h>
#include <ImfIO.h>

#include <cstdint>
#include <string>
#include <vector>

#include "lancer/image/image.h"

namespace lancer {

class ExrMemory : public Imf::OStream {
public:
    ExrMemory() : Imf::OStream("memory") {}

    void write(const char data[], int size) override;
    std::uint64_t tellp() override { return place_; }
    void seekp(std::uint64_t place) override { place_ = static_cast<std::size_t>(place); }

    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
    std::size_t place_ = 0;
};

// A header for a ZIP compressed picture in linear light of sRGB's primaries, with the metadata as string attributes. Keys that the format uses
// itself get "text:" in front.
Imf::Header exr_header(int width, int height, const Metadata& metadata);

// Whether no finite value is too large for a half.
bool fits_half(const std::vector<float>& values);

}  // namespace lancer
