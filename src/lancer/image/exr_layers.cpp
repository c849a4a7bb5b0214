#include "lancer/image/exr_layers.h"

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfOutputFile.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <stdexcept>

#include "lancer/image/signature.h"
#include "lancer/image/stored.h"

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

// Linear light of sRGB's primaries, ZIP compressed. Keys that the format uses itself get "text:" in front.
Imf::Header make_header(int width, int height, const Metadata& metadata) {
    Imf::Header header(width, height);
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
    return header;
}

bool fits_half(const std::vector<float>& values) {
    constexpr float largest_half = 65504.0f;
    return std::all_of(values.begin(), values.end(), [](float v) { return !std::isfinite(v) || std::fabs(v) <= largest_half; });
}

// "albedo" of "albedo.R"; nothing for the picture itself.
std::string layer_of(const std::string& channel) {
    const std::size_t dot = channel.rfind('.');
    return dot == std::string::npos ? "" : channel.substr(0, dot);
}

template <class Sample>
Imf::Slice plane(Imf::PixelType type, std::vector<Sample>& samples, const Imath::Box2i& window) {
    const std::size_t width = static_cast<std::size_t>(window.max.x - window.min.x) + 1;
    return Imf::Slice::Make(type, samples.data(), window, sizeof(Sample), sizeof(Sample) * width);
}

bool is_flat(const Imf::Header& header) { return !header.hasType() || !Imf::isDeepData(header.type()); }

void check_part(const Imf::Header& header, std::uint64_t file_bytes) {
    const Imath::Box2i window = header.dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1, height = std::int64_t{window.max.y} - window.min.y + 1;
    std::uint64_t pixel = 0;  // bytes
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        pixel += channel.channel().type == Imf::HALF ? 2u : 4u;
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1) {
            throw std::runtime_error(fmt::format("its channel \"{}\" does not hold a value for each pixel", channel.name()));
        }
    }
    if (pixel == 0) {
        throw std::runtime_error("it holds no channels");
    }
    check_size(width, height, pixel * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height), file_bytes);
    if (header.hasTileDescription()) {  // the library takes the memory of whole tiles
        constexpr std::uint64_t largest_tile = 1u << 24;
        const Imf::TileDescription& tiles = header.tileDescription();
        if (std::uint64_t{tiles.xSize} * tiles.ySize > std::max(largest_tile, static_cast<std::uint64_t>(width * height))) {
            throw std::runtime_error(fmt::format("its tiles are {} x {} pixels", tiles.xSize, tiles.ySize));
        }
    }
}

void read_part(Imf::MultiPartInputFile& file, int index, LayeredImage& image) {
    const Imf::Header& header = file.header(index);
    const Imath::Box2i window = header.dataWindow();
    const std::size_t area = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    Imf::FrameBuffer buffer;
    std::vector<Channel> channels;
    std::size_t count = 0;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        ++count;
    }
    channels.reserve(count);
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        const Imf::PixelType type = channel.channel().type;
        Channel& made = channels.emplace_back();
        made.name = channel.name();
        if (find_channel(image, made.name)) {
            made.name = (header.hasName() ? header.name() : std::to_string(index)) + "." + made.name;
        }
        if (type == Imf::UINT) {
            made.stored = Stored::uint32;
            made.numbers.resize(area);
            buffer.insert(channel.name(), plane(Imf::UINT, made.numbers, window));
        } else {
            made.stored = type == Imf::HALF ? Stored::half : Stored::float32;
            made.values.resize(area);
            buffer.insert(channel.name(), plane(Imf::FLOAT, made.values, window));
        }
    }
    Imf::InputPart part(file, index);
    part.setFrameBuffer(buffer);
    part.readPixels(window.min.y, window.max.y);
    for (Channel& channel : channels) {
        if (!find_channel(image, channel.name)) {
            image.channels.push_back(std::move(channel));
        }
    }
}

// OpenEXR puts the path in front, which the caller knows better, and some reasons end in a line break.
std::string plain(std::string message, const std::string& path) {
    if (const std::size_t at = message.find("\"" + path + "\"."); at != std::string::npos) {
        message.erase(0, std::min(message.size(), at + path.size() + 4));
    }
    message = message.substr(0, message.find('\n'));
    return message.empty() ? "its pixels can't be read" : message;
}

}  // namespace

std::string encode_exr_layers(const LayeredImage& image) {
    std::set<std::string> wide_layers;
    for (const Channel& channel : image.channels) {
        if (channel.stored == Stored::half && !fits_half(channel.values)) {
            wide_layers.insert(layer_of(channel.name));
        }
    }
    Imf::Header header = make_header(image.width, image.height, image.metadata);
    const Imath::Box2i window = header.dataWindow();
    Imf::FrameBuffer buffer;
    std::vector<std::vector<half>> halves;
    halves.reserve(image.channels.size());
    for (const Channel& channel : image.channels) {
        // The library reads through pointers to what it could change.
        if (channel.stored == Stored::uint32) {
            header.channels().insert(channel.name, Imf::Channel(Imf::UINT));
            buffer.insert(channel.name, plane(Imf::UINT, const_cast<std::vector<std::uint32_t>&>(channel.numbers), window));
        } else if (channel.stored == Stored::float32 || wide_layers.contains(layer_of(channel.name))) {
            header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
            buffer.insert(channel.name, plane(Imf::FLOAT, const_cast<std::vector<float>&>(channel.values), window));
        } else {
            std::vector<half>& narrow = halves.emplace_back(channel.values.size());
            std::transform(channel.values.begin(), channel.values.end(), narrow.begin(), [](float v) { return half(v); });
            header.channels().insert(channel.name, Imf::Channel(Imf::HALF));
            buffer.insert(channel.name, plane(Imf::HALF, narrow, window));
        }
    }
    MemoryStream stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(buffer);
        file.writePixels(image.height);
    }
    return stream.take();
}

LayeredImage read_exr_layers(const std::string& path, std::uint64_t file_bytes) try {
    if (!exr_attributes_fit(path, file_bytes)) {
        throw std::runtime_error("broken OpenEXR file: its header claims more bytes than the file has");
    }
    Imf::MultiPartInputFile file(path.c_str());
    LayeredImage image;
    Imath::Box2i first;
    for (int i = 0; i < file.parts(); ++i) {
        const Imf::Header& header = file.header(i);
        if (!is_flat(header) || (image.width > 0 && header.dataWindow() != first)) {
            continue;
        }
        check_part(header, file_bytes);
        if (image.width == 0) {
            first = header.dataWindow();
            image.width = first.max.x - first.min.x + 1;
            image.height = first.max.y - first.min.y + 1;
            for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
                const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
                const std::string name = attribute.name();
                if (text && name != "type" && name != "name" && name != "view") {  // these the library itself puts there
                    image.metadata[name] = text->value();
                }
            }
        }
        read_part(file, i, image);
    }
    if (image.width == 0) {
        throw std::runtime_error("it holds no flat picture");
    }
    return image;
} catch (const std::bad_alloc&) {
    throw;
} catch (const std::exception& error) {
    throw std::runtime_error(plain(error.what(), path));
}

}  // namespace lancer
