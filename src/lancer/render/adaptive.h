// Adaptive anti-aliasing (report 5.4): samples at the corners of pixels; where the corners of a cell differ too much, the cell is cut in four,
// again and again [Whitted 1980, "Improved illumination model", 4]. A pixel is the mean of its cells, each the mean of its four corners,
// in linear light; they are compared as the eye sees them.
//
// differs: the report compares four neighbouring pixels; here the four are the corners of one, so that they are shared by neighbours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/film/display.h"
#include "lancer/render/sampler.h"

namespace lancer {

struct AdaptiveOptions {
    double threshold = 0.03;  // largest difference of a channel's display values, in [0, 1], that is left uncut
    int depth = 3;            // a pixel's cells are at least 2^-depth pixels wide
};

class AdaptiveSampler : public WholeTileSampler {
public:
    // Large tiles, because corners on the border between two are followed twice; smaller ones when the lattice is very fine.
    static int tile_size(int depth);

    // `device` and `curve` must outlive the sampler.
    AdaptiveSampler(const Device& device, const AdaptiveOptions& options, const DisplayCurve& curve);

    bool render_tile(const Tile& tile, Film& film, RayCounts& counts, const std::atomic<bool>* cancel) override;

private:
    // The lattice: 2^depth + 1 points along a pixel's side, border included. Coordinates count from the tile's upper left corner.
    struct Place {
        int x = 0;
        int y = 0;
    };
    struct Cell {
        Place corner;  // upper left
        int size = 0;  // in lattice steps
    };
    struct Corner {  // a lattice point that was followed
        Place place;
        glm::vec3 display;
    };
    // A new point in the middle of a cell's edge.
    struct Witness {
        Place place;
        Place step;    // from it to one end of the edge
        Place beyond;  // the unit square (its upper left corner) on the other side of the edge
    };

    // Most pixels are never cut: their corners are kept in planes as well, x by x, for the processor's vectors.
    struct Planes {
        std::vector<float> channel[3];
    };

    std::size_t node(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(stride_) + static_cast<std::size_t>(x);
    }
    std::size_t index(int x, int y) const { return index_at_[node(x, y)] - 1; }
    const glm::vec3& display(int x, int y) const { return corners_[index(x, y)].display; }
    bool is_wanted(int x, int y) const { return index_at_[node(x, y)] != 0; }
    bool is_followed(int x, int y) const { return is_wanted(x, y) && index(x, y) < followed_; }
    // Nobody but the cell itself asks for its centre.
    bool is_cut(const Cell& cell) const { return is_wanted(cell.corner.x + cell.size / 2, cell.corner.y + cell.size / 2); }

    void begin_tile(const Tile& tile);
    void follow_pixel_corners(RayCounts& counts);
    void cut_pixels();
    bool want(int x, int y);  // put on the list for the next run; false when it was followed or is on the list
    void want_on_edge(const Place& middle, const Place& step, const Place& beyond);
    void follow_wanted(RayCounts& counts);  // one long run
    bool corners_differ(const Cell& cell) const;
    bool differs_from_ends(const Place& middle, const Place& a, const Place& b) const;
    bool edges_differ(const Cell& cell) const;
    void cut(const Cell& cell);
    Cell leaf_at(const Place& unit) const;
    void hear_witnesses();
    std::size_t pixel_of(int x, int y) const;
    glm::vec3 mean(const Cell& cell) const;
    glm::vec3 mean_of_corners(int pixel_x, int pixel_y) const;
    void put_pixels(Film& film) const;

    const Device& device_;
    const DisplayCurve& curve_;
    float threshold_;
    int depth_;
    int stride_;  // of the lattice

    Tile tile_;
    std::vector<std::uint32_t> index_at_;  // lattice -> place in `corners_` + 1; 0 = neither followed nor wanted
    std::vector<Corner> corners_;          // what was followed or is wanted, in order
    std::vector<glm::vec2> points_;        // of `corners_`, on the film
    std::vector<glm::vec3> radiance_;      // of `corners_`
    std::size_t followed_ = 0;             // how many of `corners_` were followed; the rest is wanted
    std::vector<Cell> cells_;              // to be looked at
    std::vector<Cell> next_;               // to be looked at after these
    std::vector<Witness> witnesses_;
    std::vector<Cell> revealed_;  // cells that witnesses want to be cut
    Planes corner_light_;         // of the corners of pixels, row by row, `tile width + 1` in a row
    Planes corner_display_;
    std::vector<float> contrast_;         // pixel by pixel: how much the corners differ
    std::vector<char> pixel_cut_;         // pixel by pixel
    std::vector<std::uint32_t> samples_;  // pixel by pixel
};

}  // namespace lancer
