#include "lancer/app/cli/spelling.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace lancer::app {

std::vector<std::string> with_two_dashes(std::vector<std::string> words) {
    constexpr std::array<std::string_view, 5> long_words = {"-help", "-threads", "-thread", "-render-all", "-version"};
    for (std::string& word : words) {
        if (word == "--") {
            break;
        }
        const std::string_view name = std::string_view(word).substr(0, word.find('='));
        if (std::find(long_words.begin(), long_words.end(), name) != long_words.end()) {
            word = "-" + word;
        }
    }
    return words;
}

std::string shell_quoted(const std::vector<std::string>& words) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+%@";
    std::string line;
    for (const std::string& word : words) {
        if (!line.empty()) {
            line += ' ';
        }
        if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
            line += word;
            continue;
        }
        line += '\'';
        for (const char c : word) {
            if (c == '\'') {
                line += "'\\''";
            } else {
                line += c;
            }
        }
        line += '\'';
    }
    return line;
}

std::optional<std::vector<std::string>> shell_words(std::string_view line) {
    std::vector<std::string> words;
    std::string word;
    bool inside = false, quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted) {
            quoted = c != '\'';
            word += quoted ? std::string(1, c) : "";
        } else if (c == ' ') {
            if (inside) {
                words.push_back(std::exchange(word, {}));
            }
            inside = false;
            continue;
        } else if (c == '\'') {
            quoted = true;
        } else if (c == '\\' && i + 1 < line.size()) {
            word += line[++i];
        } else {
            word += c;
        }
        inside = true;
    }
    if (quoted) {
        return std::nullopt;
    }
    if (inside) {
        words.push_back(word);
    }
    return words;
}

}  // namespace lancer::app
