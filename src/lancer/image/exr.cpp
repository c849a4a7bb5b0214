#include "lancer/image/exr.h"

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace lancer {
namespace {

class MemoryStream : public Imf::OStream {
public:
    MemoryStream() : Imf::OStream("memory") {}

    void write(const char data[], int size) override {
        const std::size_t end = place_ + static_cast<std::size_t>(size);
        if (end > bytes_.size()) {
            bytes_.resize(end);
        }
        std::memcpy(bytes_.data() + place_, data, static_cast<std::size_t>(size));
        place_ = end;
    }
    std::uint64_t tellp() override { return place_; }
    void seekp(std::uint64_t place) override { place_ = static_cast<std::size_t>(place); }

    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
    std::size_t place_ = 0;
};

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

constexpr float largest_half = 65504.0f;

bool fits_half(const std::vector<float>& values) {
    return std::all_of(values.begin(), values.end(), [](float v) { return !std::isfinite(v) || std::fabs(v) <= largest_half; });
}

// The layout of the samples in memory, interleaved as in `Image`.
template <class Sample>
void write_samples(MemoryStream& stream, Imf::Header& header, Imf::PixelType type, const std::vector<const char*>& names, int width,
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
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header, Imf::Chromaticities());  // the default ones are Rec. 709's, D65: those of sRGB
    for (const auto& [key, value] : metadata) {
        if (key.empty()) {
            continue;
        }
        // The names that the format uses itself ("channels", "compression", ...) are taken.
        const bool taken = header.find(key) != header.end() || key == "tiles" || key == "type" || key == "name" || key == "version" ||
                           key == "chunkCount" || key == "view";
        header.insert(taken ? "text:" + key : key, Imf::StringAttribute(value));
    }
    MemoryStream stream;
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
