#include "lancer/image/exact.h"

#include <fmt/format.h>

#include <cstring>
#include <stdexcept>

namespace lancer {

void check_same_size(const LayeredImage& a, const std::string& name_a, const LayeredImage& b, const std::string& name_b) {
    if (a.width != b.width || a.height != b.height) {
        throw std::runtime_error(fmt::format("only pictures of the same size can be compared: {} has {} x {} pixels, {} has {} x {}",
                                             name_a, a.width, a.height, name_b, b.width, b.height));
    }
}

std::string exact_difference(const LayeredImage& a, const std::string& name_a, const LayeredImage& b, const std::string& name_b) {
    check_same_size(a, name_a, b, name_b);
    const auto missing = [](const LayeredImage& in, const LayeredImage& from) {
        for (const Channel& channel : in.channels) {
            if (!find_channel(from, channel.name)) {
                return channel.name;
            }
        }
        return std::string();
    };
    if (const std::string name = missing(a, b); !name.empty()) {
        return fmt::format("{} has a channel {}, {} has none", name_a, name, name_b);
    }
    if (const std::string name = missing(b, a); !name.empty()) {
        return fmt::format("{} has a channel {}, {} has none", name_b, name, name_a);
    }
    constexpr const char* stored[] = {"half", "float", "uint"};
    std::uint64_t differing = 0;
    std::string first;
    std::vector<bool> seen(static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height));
    for (const Channel& channel : a.channels) {
        const Channel& other = *find_channel(b, channel.name);
        if (channel.stored != other.stored) {
            return fmt::format("channel {} is stored as {} in {}, as {} in {}", channel.name, stored[static_cast<int>(channel.stored)],
                               name_a, stored[static_cast<int>(other.stored)], name_b);
        }
        const bool numbers = channel.stored == Stored::uint32;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const bool same = numbers ? channel.numbers[i] == other.numbers[i] : std::memcmp(&channel.values[i], &other.values[i], 4) == 0;
            if (same) {
                continue;
            }
            if (first.empty()) {
                const std::size_t width = static_cast<std::size_t>(a.width);
                const auto value = [&](const Channel& of) {
                    return numbers ? fmt::format("{}", of.numbers[i]) : fmt::format("{}", of.values[i]);
                };
                first = fmt::format("channel {} at {},{}: {} in {}, {} in {}", channel.name, i % width, i / width, value(channel), name_a,
                                    value(other), name_b);
            }
            differing += seen[i] ? 0u : 1u;
            seen[i] = true;
        }
    }
    return differing == 0 ? "" : fmt::format("{} of {} pixels differ; the first is {}", differing, seen.size(), first);
}

}  // namespace lancer
