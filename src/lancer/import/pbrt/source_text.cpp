#include "lancer/import/pbrt/source_text.h"

#include <algorithm>
#include <cstring>

namespace lancer::pbrt {

SourcePosition SourceText::position(std::string_view part) const {
    const std::string_view text = view();
    if (line_begins_.empty()) {
        line_begins_.push_back(0);
        const char* const end = text.data() + text.size();
        for (const char* at = text.data(); at != end;) {
            const auto* feed = static_cast<const char*>(std::memchr(at, '\n', static_cast<std::size_t>(end - at)));
            if (feed == nullptr) {
                break;
            }
            at = feed + 1;
            line_begins_.push_back(static_cast<std::size_t>(at - text.data()));
        }
    }
    const auto offset = static_cast<std::size_t>(part.data() - text.data());
    const auto after = std::upper_bound(line_begins_.begin(), line_begins_.end(), offset);
    const auto line = after - line_begins_.begin();
    return {path_, static_cast<int>(line), static_cast<int>(offset - *(after - 1)) + 1};
}

}  // namespace lancer::pbrt
