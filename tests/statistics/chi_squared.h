// Pearson's test that a sampler draws with the density that it states [Pearson 1900].
//
// The false alarms: all chi-squared tests of this program together raise one with a chance of at most `overall_false_alarms`, shared out evenly
// over `most_tests` (Bonferroni). Seeds are fixed, so a test that has passed passes again.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace lancer::statistics {

constexpr double overall_false_alarms = 1e-4;
constexpr int most_tests = 2000;
constexpr double false_alarms = overall_false_alarms / most_tests;

struct Verdict {
    double chi2 = 0.0;
    int freedom = 0;
    double chance = 1.0;  // of a chi2 at least as large, were the sampler right
    std::string trouble;  // samples where none may be; empty: none
    bool right() const { return trouble.empty() && chance >= false_alarms; }
    std::string words() const;
};

// Counts against expectations. Cells that expect fewer than 8 are pooled; where none is expected none may be counted. Asserts that no more than
// most_tests are made.
Verdict compare_counts(const std::vector<double>& counts, const std::vector<double>& expected);

// The integral over a rectangle of two functions at once, by Gauss-Legendre rules that are halved until they agree: to about `tolerance`.
struct Pair {
    double density = 0.0;
    double value = 0.0;
};
Pair integrate(const std::function<Pair(double, double)>& function, double x0, double x1, double y0, double y1, double tolerance,
               int least_depth, int most_depth);

// Cells of equal size over the unit square; points are given as (x, y) in [0, 1).
class Cells {
public:
    Cells(int columns, int rows) : columns_(columns), rows_(rows), counts_(std::size_t(columns) * std::size_t(rows) + 1) {}
    void count(double x, double y);
    void count_elsewhere() { counts_.back() += 1.0; }  // draws that led nowhere, or to a direction that has no density
    double total() const;

    // `least_depth`: how often each cell is cut in four at least; more for densities with jumps.
    // The integral of the density over each cell times the number of draws; what is missing to 1 is expected elsewhere. `sum`: both integrals.
    std::vector<double> expect(const std::function<Pair(double, double)>& density, double tolerance, Pair& sum, int least_depth = 0) const;
    const std::vector<double>& counts() const { return counts_; }

private:
    int columns_;
    int rows_;
    std::vector<double> counts_;
};

}  // namespace lancer::statistics
