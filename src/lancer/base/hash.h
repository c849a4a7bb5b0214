// A fingerprint of bytes: tells whether two scenes are the same, not whether somebody forged one.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace lancer {

using Hash = std::array<std::uint64_t, 2>;

// MurmurHash3, the 128-bit variant for 64-bit machines [Appleby 2011].
Hash hash_bytes(std::string_view bytes, std::uint32_t seed = 0);

// 32 hexadecimal digits.
std::string to_hexadecimal(const Hash& hash);

}  // namespace lancer
