#include "lancer/image/exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <half.h>

#include <algorithm>
#include <vector>

#include "lancer/image/exr_stream.h"

namespace lancer {
namespace {

std::vector<const char*> channel_names(int channels) {
    switch (channels) {
        case 1:
            return {"Y"};
        case 2:
            return {"Y", "A"};
        case 3:
            return {"R", "G", "B"};
        default:
            return {"R", "G", "B", "A"};
    }
}

// The layout of the samples in memory, interleaved as in `Image`.
template <class Sample>
void write_samples(ExrMemory& stream, Imf::Header& header, Imf::PixelType type, const std::vector<const char*>& names, int width,
                   int height, const Sample* samples) {
    const std::size_t pixel = sizeof(Sample) * names.size();
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < names.size(); ++c) {
        header.channels().insert(names[c], Imf::Channel(type));
        char* base = const_cast<char*>(reinterpret_cast<const char*>(samples + c));
        buffer.insert(names[c], Imf::Slice(type, base, pixel, pixel * static_cast<std::size_t>(width)));
    }
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(buffer);
    file.writePixels(height);
}

}  // namespace

std::string encode_exr(const Image& image, const Metadata& metadata) {
    Imf::Header header = exr_header(image.width, image.height, metadata);
    ExrMemory stream;
    const std::vector<const char*> names = channel_names(image.channels);
    if (fits_half(image.pixels)) {
        std::vector<half> halves(image.pixels.size());
        std::transform(image.pixels.begin(), image.pixels.end(), halves.begin(), [](float v) { return half(v); });
        write_samples(stream, header, Imf::HALF, names, image.width, image.height, halves.data());
    } else {
        write_samples(stream, header, Imf::FLOAT, names, image.width, image.height, image.pixels.data());
    }
    return stream.take();
}

}  // namespace lancer
