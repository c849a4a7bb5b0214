#include "lancer/import/pbrt/words.h"

namespace lancer::pbrt {

std::string unescaped(std::string_view word) {
    const std::string_view text = without_quotes(word);
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        constexpr std::string_view letters = "\"\\'ntrbf";
        constexpr std::string_view meanings = "\"\\'\n\t\r\b\f";
        const std::size_t which = text[i] == '\\' && i + 1 < text.size() ? letters.find(text[i + 1]) : std::string_view::npos;
        if (which == std::string_view::npos) {
            result += text[i];
        } else {
            result += meanings[which];
            ++i;
        }
    }
    return result;
}

}  // namespace lancer::pbrt
