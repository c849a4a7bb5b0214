// Whether two pictures differ by more than their noise: Welch's test [Welch 1947] of their means, of their blocks and of their pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace lancer {

// A mean that was measured: the variance is that of the mean, and rests on `freedom` degrees; infinitely many when it is known for certain.
struct Measured {
    double mean = 0.0;
    double variance = 0.0;
    double freedom = std::numeric_limits<double>::infinity();
};

struct WelchTest {
    double difference = 0.0;
    double error = 0.0;  // standard error of the difference
    double freedom = std::numeric_limits<double>::infinity();
    double p = 1.0;  // of a difference at least as large if the means were equal

    double t() const;  // infinite when a difference has no error at all
};
WelchTest welch_test(const Measured& a, const Measured& b);

// One channel of a picture whose noise is known, row-major. Either `variances` (of each pixel's mean) belong to a single run, or several runs
// tell the noise themselves; a single run without variances counts as exact.
struct NoisyChannel {
    std::vector<std::span<const float>> runs;  // at least one
    std::span<const float> variances;          // empty, or one for each pixel; for a single run only
    std::span<const float> samples;            // how many each pixel took: the variances rest on one less; empty if unknown
    double rounding = 0x1p-23;  // the step between neighbouring numbers of the file, relative: 2^-23 for floats, 2^-10 for halves

    bool is_exact() const { return runs.size() < 2 && variances.empty(); }
};

// Whether the pixel is finite in all of the runs, and its variance, too.
bool is_finite(const NoisyChannel& channel, std::size_t pixel);

// The mean of the whole picture, or of the rectangle [x0, x1) x [y0, y1) of a picture that is `width` wide. Pixels count as independent; those
// marked in `skip` (empty: none) are left out. `count` receives how many were in. The rounding of
// the file counts as noise, too.
struct Rectangle {
    int x0, y0, x1, y1;
};
Measured measure(const NoisyChannel& channel, int width, const Rectangle& rectangle, const std::vector<bool>& skip, std::uint64_t& count);

// All the cells of a picture: squares of `side` pixels, smaller at the right and lower edge.
struct CellTests {
    int side = 1;
    std::uint64_t tested = 0;
    double share_beyond_95 = 0.0;  // of the cells, those with p < 0.05: about 0.05 when nothing differs
    double chi2 = 0.0;             // sum of squares of all z; its mean is `tested` when nothing differs
    double chi2_p = 1.0;
    double worst_z = 0.0;  // the largest in size, with the sign of the difference; z as a normal variable has it with the same p
    double worst_p = 1.0;  // after Bonferroni: the chance that any of the cells is that far off
    int worst_x = 0;       // its upper left pixel
    int worst_y = 0;
};
CellTests test_cells(const NoisyChannel& a, const NoisyChannel& b, int width, int height, int side);

}  // namespace lancer
