#include <gtest/gtest.h>

#include "lancer/base/hash.h"

namespace lancer {
namespace {

// Known answers of MurmurHash3_x64_128 with seed 0.
TEST(Hash, AgreesWithKnownAnswers) {
    EXPECT_EQ(to_hexadecimal(hash_bytes("")), "00000000000000000000000000000000");
    EXPECT_EQ(to_hexadecimal(hash_bytes("hello")), "cbd8a7b341bd9b025b1e906a48ae1d19");
    EXPECT_EQ(to_hexadecimal(hash_bytes("The quick brown fox jumps over the lazy dog")), "e34bbc7bbc071b6c7a433ca9c49a9347");
}

TEST(Hash, EveryByteAndTheLengthCount) {
    const std::string zeros(40, '\0');
    for (std::size_t i = 0; i < zeros.size(); ++i) {
        std::string changed = zeros;
        changed[i] = 1;
        EXPECT_NE(hash_bytes(zeros), hash_bytes(changed)) << i;
        EXPECT_NE(hash_bytes(zeros), hash_bytes(zeros.substr(0, i))) << i;
    }
}

}  // namespace
}  // namespace lancer
