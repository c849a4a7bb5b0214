#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "lancer/import/gltf/check.h"

namespace lancer::gltf {

namespace {

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

// As stored, without taking memory: normalized integers are given as integers in "min" and "max".
template <class Stored>
void find_ranges(const Accessor& accessor, std::vector<Range>& ranges, bool& is_finite) {
    const std::size_t columns = accessor.components / accessor.rows;
    const std::size_t column = columns == 1 ? 0 : (accessor.rows * sizeof(Stored) + 3) / 4 * 4;
    std::vector<Stored> low(accessor.components, std::numeric_limits<Stored>::max());
    std::vector<Stored> high(accessor.components, std::numeric_limits<Stored>::lowest());
    for (std::size_t c = 0; c < accessor.components; ++c) {
        const char* bytes = accessor.bytes.data() + c / accessor.rows * column + c % accessor.rows * sizeof(Stored);
        Stored lowest = low[c], highest = high[c];
        for (std::size_t i = 0; i < accessor.count; ++i) {
            Stored value;
            std::memcpy(&value, bytes + i * accessor.stride, sizeof value);
            if constexpr (std::is_floating_point_v<Stored>) {
                is_finite = is_finite && std::isfinite(value);
            }
            lowest = value < lowest ? value : lowest;
            highest = value > highest ? value : highest;
        }
        ranges[c] = {static_cast<double>(lowest), static_cast<double>(highest)};
    }
}

}  // namespace

void check_values(Document& document, const Accessor& accessor) {
    if (accessor.bytes.empty() || accessor.sparse_count > 0) {
        return;
    }
    std::vector<Range> ranges(accessor.components);
    bool is_finite = true;
    switch (accessor.component) {
        case Component::i8:
            find_ranges<std::int8_t>(accessor, ranges, is_finite);
            break;
        case Component::u8:
            find_ranges<std::uint8_t>(accessor, ranges, is_finite);
            break;
        case Component::i16:
            find_ranges<std::int16_t>(accessor, ranges, is_finite);
            break;
        case Component::u16:
            find_ranges<std::uint16_t>(accessor, ranges, is_finite);
            break;
        case Component::u32:
            find_ranges<std::uint32_t>(accessor, ranges, is_finite);
            break;
        case Component::f32:
            find_ranges<float>(accessor, ranges, is_finite);
            break;
    }
    if (!is_finite) {
        document.warning(accessor.json, "some values are not finite");
    }
    const auto compare = [&](std::string_view key, double Range::*side, auto is_outside) {
        const std::vector<double> declared = accessor.json.numbers(key);
        if (declared.empty()) {
            return;
        }
        if (declared.size() != accessor.components) {
            document.warning(accessor.json[key], fmt::format("{} values: expected {}", declared.size(), accessor.components));
            return;
        }
        for (std::size_t c = 0; c < declared.size(); ++c) {
            // Written with fewer digits than a float has, as many exporters do, they may miss by a little.
            const double found = ranges[c].*side;
            const double rounding = accessor.component == Component::f32 ? 1e-5 * std::abs(found) : 0.0;
            const double stated = accessor.component == Component::f32 ? static_cast<double>(static_cast<float>(declared[c])) : declared[c];
            if (std::abs(found - stated) > rounding) {
                document.warning(accessor.json[key], fmt::format("component {} is {}, but the values {} {}", c, declared[c],
                                                                 is_outside(found, stated) ? "reach" : "end at", found));
            }
        }
    };
    compare("min", &Range::low, [](double found, double stated) { return found < stated; });
    compare("max", &Range::high, [](double found, double stated) { return found > stated; });
}

}  // namespace lancer::gltf
