// How far a film is: which of its tiles have how many rounds of work behind them, and what these have found.
//
// A tile's pixels depend on nothing but the tile's own samples, taken in their order. So a film may be cut off at any moment, written, read,
// joined with others and gone on with, and holds the same bits in the end (docs/decisions/0006-ranges-of-work.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <shared_mutex>
#include <span>
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
    struct TileLock {
        std::shared_lock<std::shared_mutex> film;
        std::unique_lock<std::mutex> tile;
    };
    TileLock lock(std::size_t tile) const;
    // Nobody holds a tile's lock meanwhile. For films with splats: those of a tile's rounds lie anywhere.
    std::unique_lock<std::shared_mutex> lock_all() const;
    std::uint32_t rounds(std::size_t tile) const { return rounds_[tile]; }
    void add_round(std::size_t tile) { ++rounds_[tile]; }

    // What the tile holds. The caller has its lock.
    void save(std::size_t tile, ByteWriter& bytes) const;
    // The other way round, in place of what there was. False where the bytes are not those of such a tile.
    bool load(std::size_t tile, std::uint32_t rounds, ByteReader& bytes);

    // Splats of another film, which has so many rounds behind each of its tiles. They can't be told apart by tiles, so they are taken in whole: with
    // them, those of films that have no more than that one of any tile which both have are given up. `known`: what there is has all of it already.
    // `mixed`: each has more of some tile than the other has, and nothing was done.
    enum class SplatsTaken { added, known, mixed };
    SplatsTaken take_splats(std::span<const SplatSums::Fixed> words, std::uint64_t paths, std::vector<std::uint32_t> rounds);
    // Makes the picture anew where splats were added to pixels that others have finished.
    void show_splats();

private:
    // What was read from one film.
    struct SplatPart {
        std::unique_ptr<SplatSums> sums;
        std::vector<std::uint32_t> rounds;  // of each tile
    };

    Film& film_;
    FilmSums* sums_;
    int tile_size_;
    std::vector<Tile> tiles_;
    std::vector<std::uint32_t> rounds_;
    std::unique_ptr<std::mutex[]> locks_;
    mutable std::mutex gate_;  // who waits for the whole film lets nobody pass by
    mutable std::shared_mutex whole_;
    std::vector<SplatPart> parts_;
};

}  // namespace lancer
