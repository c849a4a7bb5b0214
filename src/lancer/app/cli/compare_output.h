// A comparison of pictures as words, as JSON and as pictures.
#pragma once

#include <string>
#include <vector>

#include "lancer/image/comparison.h"

namespace lancer::app {

// A goal that the caller set: fails when `found` is above `limit`.
struct Limit {
    std::string name;  // "MSE"
    double limit = 0.0;
    double found = 0.0;

    bool fails() const { return !(found <= limit); }
};

struct ComparedFiles {
    std::vector<std::string> pictures, references;
};

void print_comparison(const ComparedFiles& files, const Comparison& comparison, const ComparisonOptions& options,
                      const std::vector<Limit>& limits);
std::string comparison_as_json(const ComparedFiles& files, const Comparison& comparison, const ComparisonOptions& options,
                               const std::vector<Limit>& limits);

// FLIP from black for none to light yellow for 1; in files of linear light the numbers themselves. Throws MachineFailure.
void write_flip_image(const std::string& path, const FlipMap& map, const Metadata& metadata);

// In files of linear light the difference, picture minus reference; in others |difference| / (|reference| + 0.01), the mean of the
// channels, from black for 0 to light yellow for 1. Throws MachineFailure.
void write_error_image(const std::string& path, const Comparison& comparison, const Metadata& metadata);

}  // namespace lancer::app
