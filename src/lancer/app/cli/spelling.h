// The report's own arguments (report 1.2), as it spells them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lancer::app {

// `-help`, `-threads`, `-thread`, `-render-all` and `-version` get their second dash; everything else stays. Without the program's name.
std::vector<std::string> with_two_dashes(std::vector<std::string> words);

// A command line as a shell would read it: words are quoted where they must be.
std::string shell_quoted(const std::vector<std::string>& words);

// The other way round; nothing where a quote is not closed.
std::optional<std::vector<std::string>> shell_words(std::string_view line);

}  // namespace lancer::app
