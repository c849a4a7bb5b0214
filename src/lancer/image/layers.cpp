#include "lancer/image/layers.h"

#include <fmt/format.h>

#include <cassert>
#include <new>
#include <stdexcept>

#include "lancer/base/failure.h"
#include "lancer/base/file.h"
#include "lancer/image/exr_layers.h"
#include "lancer/image/replace_file.h"
#include "lancer/image/stored.h"

namespace lancer {
namespace {

[[maybe_unused]] bool is_whole(const LayeredImage& image) {
    const std::size_t area = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    for (const Channel& channel : image.channels) {
        const bool filled = channel.stored == Stored::uint32 ? channel.numbers.size() == area : channel.values.size() == area;
        if (!filled || channel.name.empty() || find_channel(image, channel.name) != &channel) {
            return false;
        }
    }
    return image.width > 0 && image.height > 0 && !image.channels.empty();
}

}  // namespace

const Channel* find_channel(const LayeredImage& image, std::string_view name) {
    for (const Channel& channel : image.channels) {
        if (channel.name == name) {
            return &channel;
        }
    }
    return nullptr;
}

std::string spectral_channel(int bin, int count) {
    std::string middle = fmt::format("{:.6f}", 360.0 + (bin + 0.5) * (830.0 - 360.0) / count);
    middle[middle.find('.')] = ',';
    return "S0." + middle + "nm";
}

Image picture_of(const LayeredImage& image, const std::vector<std::string>& names) {
    assert(!names.empty() && names.size() <= 4);
    const std::size_t count = names.size();
    Image result{image.width, image.height, static_cast<int>(count), {}};
    result.pixels.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * count);
    for (std::size_t c = 0; c < count; ++c) {
        if (const Channel* channel = find_channel(image, names[c])) {
            for (std::size_t i = 0; i < channel->values.size(); ++i) {
                result.pixels[i * count + c] = channel->values[i];
            }
        }
    }
    return result;
}

LayeredImage split_channels(const Image& image) {
    static const std::vector<std::string> names[] = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    LayeredImage result{image.width, image.height, {}, {}};
    const std::size_t count = static_cast<std::size_t>(image.channels), area = image.pixels.size() / count;
    for (std::size_t c = 0; c < count; ++c) {
        Channel channel{names[count - 1][c], Stored::float32, std::vector<float>(area), {}};
        for (std::size_t i = 0; i < area; ++i) {
            channel.values[i] = image.pixels[i * count + c];
        }
        result.channels.push_back(std::move(channel));
    }
    return result;
}

void write_layers(const std::string& path, const LayeredImage& image) {
    assert(is_whole(image));
    std::string bytes;
    try {
        if (file_ending(path) != ".exr") {
            throw std::runtime_error("layers can be written as .exr only");
        }
        bytes = encode_exr_layers(image);
    } catch (const std::exception& error) {
        throw MachineFailure(fmt::format("cannot write {}: {}", path, error.what()));
    }
    replace_file(path, bytes);
}

LayeredImage read_layers(const std::string& path) {
    const FoundImage found = find_image(path);
    if (found.format != "openexr") {
        bool encoded = false;
        const Image image = read_image(path, Encoding::automatic, encoded);
        LayeredImage layers = split_channels(image);
        layers.display = encoded;
        return layers;
    }
    try {
        return read_exr_layers(path, found.bytes);
    } catch (const std::bad_alloc&) {
        fail_to_read(path, "there is not enough memory for it");
    } catch (const std::exception& error) {
        fail_to_read(path, error.what());
    }
}

}  // namespace lancer
