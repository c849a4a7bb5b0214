#include "lancer/import/report.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace lancer {

void ImportReport::honoured(std::string feature, const SourcePosition& position) {
    add({Treatment::honoured, std::move(feature), {}, position, 1, false});
}

void ImportReport::approximated(std::string feature, std::string how, const SourcePosition& position) {
    add({Treatment::approximated, std::move(feature), std::move(how), position, 1, true});
}

void ImportReport::dropped(std::string feature, std::string why, const SourcePosition& position, bool changes_picture) {
    add({Treatment::dropped, std::move(feature), std::move(why), position, 1, changes_picture});
}

std::uint64_t ImportReport::count(Treatment treatment) const {
    return static_cast<std::uint64_t>(
        std::count_if(entries_.begin(), entries_.end(), [&](const ImportEntry& entry) { return entry.treatment == treatment; }));
}

// A format has some hundred features at most: a search through all of them is short.
void ImportReport::add(ImportEntry entry) {
    const auto same = std::find_if(entries_.begin(), entries_.end(), [&](const ImportEntry& other) {
        return other.treatment == entry.treatment && other.feature == entry.feature && other.how == entry.how;
    });
    if (same == entries_.end()) {
        entries_.push_back(std::move(entry));
    } else {
        ++same->count;
        same->changes_picture = same->changes_picture || entry.changes_picture;
    }
}

std::string summary(const ImportReport& report) {
    if (report.entries().empty()) {
        return {};
    }
    const std::uint64_t honoured = report.count(Treatment::honoured);
    return fmt::format("{} feature{} honoured, {} approximated, {} dropped", honoured, honoured == 1 ? "" : "s",
                       report.count(Treatment::approximated), report.count(Treatment::dropped));
}

}  // namespace lancer
