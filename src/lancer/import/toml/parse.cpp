#include "lancer/import/toml/parse.h"

#include <algorithm>

#include "lancer/import/toml/nesting.h"

namespace lancer::notation {

namespace {

constexpr int most_mistakes = 20;
constexpr std::size_t longest_text_tried_again = 1u << 20;  // bytes

// The parser tells which of its functions failed before it tells what is wrong.
std::string plain(std::string_view description) {
    constexpr std::string_view start = "Error while parsing ";
    if (description.starts_with(start)) {
        const std::size_t colon = description.find(": ");
        if (colon != std::string_view::npos) {
            description.remove_prefix(colon + 2);
        }
    }
    std::string text(description);
    if (text == "could not determine value type") {
        text = "this is no value: expected a number, true, false, a list, or text in quotes";
    } else if (text.starts_with("expected value, saw '#'")) {
        text = "a value is missing here; a color stands in quotes: \"#rrggbb\"";
    }
    return text;
}

// Makes a line with a key and its value blank; positions of all others stay. False when there is no such line: what stands below a header
// would change its meaning without it.
bool blank_key(std::string& text, std::size_t line) {
    std::size_t begin = 0;
    for (std::size_t i = 1; i < line; ++i) {
        begin = text.find('\n', begin);
        if (begin == std::string::npos) {
            return false;
        }
        ++begin;
    }
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::size_t first = text.find_first_not_of(" \r\t", begin);
    if (first >= end || text[first] == '[') {
        return false;
    }
    std::fill(text.begin() + static_cast<std::ptrdiff_t>(begin), text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    return true;
}

}  // namespace

std::optional<toml::table> parse(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
    const Nesting nesting = measure_nesting(text, file, diagnostics);
    if (nesting.too_deep) {
        return std::nullopt;
    }
    std::string rest;  // the text without the lines that were wrong
    for (int mistake = 0; mistake < most_mistakes; ++mistake) {
        try {
            toml::table root = toml::parse(mistake == 0 ? text : std::string_view(rest));
            if (mistake == 0) {
                return root;
            }
            break;
        } catch (const toml::parse_error& error) {
            const std::size_t line = error.source().begin.line;
            diagnostics.error({file, static_cast<int>(line), static_cast<int>(error.source().begin.column)}, plain(error.description()));
            const bool alone = line >= 1 && line <= nesting.stands_alone.size() && nesting.stands_alone[line - 1];
            if (!alone || text.size() > longest_text_tried_again) {
                break;
            }
            if (mistake == 0) {
                rest = text;
            }
            if (!blank_key(rest, line)) {
                break;
            }
        }
    }
    return std::nullopt;
}

}  // namespace lancer::notation
