#include "lancer/image/exr.h"

#include "lancer/image/exr_layers.h"

namespace lancer {

std::string encode_exr(const Image& image, const Metadata& metadata) {
    LayeredImage layers = split_channels(image);
    for (Channel& channel : layers.channels) {
        channel.stored = Stored::half;
    }
    layers.metadata = metadata;
    return encode_exr_layers(layers);
}

}  // namespace lancer
