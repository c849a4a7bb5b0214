// How far a film is: which of its tiles have how many rounds of work behind them, and what these have found.
//
// A tile's pixels depend on nothing but the tile's own samples, taken in their order. So a film may be cut off at any moment, written, read,
// joined with others and gone on with, and holds the same bits in the end (docs/decisions/0006-ranges-of-work.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "lancer/film/bytes.h"
#include "lancer/film/film.h"
#include "lancer/film/film_sums.h"
#include "lancer/film/tiles.h"

namespace lancer {

class FilmState {
public:
    // A film that nothing has been done for. `sums` is null where samples are not summed up (Whitted's integrator). Both must outlive this.
    FilmState(Film& film, FilmSums* sums, int tile_size);

    Film& film() { return film_; }
    const Film& film() const { return film_; }
    FilmSums* sums() { return sums_; }
    const FilmSums* sums() const { return sums_; }
    int tile_size() const { return tile_size_; }
    const std::vector<Tile>& tiles() const { return tiles_; }  // row by row

    // Whoever adds a round to a tile, or reads the tile's pixels meanwhile, holds its lock.
    std::unique_lock<std::mutex> lock(std::size_t tile) const { return std::unique_lock(locks_[tile]); }
    std::uint32_t rounds(std::size_t tile) const { return rounds_[tile]; }
    void add_round(std::size_t tile) { ++rounds_[tile]; }

    // What the tile holds. The caller has its lock.
    void save(std::size_t tile, ByteWriter& bytes) const;
    // The other way round, in place of what there was. False where the bytes are not those of such a tile.
    bool load(std::size_t tile, std::uint32_t rounds, ByteReader& bytes);

private:
    Film& film_;
    FilmSums* sums_;
    int tile_size_;
    std::vector<Tile> tiles_;
    std::vector<std::uint32_t> rounds_;
    std::unique_ptr<std::mutex[]> locks_;
};

}  // namespace lancer
