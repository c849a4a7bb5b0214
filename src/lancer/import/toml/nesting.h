// A look at the text before the parser sees it. The parser and the tree that it makes use recursion: what is nested too deep must be refused
// first.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lancer/base/diagnostic.h"

namespace lancer::notation {

struct Nesting {
    // For each line, from the first: it begins and ends outside of lists, tables in braces and strings of several lines, so that the other
    // lines make the same sense without it.
    std::vector<bool> stands_alone;
    bool too_deep = false;  // said in the diagnostics
};

// Values at most 32 deep, names of at most 32 parts.
Nesting measure_nesting(std::string_view text, const std::string& file, Diagnostics& diagnostics);

}  // namespace lancer::notation
