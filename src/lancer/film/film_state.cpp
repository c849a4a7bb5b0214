#include "lancer/film/film_state.h"

namespace lancer {

FilmState::FilmState(Film& film, FilmSums* sums, int tile_size)
    : film_(film), sums_(sums), tile_size_(tile_size), tiles_(cut_tiles(film.width, film.height, tile_size)), rounds_(tiles_.size(), 0),
      locks_(std::make_unique<std::mutex[]>(tiles_.size())) {}

void FilmState::save(std::size_t tile, ByteWriter& bytes) const {
    const Tile& place = tiles_[tile];
    const std::size_t width = static_cast<std::size_t>(place.width());
    for (int y = place.y0; y < place.y1; ++y) {
        const std::size_t first = film_.index(place.x0, y);
        bytes.put_all<std::uint32_t>(std::span(film_.samples).subspan(first, width));
        if (sums_ != nullptr) {
            sums_->save(first, width, bytes);
        } else {
            bytes.put_all<glm::vec3>(std::span(film_.radiance).subspan(first, width));
        }
    }
}

bool FilmState::load(std::size_t tile, std::uint32_t rounds, ByteReader& bytes) {
    const Tile& place = tiles_[tile];
    const std::size_t width = static_cast<std::size_t>(place.width());
    for (int y = place.y0; y < place.y1; ++y) {
        const std::size_t first = film_.index(place.x0, y);
        bytes.get_all<std::uint32_t>(std::span(film_.samples).subspan(first, width));
        if (sums_ == nullptr) {
            bytes.get_all<glm::vec3>(std::span(film_.radiance).subspan(first, width));
            continue;
        }
        sums_->load(first, width, bytes);
        for (std::size_t i = first; i < first + width; ++i) {
            film_.radiance[i] = sums_->mean(i);
        }
    }
    rounds_[tile] = rounds;
    return bytes.good() && bytes.left() == 0;
}

}  // namespace lancer
