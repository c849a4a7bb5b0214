// Which known word a misspelt one was probably meant to be.
#include <algorithm>
#include <numeric>
#include <vector>

#include "lancer/base/diagnostic.h"

namespace lancer {

namespace {

constexpr std::size_t longest_word = 64;  // nobody misspells more than that, and the cost is quadratic
constexpr std::size_t most_candidates = 2000;

std::string lower_case(const std::string& text) {
    std::string result = text;
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') {
            c = static_cast<char>(c - 'A' + 'a');
        }
    }
    return result;
}

// How many letters must be inserted, removed, replaced or swapped with their neighbour [Damerau 1964], each letter touched once.
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
        before.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

}  // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
    if (word.empty() || word.size() > longest_word) {
        return {};
    }
    const std::string wanted = lower_case(word);
    const std::string* nearest = nullptr;
    std::size_t smallest = std::max<std::size_t>(1, word.size() / 3) + 1;  // a third of the letters may be wrong
    for (std::size_t i = 0; i < candidates.size() && i < most_candidates; ++i) {
        const std::string& candidate = candidates[i];
        if (candidate.size() > longest_word) {
            continue;
        }
        const std::size_t distance = edit_distance(wanted, lower_case(candidate));
        if (distance < smallest && distance < candidate.size()) {
            smallest = distance;
            nearest = &candidate;
        }
    }
    return nearest ? " did you mean \"" + *nearest + "\"?" : std::string{};
}

}  // namespace lancer
