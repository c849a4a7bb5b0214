#include "lancer/base/hash.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>

static_assert(std::endian::native == std::endian::little, "the blocks are read as little-endian words");

namespace lancer {

namespace {

constexpr std::uint64_t c1 = 0x87c37b91114253d5u;
constexpr std::uint64_t c2 = 0x4cf5ad432745937fu;

std::uint64_t scramble_first(std::uint64_t k) { return std::rotl(k * c1, 31) * c2; }
std::uint64_t scramble_second(std::uint64_t k) { return std::rotl(k * c2, 33) * c1; }

std::uint64_t finish(std::uint64_t k) {
    k = (k ^ (k >> 33)) * 0xff51afd7ed558ccdu;
    k = (k ^ (k >> 33)) * 0xc4ceb9fe1a85ec53u;
    return k ^ (k >> 33);
}

}  // namespace

Hash hash_bytes(std::string_view bytes, std::uint32_t seed) {
    std::uint64_t h1 = seed;
    std::uint64_t h2 = seed;
    const std::size_t blocks = bytes.size() / 16;
    for (std::size_t i = 0; i < blocks; ++i) {
        std::uint64_t k[2];
        std::memcpy(k, bytes.data() + 16 * i, 16);
        h1 ^= scramble_first(k[0]);
        h1 = (std::rotl(h1, 27) + h2) * 5 + 0x52dce729u;
        h2 ^= scramble_second(k[1]);
        h2 = (std::rotl(h2, 31) + h1) * 5 + 0x38495ab5u;
    }

    // The last block, filled up with zeros; a word of zeros scrambles to zero, so it may always be mixed in.
    std::uint64_t rest[2] = {0, 0};
    if (const std::size_t left = bytes.size() - 16 * blocks; left > 0) {
        std::memcpy(rest, bytes.data() + 16 * blocks, left);
    }
    h1 ^= scramble_first(rest[0]);
    h2 ^= scramble_second(rest[1]);

    h1 ^= bytes.size();
    h2 ^= bytes.size();
    h1 += h2;
    h2 += h1;
    h1 = finish(h1);
    h2 = finish(h2);
    h1 += h2;
    h2 += h1;
    return {h1, h2};
}

std::string to_hexadecimal(const Hash& hash) { return fmt::format("{:016x}{:016x}", hash[0], hash[1]); }

}  // namespace lancer
