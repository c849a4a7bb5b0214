#include "lancer/film/develop.h"

#include <cassert>
#include <cmath>

#include "lancer/image/encode.h"

namespace lancer {

void develop_rows(const Film& film, double exposure, int first, int end, ByteImage& image) {
    assert(image.width == film.width && image.height == film.height && image.channels == 3);
    const float scale = static_cast<float>(std::exp2(exposure));
    for (std::size_t i = film.index(0, first); i < film.index(0, end); ++i) {
        const glm::vec3 color = film.radiance[i] * scale;
        image.pixels[3 * i] = quantise_srgb(color.x);
        image.pixels[3 * i + 1] = quantise_srgb(color.y);
        image.pixels[3 * i + 2] = quantise_srgb(color.z);
    }
}

}  // namespace lancer
