// Stated errors are true: on a made-up picture whose truth is known, where samples of each pixel follow a distribution of its own.
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "lancer/render/goal_plan.h"

namespace lancer {
namespace {

// A number in [0, 1) that depends on everything [Steele et al. 2014: SplitMix64's output function].
double chance(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

constexpr int side = 64;
constexpr double floor_of_test = 0.05;

// Grey samples that depend on pixel and number alone.
class MadeUpDevice : public Device {
public:
    int lanes() const override { return 8; }
    std::string description() const override { return "made up"; }
    void follow(std::span<const glm::vec2>, std::span<glm::vec3>, RayCounts&) const override {}
    void trace_paths(const PathRange& range, const PathSamples& samples, RayCounts& counts) const override {
        std::size_t next = 0;
        for (int y = range.y0; y < range.y1; ++y) {
            for (int x = range.x0; x < range.x1; ++x) {
                for (int i = range.first_sample; i < range.first_sample + range.sample_count; ++i) {
                    samples.radiance[next++] = glm::vec3(static_cast<float>(light(x, y, i)));
                }
            }
        }
        counts.camera += range.paths();
    }

protected:
    virtual double light(int x, int y, int number) const = 0;
    static double chance_of(std::uint64_t seed, int x, int y, int number) {
        return chance(seed << 48 | static_cast<std::uint64_t>(y * side + x) << 32 | static_cast<std::uint64_t>(number));
    }
};

// Left to right: no noise, even noise, rare bright samples, and a tail without a variance. Brighter from top to bottom.
class NoisyDevice : public MadeUpDevice {
public:
    explicit NoisyDevice(std::uint64_t seed) : seed_(seed) {}

    static double truth(int y) { return 0.5 + y; }
    static int band(int x) { return x * 4 / side; }

private:
    double light(int x, int y, int number) const override { return truth(y) * relative(x, chance_of(seed_, x, y, number)); }
    static double relative(int x, double u) {
        switch (band(x)) {
            case 0:
                return 1.0;
            case 1:
                return 2.0 * u;
            case 2:
                return u < 0.1 ? 10.0 : 0.0;
            default:
                return 0.2 / std::pow(1.0 - u, 0.8);  // mean 1, infinite variance
        }
    }

    std::uint64_t seed_;
};

RenderOptions goal(double error, int spp = 1 << 14) {
    RenderOptions options;
    options.width = side;
    options.height = side;
    options.threads = 2;
    options.spp = spp;
    options.intervals = true;
    options.goal.error = error;
    options.goal.floor = floor_of_test;
    return options;
}

struct Rendered {
    explicit Rendered(const RenderOptions& options, std::uint64_t seed = 1)
        : film(side, side), sums(side, side, layers()), state(film, &sums, tile_size_for(options)) {
        statistics = render(NoisyDevice(seed), options, state);
    }
    static FilmLayers layers() {
        FilmLayers layers;
        layers.runs = true;
        return layers;
    }
    Film film;
    FilmSums sums;
    FilmState state;
    RenderStatistics statistics;
};

TEST(Interval, LevelsArePowersOfTwoAndQuartersBetween) {
    std::vector<int> levels;
    for (int level = next_level(0); level < 100; level = next_level(level)) {
        levels.push_back(level);
    }
    EXPECT_EQ(levels, (std::vector<int>{1, 2, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24, 28, 32, 40, 48, 56, 64, 80, 96}));
    EXPECT_EQ(next_level(9), 10);
    EXPECT_EQ(next_level(33), 40);
}

// Of the 2000 pixels of the noisy bands with a variance, 95 % are to be right in the long run. Pixels and seeds are independent: over ten seeds the share
// of 20 480 has a standard deviation of 0.15 %; skewed samples and stopping may cost a little. Three standard deviations and half a percent.
TEST(Interval, HoldsTheTruthAsOftenAsItSays) {
    int inside = 0, pixels = 0, heavy = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const Rendered rendered(goal(0.05, 1 << 12), seed);
        const IntervalRule rule(0.95, floor_of_test);
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const Interval interval = rule.alone(rendered.sums, rendered.film.index(x, y));
                if (NoisyDevice::band(x) == 0) {
                    EXPECT_NEAR(interval.middle, NoisyDevice::truth(y), 1e-4);
                } else if (NoisyDevice::band(x) < 3) {
                    ++pixels;
                    heavy += interval.heavy() ? 1 : 0;
                    inside += std::fabs(interval.middle - NoisyDevice::truth(y)) <= interval.half_width ? 1 : 0;
                }
            }
        }
    }
    EXPECT_EQ(heavy, 0);
    EXPECT_GT(static_cast<double>(inside) / pixels, 0.95 - 0.0045 - 0.005);
    EXPECT_LT(static_cast<double>(inside) / pixels, 0.97);
}

TEST(Interval, RunsAreSixteenOrMoreOfOneLength) {
    for (std::uint32_t samples = 16; samples < 5000; ++samples) {
        const int runs = static_cast<int>(samples) / run_length(samples);
        EXPECT_GE(runs, least_runs);
        EXPECT_LT(runs, most_runs);
    }
    EXPECT_EQ(run_length(3), 1);
    EXPECT_EQ(run_length(31), 1);
    EXPECT_EQ(run_length(1024), 64);
}

// One sample in 3000 is very bright and brings a fifth of the light: of 64 samples a pixel most meet none of these, and alone are sure of the rest.
class RareLight : public MadeUpDevice {
    double light(int x, int y, int number) const override {
        const double u = chance_of(1, x, y, number);
        return u < 1.0 / 3000.0 ? 750.0 : 0.5 + u;
    }
};

TEST(Interval, NobodyIsSurerThanThoseAround) {
    constexpr double truth = 1.0 + 749.0 / 3000.0;
    RenderOptions options = goal(0.25, 1 << 10);
    Film film(side, side);
    FilmSums sums(side, side, Rendered::layers());
    FilmState state(film, &sums, tile_size_for(options));
    render(RareLight(), options, state);
    const IntervalRule rule(0.95, floor_of_test);
    int inside = 0, inside_alone = 0, pixels = 0;
    for (const Tile& block : state.tiles()) {
        std::size_t next = 0;
        const std::vector<Interval> intervals = rule.of(sums, block);
        for (int y = block.y0; y < block.y1; ++y) {
            for (int x = block.x0; x < block.x1; ++x, ++pixels) {
                const Interval& interval = intervals[next++];
                const Interval alone = rule.alone(sums, film.index(x, y));
                EXPECT_GE(interval.half_width, alone.half_width);
                inside += std::fabs(interval.middle - truth) <= interval.half_width ? 1 : 0;
                inside_alone += std::fabs(alone.middle - truth) <= alone.half_width ? 1 : 0;
            }
        }
    }
    EXPECT_GE(inside, 0.95 * pixels);
    EXPECT_LT(inside_alone, 0.9 * pixels);  // else this would test nothing
}

TEST(ErrorGoal, IsReachedWhereItCanBeAndSamplesGoWhereTheErrorIs) {
    RenderOptions options = goal(0.06);
    const Rendered rendered(options);
    double samples[4] = {};
    int heavy[4] = {};
    const IntervalRule rule(0.95, floor_of_test);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const std::size_t pixel = rendered.film.index(x, y);
            samples[NoisyDevice::band(x)] += rendered.film.samples[pixel] / (side * side / 4.0);
            heavy[NoisyDevice::band(x)] += rule.alone(rendered.sums, pixel).heavy() ? 1 : 0;
        }
    }
    // Relative variances are 0, 1/3 and 9: of n samples the half width is 2.13 sqrt(variance / n).
    EXPECT_LT(samples[0], 0.4 * samples[1]);  // not 64: one column of cells in four touches the noisy ones
    EXPECT_GT(samples[1], 2.13 * 2.13 / 3.0 / 0.0036);
    EXPECT_LT(samples[1], 2.0 * 2.13 * 2.13 / 3.0 / 0.0036);
    EXPECT_GT(samples[2], 10.0 * samples[1]);
    // A tail without a variance is not trusted, whatever its runs say.
    EXPECT_EQ(heavy[0] + heavy[1] + heavy[2], 0);
    EXPECT_GT(heavy[3], side * side / 4 / 5);
    EXPECT_TRUE(rendered.statistics.finished);
    EXPECT_NEAR(rendered.statistics.error.heavy, heavy[3] / static_cast<double>(side * side), 1e-9);
}

// One tile of four is a hundred times as hard as the others: the relative variances are 33 and 1/3.
class HardTile : public MadeUpDevice {
    double light(int x, int y, int number) const override {
        const double u = chance_of(0, x, y, number);
        const bool hard = 2 * x >= side && 2 * y >= side;
        return !hard ? 2.0 * u : u < 1.0 / 34.0 ? 34.0 : 0.0;
    }
};

RenderOptions planned_goal() {
    RenderOptions options = goal(0.1);
    options.goal.confidence = 0.7;
    options.goal = plan_goal(HardTile(), options);
    return options;
}

TEST(GoalPlan, AsksTilesForWhatIsEasy) {
    const RenderOptions options = planned_goal();
    const GoalPlan& plan = options.goal.plan;
    ASSERT_EQ(plan.wanted.size(), 4u);
    EXPECT_GE(plan.wanted[0] + plan.wanted[1] + plan.wanted[2] + plan.wanted[3], 0.7 * side * side);
    EXPECT_GT(std::min({plan.wanted[0], plan.wanted[1], plan.wanted[2]}), 850);
    EXPECT_LT(plan.wanted[3], 100);
    // What even noise takes, with Student's t for seven in ten and 15 degrees of freedom, and what the least lucky of some pixels looks like.
    const double samples = 1.074 * 1.074 / 3.0 / 0.01;
    EXPECT_GT(plan.end, samples);
    EXPECT_LT(plan.end, 3.0 * samples);
    EXPECT_NEAR(options.goal.floor, 0.1, 0.02);
    RenderOptions other = options;
    other.threads = 1;
    EXPECT_EQ(plan_goal(HardTile(), other).plan.wanted, plan.wanted);
}

TEST(GoalPlan, LeavesWhatIsHardestAlone) {
    const auto samples_for = [](const RenderOptions& options) {
        Film film(side, side);
        FilmSums sums(side, side, Rendered::layers());
        FilmState state(film, &sums, tile_size_for(options));
        const RenderStatistics done = render(HardTile(), options, state);
        EXPECT_TRUE(done.finished);
        EXPECT_GE(done.error.share, 0.7);
        return static_cast<double>(done.samples);
    };
    RenderOptions options = planned_goal();
    const double planned = samples_for(options);
    options.goal.plan = {};  // the share is kept in each tile
    EXPECT_LT(planned, 0.2 * samples_for(options));
}

TEST(ErrorGoal, HasTheSameBitsForThreadsOrderShardsAndResuming) {
    RenderOptions options = goal(0.05, 2048);
    options.goal = plan_goal(NoisyDevice(1), options);
    const Rendered whole(options);
    const auto same = [&](const Film& film, const FilmSums& sums) {
        for (std::size_t i = 0; i < film.samples.size(); ++i) {
            if (film.samples[i] != whole.film.samples[i] || film.radiance[i] != whole.film.radiance[i] ||
                sums.runs(i).sums != whole.sums.runs(i).sums) {
                return false;
            }
        }
        return true;
    };
    for (const int threads : {1, 3, 7}) {
        RenderOptions other = options;
        other.threads = threads;
        other.shuffle = static_cast<std::uint32_t>(threads);
        const Rendered rendered(other);
        EXPECT_TRUE(same(rendered.film, rendered.sums)) << threads;
    }
    Film film(side, side);
    FilmSums sums(side, side, Rendered::layers());
    FilmState state(film, &sums, tile_size_for(options));
    for (const int shard : {3, 1, 2}) {
        RenderOptions part = options;
        part.shard = shard;
        part.shards = 3;
        render(NoisyDevice(1), part, state);
    }
    EXPECT_TRUE(same(film, sums));

    class Stop : public RenderObserver {
    public:
        void tile_done(const Film&, const Tile&, const RenderProgress&) override { cancel = ++tiles_ % 3 == 0; }
        std::atomic<bool> cancel = false;

    private:
        int tiles_ = 0;
    };
    Film resumed(side, side);
    FilmSums resumed_sums(side, side, Rendered::layers());
    FilmState resumed_state(resumed, &resumed_sums, tile_size_for(options));
    Stop stop;
    int stops = 0;
    while (!render(NoisyDevice(1), options, resumed_state, &stop, &stop.cancel).finished) {
        stop.cancel = false;
        ++stops;
    }
    EXPECT_GT(stops, 3);
    EXPECT_TRUE(same(resumed, resumed_sums));
}

TEST(ErrorGoal, TimeEndsItToo) {
    RenderOptions options = goal(1e-6, 1 << 20);
    options.seconds = 0.2;
    const Rendered rendered(options);
    EXPECT_TRUE(rendered.statistics.finished);
    EXPECT_TRUE(rendered.statistics.out_of_time);
    EXPECT_LT(rendered.statistics.error.share, 0.95);
}

TEST(Clamp, TellsWhatItTook) {
    FilmLayers layers;
    layers.clamp = 2.0;
    Film film(side, side);
    FilmSums sums(side, side, layers);
    RenderOptions options;
    options.width = options.height = side;
    options.spp = 64;
    FilmState state(film, &sums, tile_size_for(options));
    const RenderStatistics done = render(NoisyDevice(1), options, state);
    double light = 0.0, truth = 0.0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side * 3 / 4; ++x) {
            const double value = static_cast<double>(film.radiance[film.index(x, y)].x);
            EXPECT_LE(value, 2.001);
            light += value + sums.clamped(film.index(x, y));
            truth += NoisyDevice::truth(y);
        }
    }
    EXPECT_NEAR(light / truth, 1.0, 0.05);
    EXPECT_GT(done.clamped, 0.5);
}

}  // namespace
}  // namespace lancer
