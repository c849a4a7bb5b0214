// What a reader made of each thing that a file asks for: the answer to "is this my scene?".
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lancer/base/diagnostic.h"

namespace lancer {

enum class Treatment { honoured, approximated, dropped };

struct ImportEntry {
    Treatment treatment = Treatment::honoured;
    std::string feature;  // in the words of the format: "KHR_materials_sheen", "Shape \"curve\""
    std::string how;      // what stands for it, or why it was dropped; empty for what is honoured
    SourcePosition first;
    std::uint64_t count = 1;
    bool changes_picture = false;  // a picture rendered from this differs from what the author meant
};

// Something that moves, of which a scene holds one moment.
struct AnimationFacts {
    std::string name;
    double seconds = 0.0;  // when it ends
    std::size_t channels = 0;
};

// In the order in which they were met; the same feature treated in the same way is one entry with a count.
class ImportReport {
public:
    void honoured(std::string feature, const SourcePosition& position);
    void approximated(std::string feature, std::string how, const SourcePosition& position);
    // `changes_picture` is false for what nobody would see, such as an author's name or a physics engine's hints.
    void dropped(std::string feature, std::string why, const SourcePosition& position, bool changes_picture = true);

    void animation(AnimationFacts facts) { animations_.push_back(std::move(facts)); }

    const std::vector<ImportEntry>& entries() const { return entries_; }
    const std::vector<AnimationFacts>& animations() const { return animations_; }
    std::uint64_t count(Treatment treatment) const;  // entries, not uses

private:
    void add(ImportEntry entry);

    std::vector<ImportEntry> entries_;
    std::vector<AnimationFacts> animations_;
};

// "12 features honoured, 1 approximated, 2 dropped"; empty for an empty report.
std::string summary(const ImportReport& report);

}  // namespace lancer
