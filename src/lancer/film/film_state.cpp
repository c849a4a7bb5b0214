#include "lancer/film/film_state.h"

#include <algorithm>
#include <utility>

namespace lancer {

FilmState::FilmState(Film& film, FilmSums* sums, int tile_size)
    : film_(film), sums_(sums), tile_size_(tile_size), tiles_(cut_tiles(film.width, film.height, tile_size)), rounds_(tiles_.size(), 0),
      locks_(std::make_unique<std::mutex[]>(tiles_.size())) {}

FilmState::TileLock FilmState::lock(std::size_t tile) const {
    std::unique_lock gate(gate_);
    TileLock lock{std::shared_lock(whole_), {}};
    gate.unlock();
    lock.tile = std::unique_lock(locks_[tile]);
    return lock;
}

std::unique_lock<std::shared_mutex> FilmState::lock_all() const {
    const std::scoped_lock gate(gate_);
    return std::unique_lock(whole_);
}

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

FilmState::SplatsTaken FilmState::take_splats(std::span<const SplatSums::Fixed> words, std::uint64_t paths,
                                              std::vector<std::uint32_t> rounds) {
    const auto has_all_of = [](const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
        return std::equal(a.begin(), a.end(), b.begin(), [](std::uint32_t x, std::uint32_t y) { return x >= y; });
    };
    const auto overlap = [&](const SplatPart& part) {
        return !std::equal(part.rounds.begin(), part.rounds.end(), rounds.begin(),
                           [](std::uint32_t x, std::uint32_t y) { return x == 0 || y == 0; });
    };
    bool mixed = false;
    for (const SplatPart& part : parts_) {
        if (has_all_of(part.rounds, rounds)) {
            return SplatsTaken::known;
        }
        mixed = mixed || (overlap(part) && !has_all_of(rounds, part.rounds));
    }
    if (mixed) {
        return SplatsTaken::mixed;
    }
    SplatSums& all = *sums_->splats();
    for (const SplatPart& part : parts_) {
        if (overlap(part)) {
            all.take_away(*part.sums);
        }
    }
    std::erase_if(parts_, overlap);
    SplatPart own{std::make_unique<SplatSums>(all.width(), all.height()), std::move(rounds)};
    own.sums->set(words, paths);
    all.add(*own.sums);
    parts_.push_back(std::move(own));
    return SplatsTaken::added;
}

void FilmState::show_splats() {
    if (sums_ != nullptr && sums_->splats() != nullptr) {
        for (std::size_t i = 0; i < film_.radiance.size(); ++i) {
            film_.radiance[i] = sums_->mean(i);
        }
    }
}

}  // namespace lancer
