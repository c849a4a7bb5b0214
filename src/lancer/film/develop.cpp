#include "lancer/film/develop.h"

#include <cassert>

#include "lancer/image/encode.h"

namespace lancer {

void develop_rows(const Film& film, const ViewTransform& view, int first, int end, ByteImage& image) {
    assert(image.width == film.width && image.height == film.height && image.channels == 3);
    std::vector<glm::vec3> row;
    for (int y = first; y < end; ++y) {
        const auto begin = film.radiance.begin() + static_cast<std::ptrdiff_t>(film.index(0, y));
        row.assign(begin, begin + film.width);
        view.apply(row);
        std::uint8_t* byte = image.pixels.data() + 3 * film.index(0, y);
        for (const glm::vec3& color : row) {
            *byte++ = quantise_srgb(color.x);
            *byte++ = quantise_srgb(color.y);
            *byte++ = quantise_srgb(color.z);
        }
    }
}

}  // namespace lancer
