// How sure a pixel is: the interval around its luminance that holds the truth with a stated chance.
//
// A pixel's samples are dealt in turn to 16 replicates: sets of evenly spread points, each with its own random scrambling. Within a replicate points
// depend on one another, which is why they do better than chance; the replicates' means are independent and of one distribution, so their
// spread tells the error of their mean without bias, and Student's t with 15 degrees of freedom tells the interval [L'Ecuyer et al. 2023; Student 1908].
// The largest single sample is held against the sum of all squares: where the squares have a finite mean the ratio goes to 0 as samples are added, so a
// pixel where one sample makes a quarter of the sum is one whose spread can't be trusted yet [Embrechts et al. 1997, 6.2.6].
#pragma once

#include <cstddef>

#include "lancer/film/film_sums.h"

namespace lancer {

struct Interval {
    double middle = 0.0;      // luminance, linear
    double half_width = 0.0;  // the truth lies within it of the middle
    bool heavy = false;       // the tail is: not to be trusted
};

class IntervalRule {
public:
    explicit IntervalRule(double confidence);  // a chance, between 0 and 1

    // The sums have replicates. Infinitely wide before each of these has a sample.
    Interval of(const FilmSums& sums, std::size_t pixel) const;

private:
    double quantile_;  // of Student's t
};

}  // namespace lancer
