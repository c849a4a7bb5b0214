// The render loop against a device that paints a formula instead of following rays.
#include "lancer/render/render.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstring>
#include <functional>
#include <limits>
#include <mutex>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <glm/common.hpp>

#include "lancer/film/display.h"
#include "lancer/image/image.h"
#include "lancer/render/blocks.h"
#include "lancer/render/uniform.h"

namespace lancer {
namespace {

using Paint = std::function<glm::vec3(glm::vec2)>;

class PaintedDevice : public Device {
public:
    explicit PaintedDevice(Paint paint, int lanes = 16) : paint_(std::move(paint)), lanes_(lanes) {}

    int lanes() const override { return lanes_; }
    std::string description() const override { return "a formula"; }
    void follow(std::span<const glm::vec2> points, std::span<glm::vec3> radiance, RayCounts& counts) const override {
        ASSERT_EQ(points.size(), radiance.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            radiance[i] = paint_(points[i]);
        }
        counts.camera += points.size();
    }
    void trace_paths(const PathRange& range, const PathSamples& samples, RayCounts& counts) const override {
        std::size_t next = 0;
        for (int y = range.y0; y < range.y1; ++y) {
            for (int x = range.x0; x < range.x1; ++x) {
                for (int i = 0; i < range.sample_count; ++i) {
                    samples.radiance[next++] = paint_(glm::vec2(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f)) *
                                               static_cast<float>(range.first_sample + i);
                }
            }
        }
        counts.camera += range.paths();
    }

private:
    Paint paint_;
    int lanes_;
};

// Not a whole number of tiles in either direction.
RenderOptions small_options() {
    RenderOptions options;
    options.width = 75;
    options.height = 41;
    options.threads = 1;
    return options;
}

constexpr glm::vec2 disk_centre(36.3f, 20.7f);
constexpr float disk_radius = 15.4f;

glm::vec3 paint_disk(glm::vec2 p) {
    const glm::vec2 d = p - disk_centre;
    return d.x * d.x + d.y * d.y < disk_radius * disk_radius ? glm::vec3(0.9f, 0.7f, 0.2f) : glm::vec3(0.1f, 0.2f, 0.4f);
}

// Smooth in one half, checkered in the other, so that adaptive sampling has both.
glm::vec3 paint_mixture(glm::vec2 p) {
    const glm::vec3 smooth(0.5f + 0.4f * std::sin(p.x * 0.05f), p.y / 50.0f, 0.3f);
    const bool dark = (static_cast<int>(p.x / 2.7f) + static_cast<int>(p.y / 3.1f)) % 2 == 0;
    return p.x + 0.3f * p.y < 40.0f ? smooth : smooth * (dark ? 0.1f : 1.7f);
}

Film render_film(const Device& device, const RenderOptions& options, RenderStatistics* statistics = nullptr) {
    Film film(options.width, options.height);
    const RenderStatistics result = render(device, options, film);
    if (statistics != nullptr) {
        *statistics = result;
    }
    return film;
}

bool same_bytes(const Film& a, const Film& b) {
    return a.radiance.size() == b.radiance.size() &&
           std::memcmp(a.radiance.data(), b.radiance.data(), a.radiance.size() * sizeof(glm::vec3)) == 0 && a.samples == b.samples;
}

double rms_difference(const Film& a, const Film& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.radiance.size(); ++i) {
        const glm::dvec3 d = glm::dvec3(a.radiance[i]) - glm::dvec3(b.radiance[i]);
        sum += d.x * d.x + d.y * d.y + d.z * d.z;
    }
    return std::sqrt(sum / static_cast<double>(3 * a.radiance.size()));
}

TEST(Tiles, CoverEachPixelOnce) {
    std::vector<Tile> tiles = cut_tiles(75, 41, 16);
    std::vector<std::size_t> order(tiles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    shuffle(order, 7);
    EXPECT_EQ(tiles.size(), 5u * 3u);
    std::vector<int> visits(75 * 41, 0);
    for (const std::size_t i : order) {
        const Tile& tile = tiles[i];
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                ++visits.at(static_cast<std::size_t>(y * 75 + x));
            }
        }
    }
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), 75 * 41);
}

TEST(Blocks, ShapesFollowTheLanes) {
    const auto shape = [](int lanes) { return std::pair(block_shape(lanes).width, block_shape(lanes).height); };
    EXPECT_EQ(shape(1), std::pair(1, 1));
    EXPECT_EQ(shape(4), std::pair(2, 2));
    EXPECT_EQ(shape(8), std::pair(4, 2));
    EXPECT_EQ(shape(16), std::pair(4, 4));
    EXPECT_EQ(shape(3), std::pair(3, 1));
}

TEST(UniformSampling, RunsOfPointsAreNeighbours) {
    for (const int lanes : {4, 8, 16}) {
        const SamplePattern pattern(16, 16, 3, lanes);
        for (std::size_t first = 0; first < pattern.points.size(); first += static_cast<std::size_t>(lanes)) {
            glm::vec2 low = pattern.points[first];
            glm::vec2 high = low;
            for (std::size_t i = first; i < first + static_cast<std::size_t>(lanes); ++i) {
                low = glm::min(low, pattern.points[i]);
                high = glm::max(high, pattern.points[i]);
            }
            ASSERT_EQ((high.x - low.x + 1.0f) * (high.y - low.y + 1.0f), static_cast<float>(lanes));
        }
    }
}

TEST(UniformSampling, FollowsEveryPointOfTheGridOnce) {
    for (const int ssaa : {1, 3, 8, 20, 64}) {
        RenderOptions options = small_options();
        options.width = ssaa > 8 ? 18 : options.width;
        options.height = ssaa > 8 ? 17 : options.height;
        options.ssaa = ssaa;
        std::vector<int> visits(static_cast<std::size_t>(options.width * options.height * ssaa * ssaa), 0);
        const auto visit = [&](glm::vec2 p) {
            const double x = static_cast<double>(p.x) * ssaa - 0.5;
            const double y = static_cast<double>(p.y) * ssaa - 0.5;
            EXPECT_NEAR(x, std::round(x), 1e-3);
            EXPECT_NEAR(y, std::round(y), 1e-3);
            ++visits.at(static_cast<std::size_t>(std::lround(y) * options.width * ssaa + std::lround(x)));
            return glm::vec3(1.0f);
        };
        RenderStatistics statistics;
        const Film film = render_film(PaintedDevice(visit), options, &statistics);
        EXPECT_TRUE(std::all_of(visits.begin(), visits.end(), [](int n) { return n == 1; })) << "ssaa " << ssaa;
        EXPECT_TRUE(
            std::all_of(film.samples.begin(), film.samples.end(), [&](std::uint32_t n) { return n == std::uint32_t(ssaa * ssaa); }));
        EXPECT_EQ(statistics.samples, visits.size());
        EXPECT_EQ(statistics.rays.camera, visits.size());
        EXPECT_TRUE(statistics.finished);
    }
}

TEST(UniformSampling, PixelsAreMeansOfTheirSamples) {
    RenderOptions options = small_options();
    options.ssaa = 5;
    const Film film = render_film(PaintedDevice([](glm::vec2 p) { return glm::vec3(p.x, p.y, p.x * p.y); }), options);
    for (int y = 0; y < options.height; ++y) {
        for (int x = 0; x < options.width; ++x) {
            const glm::vec3& c = film.radiance[film.index(x, y)];
            const float cx = static_cast<float>(x) + 0.5f;
            const float cy = static_cast<float>(y) + 0.5f;
            ASSERT_NEAR(c.x, cx, 1e-4f);
            ASSERT_NEAR(c.y, cy, 1e-4f);
            ASSERT_NEAR(c.z, cx * cy, 1e-3f);
        }
    }
}

class EitherSampling : public testing::TestWithParam<bool> {
protected:
    RenderOptions options() const {
        RenderOptions options = small_options();
        options.adaptive = GetParam();
        options.ssaa = 3;
        return options;
    }
};

TEST_P(EitherSampling, HasTheSameBytesForAnyThreadsOrderAndLanes) {
    const Film one = render_film(PaintedDevice(paint_mixture), options());
    for (const int threads : {2, 3, 16}) {
        RenderOptions other = options();
        other.threads = threads;
        EXPECT_TRUE(same_bytes(one, render_film(PaintedDevice(paint_mixture), other))) << threads << " threads";
    }
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        RenderOptions other = options();
        other.shuffle = seed;
        other.threads = 2;
        EXPECT_TRUE(same_bytes(one, render_film(PaintedDevice(paint_mixture), other))) << "order " << seed;
    }
    for (const int lanes : {1, 4, 8, 5}) {
        EXPECT_TRUE(same_bytes(one, render_film(PaintedDevice(paint_mixture, lanes), options()))) << lanes << " lanes";
    }
    // The comparison would see a difference.
    EXPECT_FALSE(same_bytes(one, render_film(PaintedDevice(paint_disk), options())));
}

TEST_P(EitherSampling, UsesAsManyThreadsAsAsked) {
    RenderOptions four = options();
    four.threads = 4;
    std::mutex mutex;
    std::condition_variable came;
    std::set<std::thread::id> seen;
    const auto slow = [&](glm::vec2 p) {
        std::unique_lock lock(mutex);
        if (seen.insert(std::this_thread::get_id()).second) {
            came.notify_all();
            // The first one waits for another, on however busy a machine.
            came.wait_for(lock, std::chrono::seconds(20), [&] { return seen.size() > 1; });
        }
        return paint_disk(p);
    };
    RenderStatistics statistics;
    render_film(PaintedDevice(slow), four, &statistics);
    EXPECT_EQ(statistics.threads, 4);
    EXPECT_LE(seen.size(), 4u);
    EXPECT_GE(seen.size(), 2u);
}

TEST_P(EitherSampling, TellsProgressInOrderAndOneAtATime) {
    class Observer : public RenderObserver {
    public:
        void tile_done(const Film& film, const Tile& tile, const RenderProgress& progress) override {
            EXPECT_FALSE(inside_.exchange(true));
            EXPECT_EQ(progress.pixels_done, last_ + tile.width() * tile.height());
            EXPECT_GE(progress.seconds_left, 0.0);
            last_ = progress.pixels_done;
            total_ = progress.pixels_total;
            for (int y = tile.y0; y < tile.y1; ++y) {
                for (int x = tile.x0; x < tile.x1; ++x) {
                    EXPECT_GT(film.samples[film.index(x, y)], 0u);
                }
            }
            inside_ = false;
        }
        std::int64_t last_ = 0;
        std::int64_t total_ = 0;
        std::atomic<bool> inside_ = false;
    };
    RenderOptions many = options();
    many.threads = 5;
    Film film(many.width, many.height);
    Observer observer;
    render(PaintedDevice(paint_mixture), many, film, &observer);
    EXPECT_EQ(observer.total_, many.width * many.height);
    EXPECT_EQ(observer.last_, observer.total_);
}

TEST_P(EitherSampling, StopsWhenCancelledAndKeepsWhatIsDone) {
    class Observer : public RenderObserver {
    public:
        void tile_done(const Film&, const Tile& tile, const RenderProgress&) override {
            done_ += tile.width() * tile.height();
            cancel_ = true;
        }
        std::atomic<bool> cancel_ = false;
        int done_ = 0;
    };
    Film film(options().width, options().height);
    Observer observer;
    const RenderStatistics statistics = render(PaintedDevice(paint_disk), options(), film, &observer, &observer.cancel_);
    EXPECT_FALSE(statistics.finished);
    const auto rendered = std::count_if(film.samples.begin(), film.samples.end(), [](std::uint32_t n) { return n > 0; });
    EXPECT_EQ(rendered, observer.done_);
    EXPECT_LT(observer.done_, options().width * options().height);
}

TEST_P(EitherSampling, CountsPixelsThatAreNotNumbers) {
    const auto paint = [](glm::vec2 p) {
        const bool bad = p.x > 30.1f && p.x < 30.9f && p.y > 7.1f && p.y < 7.9f;
        return glm::vec3(bad ? std::numeric_limits<float>::quiet_NaN() : 0.5f);
    };
    RenderOptions fine = options();
    fine.ssaa = 3;
    fine.threads = 2;
    RenderStatistics statistics;
    render_film(PaintedDevice(paint), fine, &statistics);
    if (GetParam()) {
        EXPECT_EQ(statistics.bad_pixels, 0u);  // hidden between corners that agree
    } else {
        EXPECT_EQ(statistics.bad_pixels, 1u);
        EXPECT_EQ(statistics.bad_x, 30);
        EXPECT_EQ(statistics.bad_y, 7);
    }
}

INSTANTIATE_TEST_SUITE_P(Render, EitherSampling, testing::Bool(), [](const auto& kind) { return kind.param ? "Adaptive" : "Uniform"; });

TEST(AdaptiveSampling, FollowsOnlyTheCornersOfAPlainPicture) {
    RenderOptions options = small_options();
    options.adaptive = true;
    RenderStatistics statistics;
    const Film film = render_film(PaintedDevice([](glm::vec2) { return glm::vec3(0.25f); }), options, &statistics);
    // Tiles of 32: three columns of 33, 33 and 12 corners, two rows of 33 and 10.
    EXPECT_EQ(statistics.rays.camera, (33u + 33u + 12u) * (33u + 10u));
    for (const glm::vec3& c : film.radiance) {
        EXPECT_EQ(c, glm::vec3(0.25f));
    }
}

TEST(AdaptiveSampling, CountsEachSampleForOnePixel) {
    for (const int depth : {0, 1, 3, 5}) {
        RenderOptions options = small_options();
        options.adaptive = true;
        options.adaptive_depth = depth;
        RenderStatistics statistics;
        const Film film = render_film(PaintedDevice(paint_disk), options, &statistics);
        std::uint64_t sum = 0;
        for (const std::uint32_t n : film.samples) {
            EXPECT_GT(n, 0u);
            sum += n;
        }
        // Those on the far borders of tiles lie in the next one, which follows them again.
        EXPECT_EQ(statistics.samples, statistics.rays.camera);
        EXPECT_LT(sum, statistics.samples);
        EXPECT_GT(sum, statistics.samples * 8 / 10);
        EXPECT_EQ(film.samples.front(), 1u);
        EXPECT_EQ(film.samples.back(), 1u);
    }
}

TEST(AdaptiveSampling, IsExactForASlope) {
    RenderOptions options = small_options();
    options.adaptive = true;
    options.adaptive_threshold = 0.001;
    const Film film = render_film(PaintedDevice([](glm::vec2 p) { return glm::vec3(p.x / 75.0f, p.y / 41.0f, 0.5f); }), options);
    for (int y = 0; y < options.height; ++y) {
        for (int x = 0; x < options.width; ++x) {
            ASSERT_NEAR(film.radiance[film.index(x, y)].x, (static_cast<float>(x) + 0.5f) / 75.0f, 1e-5f);
            ASSERT_NEAR(film.radiance[film.index(x, y)].y, (static_cast<float>(y) + 0.5f) / 41.0f, 1e-5f);
        }
    }
}

TEST(AdaptiveSampling, ReachesTheErrorOfAGridWithAThirdOfItsSamples) {
    RenderOptions options = small_options();
    options.width = 300;
    options.height = 200;
    // A disk and a slanted edge on a slope: edges are a small part of the picture, as in most.
    const auto paint = [](glm::vec2 p) {
        const glm::vec2 d = p - glm::vec2(120.3f, 90.7f);
        const float slope = 0.2f + 0.001f * p.x;
        return d.x * d.x + d.y * d.y < 60.4f * 60.4f ? glm::vec3(0.9f, 0.7f, slope) : glm::vec3(p.y + 0.37f * p.x < 240.0f ? slope : 0.05f);
    };
    const PaintedDevice device(paint);
    options.ssaa = 64;
    const Film truth = render_film(device, options);
    options.ssaa = 4;
    RenderStatistics grid;
    const double grid_error = rms_difference(truth, render_film(device, options, &grid));
    options.adaptive = true;
    RenderStatistics adaptive;
    const double adaptive_error = rms_difference(truth, render_film(device, options, &adaptive));
    EXPECT_LT(adaptive_error, grid_error);
    EXPECT_LT(3 * adaptive.samples, grid.samples);
}

TEST(AdaptiveSampling, LooksAtLightAfterTheView) {
    RenderOptions options = small_options();
    options.adaptive = true;
    const auto samples = [&](float dark, float bright, double exposure) {
        options.exposure = exposure;
        RenderStatistics statistics;
        render_film(PaintedDevice([=](glm::vec2 p) { return glm::vec3(p.x < 30.3f ? dark : bright); }), options, &statistics);
        return statistics.samples;
    };
    const std::uint64_t plain = samples(0.5f, 0.5f, 0.0);
    EXPECT_GT(samples(0.5f, 0.8f, 0.0), plain);
    EXPECT_EQ(samples(3.0f, 9.0f, 0.0), plain);     // both are white
    EXPECT_GT(samples(3.0f, 9.0f, -4.0), plain);    // until the exposure brings them back
    EXPECT_GT(samples(0.001f, 0.02f, 0.0), plain);  // small in light, large to the eye
}

TEST(AdaptiveSampling, FollowsAThinLineBetweenCorners) {
    // 0.4 pixels wide and nearly level: most corners miss it, but each cut shows it to the next pixel.
    RenderOptions options = small_options();
    options.width = 32;
    options.height = 16;
    options.adaptive = true;
    const auto paint = [](glm::vec2 p) { return glm::vec3(std::abs(p.y - 8.5f - 0.015f * (p.x - 30.0f)) < 0.2f ? 1.0f : 0.0f); };
    const Film film = render_film(PaintedDevice(paint), options);
    options.adaptive = false;
    options.ssaa = 16;
    EXPECT_LT(rms_difference(film, render_film(PaintedDevice(paint), options)), 0.06);
}

TEST(DisplayCurve, IsTheSrgbCurve) {
    const DisplayCurve curve(1.0);
    for (int i = 0; i <= 5000; ++i) {
        const float light = static_cast<float>(i) * 1e-4f;
        ASSERT_NEAR(curve.encode(light), srgb_encode(2.0f * light), 5e-4f) << light;
    }
    EXPECT_EQ(curve.encode(0.7f), 1.0f);
    EXPECT_EQ(curve.encode(-1.0f), 0.0f);
    EXPECT_EQ(curve.encode(std::numeric_limits<float>::quiet_NaN()), 0.0f);
    EXPECT_LE(curve.encode(std::nextafter(0.5f, 0.0f)), 1.0f);
}

}  // namespace
}  // namespace lancer
