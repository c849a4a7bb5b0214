// The estimate of the time left, by a clock that the test turns itself.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "lancer/render/time_left.h"

namespace lancer {
namespace {

TEST(TimeLeft, KnowsNothingBeforeTheFirstTile) {
    TimeLeft left({10.0, 10.0});
    EXPECT_EQ(left.share_done(), 0.0);
    EXPECT_EQ(left.seconds(5.0), 0.0);
}

// Tiles that cost 1 to 10 a sample, 64 samples each in rounds, three threads at once: right to the second round's end, and exact from there.
TEST(TimeLeft, IsExactWhereTheNumberOfSamplesIsKnown) {
    constexpr std::size_t tiles = 40;
    const auto cost = [](std::size_t tile) { return 1.0 + static_cast<double>(tile * 7 % 10); };
    TimeLeft left(std::vector<double>(tiles, 1.0));
    double all = 0.0;
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        left.expect(tile, 64.0);
        all += 64.0 * cost(tile);
    }
    double work = 0.0;
    for (int round = 0, samples = 0; samples < 64; ++round) {
        const int more = round == 0 ? 1 : samples;
        for (std::size_t tile = 0; tile < tiles; ++tile) {
            work += more * cost(tile);
            left.add(tile, more * cost(tile), more, 64.0 - samples - more);
            const double true_left = (all - work) / 3.0;
            if (round > 0 || tile + 1 == tiles) {
                EXPECT_NEAR(left.seconds(work / 3.0), true_left, 1e-9 * all) << round << " " << tile;
                EXPECT_NEAR(left.share_done(), work / all, 1e-9);
            } else if (tile >= 9) {
                EXPECT_NEAR(left.seconds(work / 3.0), true_left, 0.1 * true_left) << tile;
            }
        }
        samples += more;
    }
    EXPECT_NEAR(left.share_done(), 1.0, 1e-9);
}

// A goal: some tiles need ten times as many samples as others, and each of these costs three times as much. Whoever counted samples would be off by
// more than half for most of the way.
TEST(TimeLeft, CountsHardTilesForWhatTheyCost) {
    constexpr std::size_t tiles = 20;
    const auto need = [](std::size_t tile) { return tile % 4 == 0 ? 1600 : 160; };
    const auto cost = [](std::size_t tile) { return tile % 4 == 0 ? 3.0 : 1.0; };
    double all = 0.0;
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        all += need(tile) * cost(tile);
    }
    TimeLeft left(std::vector<double>(tiles, 1024.0));
    double work = 0.0;
    for (int samples = 0; samples < 1600; samples += 16) {
        for (std::size_t tile = 0; tile < tiles; ++tile) {
            if (samples < need(tile)) {
                work += 16 * cost(tile);
                left.add(tile, 16 * cost(tile), 16, need(tile) - samples - 16);
            }
            if (work > 0.1 * all) {
                EXPECT_NEAR(left.seconds(0.5 * work), 0.5 * (all - work), 1e-9 * all) << samples << " " << tile;
            }
        }
    }
}

// A goal that turns out harder than it looked: of 1600 samples 700 are expected at first, and more each time.
TEST(TimeLeft, LearnsFromWhatWasExpectedTooLow) {
    constexpr std::size_t tiles = 20;
    constexpr double all = 1600.0;
    TimeLeft left(std::vector<double>(tiles, 1024.0));
    double work = 0.0;
    for (double samples = 0.0; samples < all;) {
        const double more = samples < 64.0 ? 16.0 : std::min(samples / 2.0, all - samples);
        samples += more;
        const double expected = all * std::pow(samples / all, 0.18);
        for (std::size_t tile = 0; tile < tiles; ++tile) {
            work += more;
            left.add(tile, more, more, expected - samples);
        }
        if (samples >= 0.1 * all) {
            EXPECT_NEAR(left.seconds(work), all * tiles - work, 0.01 * all * tiles) << samples;
        }
    }
}

// What a resumed picture finds done takes no time.
TEST(TimeLeft, SkipsWhatIsDone) {
    TimeLeft left({1.0, 1.0, 1.0, 1.0});
    left.add(0, 2.0, 10.0, 20.0);
    EXPECT_NEAR(left.seconds(2.0), 4.0 + 3 * 6.0, 1e-12);
    left.skip(1);
    left.skip(2);
    EXPECT_NEAR(left.seconds(2.0), 4.0 + 6.0, 1e-12);
    left.add(3, 1.0, 10.0, 0.0);
    EXPECT_NEAR(left.seconds(3.0), 4.0, 1e-12);
    left.add(0, 4.0, 20.0, 0.0);
    EXPECT_EQ(left.seconds(7.0), 0.0);
    EXPECT_EQ(left.share_done(), 1.0);
}

}  // namespace
}  // namespace lancer
