#include "lancer/image/cryptomatte.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>
#include <map>

namespace lancer {
namespace {

constexpr std::uint32_t c1 = 0xcc9e2d51u;
constexpr std::uint32_t c2 = 0x1b873593u;

std::uint32_t scramble(std::uint32_t k) { return std::rotl(k * c1, 15) * c2; }

// The inside of a JSON string.
std::string json_escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            result.append(1, '\\').append(1, c);
        } else if (static_cast<unsigned char>(c) < 0x20) {
            result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            result += c;
        }
    }
    return result;
}

}  // namespace

std::uint32_t murmur3_32(std::string_view bytes, std::uint32_t seed) {
    std::uint32_t h = seed;
    const std::size_t blocks = bytes.size() / 4;
    for (std::size_t i = 0; i < blocks; ++i) {
        std::uint32_t k = 0;
        std::memcpy(&k, bytes.data() + 4 * i, 4);
        h = std::rotl(h ^ scramble(k), 13) * 5 + 0xe6546b64u;
    }
    if (const std::size_t left = bytes.size() - 4 * blocks; left > 0) {
        std::uint32_t rest = 0;
        std::memcpy(&rest, bytes.data() + 4 * blocks, left);
        h ^= scramble(rest);
    }
    h ^= static_cast<std::uint32_t>(bytes.size());
    h = (h ^ (h >> 16)) * 0x85ebca6bu;
    h = (h ^ (h >> 13)) * 0xc2b2ae35u;
    return h ^ (h >> 16);
}

std::uint32_t cryptomatte_bits(std::string_view name) {
    const std::uint32_t hash = murmur3_32(name);
    const std::uint32_t exponent = hash >> 23 & 255;
    return exponent == 0 || exponent == 255 ? hash ^ (1u << 23) : hash;
}

float cryptomatte_id(std::string_view name) { return std::bit_cast<float>(cryptomatte_bits(name)); }

Metadata cryptomatte_metadata(const std::string& layer, const std::vector<std::string>& names) {
    std::map<std::string, std::string> ids;
    for (const std::string& name : names) {
        ids[name] = fmt::format("{:08x}", cryptomatte_bits(name));
    }
    std::string manifest = "{";
    for (const auto& [name, id] : ids) {
        manifest += fmt::format("{}\"{}\":\"{}\"", manifest.size() > 1 ? "," : "", json_escaped(name), id);
    }
    manifest += "}";
    const std::string key = fmt::format("cryptomatte/{:.7}/", fmt::format("{:08x}", cryptomatte_bits(layer)));
    return {
        {key + "name", layer}, {key + "hash", "MurmurHash3_32"}, {key + "conversion", "uint32_to_float32"}, {key + "manifest", manifest}};
}

std::vector<Channel> cryptomatte_channels(const std::string& layer, int levels, const std::vector<Coverage>& pixels) {
    assert(levels >= 2 && levels % 2 == 0);
    std::vector<Channel> channels;
    for (int level = 0; level < levels; ++level) {
        for (const char part : level % 2 == 0 ? std::string("RG") : std::string("BA")) {
            channels.push_back({fmt::format("{}{:02}.{}", layer, level / 2, part), Stored::float32, std::vector<float>(pixels.size()), {}});
        }
    }
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        Coverage sorted = pixels[i];
        std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
            return a.second != b.second ? a.second > b.second
                                        : std::bit_cast<std::uint32_t>(a.first) < std::bit_cast<std::uint32_t>(b.first);
        });
        const std::size_t kept = std::min(sorted.size(), static_cast<std::size_t>(levels));
        for (std::size_t k = 0; k < kept; ++k) {
            channels[2 * k].values[i] = sorted[k].first;
            channels[2 * k + 1].values[i] = sorted[k].second;
        }
    }
    return channels;
}

}  // namespace lancer
