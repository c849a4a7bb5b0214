#include "lancer/import/mesh/mesh_messages.h"

namespace lancer {

void MeshMessages::error(int line, int column, std::string message) {
    ++errors_;
    if (errors_ <= most_) {
        diagnostics_.error({file_, line, column}, std::move(message));
    } else if (errors_ == most_ + 1) {
        diagnostics_.error({file_, 0, 0}, "too many errors; the rest is not listed");
    }
}

void MeshMessages::warning(int line, int column, std::string message) {
    ++warnings_;
    if (warnings_ <= most_) {
        diagnostics_.warning({file_, line, column}, std::move(message));
    } else if (warnings_ == most_ + 1) {
        diagnostics_.warning({file_, 0, 0}, "too many warnings; the rest is not listed");
    }
}

std::string quoted(std::string_view word) {
    constexpr std::size_t longest = 24;
    std::string text = "\"";
    for (char c : word.substr(0, longest)) {
        text += c >= ' ' && c <= '~' ? c : '?';
    }
    return text + (word.size() > longest ? "...\"" : "\"");
}

}  // namespace lancer
