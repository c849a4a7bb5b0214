// How sure a pixel is: the interval around its luminance that holds the truth with a stated chance.
//
// A pixel's samples are evenly spread points, one long sequence with a random scrambling. They are cut into 16 runs, or up to 31, of the same length, a
// power of two. Each run is evenly spread by itself, and its mean is right on average and of one distribution with the others'. Were the runs
// independent, their spread would tell the error of their mean without bias, and Student's t the interval [L'Ecuyer et al. 2023; Student 1908]. They
// are a little better than that: each fills gaps of the others [Owen 1997], so that the interval is rather too wide than too narrow, and the picture
// loses nothing of its evenness for the sake of the interval.
//
// That is true of samples whose spread shows. Where light is rare and bright (a caustic that one path in a thousand finds) most pixels have not met it
// yet: they are too dark, agree with themselves, and would be sure of it. Their neighbours know better. So no pixel is surer than the pixels around it
// are on average: of the squares of 4 x 4 pixels its own and those around, which some thousand samples make up when the first is decided.
//
// The largest single sample is held against the sum of all squares: where the squares have a finite mean the ratio goes to 0 as samples are added, so a
// pixel where one sample makes half of the sum is one whose spread can't be trusted yet [Embrechts et al. 1997, 6.2.6].
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "lancer/film/film_sums.h"
#include "lancer/film/tiles.h"

namespace lancer {

struct Interval {
    double middle = 0.0;      // luminance, linear
    double half_width = 0.0;  // the truth lies within it of the middle
    double tail = 0.0;        // how far one sample stands out: above 1 it may be that nothing is known of the spread yet

    bool heavy() const { return tail > 1.0; }  // not to be trusted
};

// The side of the squares of pixels that know of each other, and of the blocks of the picture beyond which nobody looks: a block's samples are known
// where it is rendered.
constexpr int interval_cell = 4;
constexpr int interval_block = 32;

// Cells of a block, row by row.
std::size_t cells_across(const Tile& block);
std::size_t cells_in(const Tile& block);
Tile cell_of(const Tile& block, std::size_t cell);
// Squares of errors, of each cell and its up to eight neighbours: the square of the mean of their roots, so that one hard cell, at the edge of something,
// says little of those beside it.
std::vector<double> squares_around(const std::vector<double>& of_cells, std::size_t across);

class IntervalRule {
public:
    // A chance, between 0 and 1. Errors are compared in relation to luminance; what is darker than `floor` (above 0) counts as having that.
    IntervalRule(double confidence, double floor);

    // By the pixel's own samples. The sums have runs. Infinitely wide before there are 16 samples.
    Interval alone(const FilmSums& sums, std::size_t pixel) const;

    // Of all pixels of a block, row by row. Those of the block have as many samples each as their cell's first.
    std::vector<Interval> of(const FilmSums& sums, const Tile& block) const;

    // The half width in relation to the luminance.
    double relative(const Interval& interval) const;

private:
    std::array<double, most_runs - least_runs + 1> quantiles_{};  // of Student's t, for so many runs
    double floor_;
};

}  // namespace lancer
