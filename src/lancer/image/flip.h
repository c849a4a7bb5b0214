// FLIP: the difference that a person sees when two pictures are shown in turn at the same place [Andersson et al. 2020], and its form for
// pictures of any brightness [Andersson et al. 2021]. 0 is the same, 1 as different as colours of a display can be.
#pragma once

#include <vector>

#include "lancer/image/image.h"

namespace lancer {

// A display 0.7 m wide with 3840 pixels, seen from 0.7 m: 67.02 pixels for each degree.
extern const double flip_pixels_per_degree;

struct FlipMap {
    int width = 0;
    int height = 0;
    std::vector<float> values;  // 0 to 1, row-major, top row first

    double mean() const;
};

// Exposures in stops, evenly from the first, which makes the brightest pixel 85 % of what the display can show, to the last, which does so for
// the median pixel. Where half of the picture is black the median is that of the rest.
struct FlipExposures {
    double first = 0.0;
    double last = 0.0;
    int count = 2;

    double at(int i) const;
};
FlipExposures flip_exposures(const Image& reference);

// Both take two pictures of the same size with three channels of linear light, sRGB's primaries; what is negative or no number counts as
// black. For displays: what is above 1 counts as 1.
FlipMap flip_for_displays(const Image& image, const Image& reference, double pixels_per_degree = flip_pixels_per_degree);

// For light of any brightness: the largest of the differences at all exposures, tone-mapped by the ACES curve [Narkowicz 2016].
FlipMap flip_for_light(const Image& image, const Image& reference, const FlipExposures& exposures,
                       double pixels_per_degree = flip_pixels_per_degree);

}  // namespace lancer
