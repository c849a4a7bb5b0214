// Films that were cut short, written, read, shared out and joined end in the same bytes.

#include <cstring>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "lancer/device/cpu/cpu.h"
#include "lancer/film/film_file.h"
#include "lancer/import/import.h"
#include "lancer/render/goal_plan.h"
#include "lancer/render/render.h"
#include "lancer/world/compile.h"
#include "temporary_folder.h"

namespace lancer {
namespace {

constexpr int width = 149;  // not a whole number of tiles
constexpr int height = 83;

struct Kind {
    std::string name;
    std::string scene;
    bool adaptive = false;
    int spp = 0;
    FilmLayers layers;
    std::string integrator = {};  // other than the scene's
};

// A film with all that belongs to it.
struct Whole {
    Whole(const RenderOptions& options, const FilmLayers& layers) : film(options.width, options.height) {
        if (options.spp > 0) {
            sums.emplace(options.width, options.height, layers);
        }
        state.emplace(film, sums ? &*sums : nullptr, tile_size_for(options));
    }

    // Every bit of it.
    std::string bytes() const {
        ByteWriter all;
        for (std::size_t tile = 0; tile < state->tiles().size(); ++tile) {
            state->save(tile, all);
        }
        all.put_all(std::span<const glm::vec3>(film.radiance));
        if (sums && sums->splats() != nullptr) {
            all.put(sums->splats()->paths());
            all.put_all(sums->splats()->words());
        }
        return all.bytes();
    }

    Film film;
    std::optional<FilmSums> sums;
    std::optional<FilmState> state;
};

// Cancels when so many tiles are done.
class After : public RenderObserver {
public:
    explicit After(int tiles) : left_(tiles) {}
    void tile_done(const Film&, const Tile&, const RenderProgress&) override { cancel = --left_ <= 0; }
    std::atomic<bool> cancel = false;

private:
    int left_;
};

class Shared : public testing::TestWithParam<Kind> {
protected:
    void SetUp() override {
        Diagnostics diagnostics;
        std::optional<scene::Scene> scene = import_scene(LANCER_SOURCE_FOLDER "/scenes/" + GetParam().scene, diagnostics);
        ASSERT_TRUE(scene);
        scene->settings.width = width;
        scene->settings.height = height;
        if (!GetParam().integrator.empty()) {
            scene->settings.integrator = GetParam().integrator;
        }
        device_ = make_cpu_device(compile_world(*scene, scene->cameras.front(), diagnostics), {});
        options_.width = width;
        options_.height = height;
        options_.ssaa = 2;
        options_.spp = GetParam().spp;
        options_.adaptive = GetParam().adaptive;
        options_.threads = 2;
        if (GetParam().layers.runs) {
            options_.intervals = true;
            options_.goal.error = 0.3;
            options_.goal = plan_goal(*device_, options_);
        }
    }
    Whole fresh() const { return Whole(options_, GetParam().layers); }
    std::string uninterrupted() const {
        Whole whole = fresh();
        render(*device_, options_, *whole.state);
        return whole.bytes();
    }
    // Writes the state and reads it into another.
    void through_file(const Whole& from, Whole& to) const {
        write_film_file(file_, {{{"key", "text"}}, {{"list", {"a", "b"}}}}, *from.state);
        const FilmFile file(file_);
        EXPECT_EQ(file.about().text("key"), "text");
        EXPECT_EQ(file.about().list("list").size(), 2u);
        EXPECT_EQ(file.shape(), shape_of(*to.state));
        file.add_to(*to.state);
        to.state->show_splats();
    }

    std::unique_ptr<Device> device_;
    RenderOptions options_;
    tests::TemporaryFolder folder_;
    std::string file_ = folder_ / "film";
};

TEST_P(Shared, AnySplitMergedIsTheWhole) {
    const std::string whole = uninterrupted();
    for (const int shards : {2, 3, 7}) {
        Whole merged = fresh();
        for (int shard = shards; shard >= 1; --shard) {
            RenderOptions part = options_;
            part.shard = shard;
            part.shards = shards;
            part.shuffle = static_cast<std::uint32_t>(shard);
            Whole share = fresh();
            EXPECT_TRUE(render(*device_, part, *share.state).finished);
            through_file(share, merged);
        }
        EXPECT_TRUE(merged.bytes() == whole) << shards << " shards";
    }
}

TEST_P(Shared, StoppedAndResumedIsTheWhole) {
    const std::string whole = uninterrupted();
    const int more = GetParam().layers.runs ? 17 : 3;  // tiles each time: not too many times
    Whole film = fresh();
    bool finished = false;
    int stops = 0;
    for (int tiles = 1; !finished; tiles += more, ++stops) {
        After after(tiles);
        finished = render(*device_, options_, *film.state, &after, &after.cancel).finished;
        Whole next = fresh();
        through_file(film, next);
        EXPECT_TRUE(next.bytes() == film.bytes() || !finished);
        film.film = Film(width, height);
        if (film.sums) {
            film.sums.emplace(width, height, GetParam().layers);
        }
        film.state.emplace(film.film, film.sums ? &*film.sums : nullptr, tile_size_for(options_));
        FilmFile(file_).add_to(*film.state);
        film.state->show_splats();
    }
    EXPECT_GT(stops, 2);
    EXPECT_TRUE(film.bytes() == whole);
}

INSTANTIATE_TEST_SUITE_P(
    Golden, Shared,
    testing::Values(Kind{"Whitted", "report/figure-1.toml", false, 0, {}}, Kind{"WhittedAdaptive", "report/figure-1.toml", true, 0, {}},
                    Kind{"Paths", "gallery/cornell-box.toml", false, 19, {}},
                    Kind{"PathsWithEverything", "gallery/cornell-box.toml", false, 5, {true, true, true, true, 7}, ""},
                    Kind{"PathsWithAGoal", "gallery/cornell-box.toml", false, 192, {false, false, false, false, 0, true, 5.0}, ""},
                    Kind{"BothEnds", "gallery/cornell-box.toml", false, 5, {false, false, true, true, 0, false, 0.0, true}, "bdpt"},
                    Kind{"Photons", "gallery/cornell-box.toml", false, 3, {false, false, false, false, 0, false, 0.0, true}, "vcm"}),
    [](const auto& one) { return one.param.name; });

// Splats can't be told apart by tiles: who has all of a film's work needs nothing of it, and films that each have more of something are refused.
TEST(SplatFilms, OverlapOnlyWhereOneHasAllOfTheOther) {
    Diagnostics diagnostics;
    std::optional<scene::Scene> scene = import_scene(LANCER_SOURCE_FOLDER "/scenes/gallery/cornell-box.toml", diagnostics);
    ASSERT_TRUE(scene);
    RenderOptions options;
    options.width = scene->settings.width = 70;
    options.height = scene->settings.height = 40;
    options.spp = 4;
    scene->settings.integrator = "bdpt";
    const auto device = make_cpu_device(compile_world(*scene, scene->cameras.front(), diagnostics), {});
    FilmLayers layers;
    layers.splats = true;
    const tests::TemporaryFolder folder;
    const auto write = [&](const std::string& name, int shard, int shards, int spp) {
        RenderOptions part = options;
        part.shard = shard;
        part.shards = shards;
        part.spp = spp;
        Whole film(options, layers);
        render(*device, part, *film.state);
        write_film_file(folder / name, {}, *film.state);
    };
    write("half", 1, 2, 4);
    write("half-begun", 1, 2, 2);
    write("rest", 2, 2, 4);
    write("third", 1, 3, 4);
    Whole whole(options, layers);
    render(*device, options, *whole.state);
    for (const std::vector<std::string>& order : {std::vector<std::string>{"half", "rest"},
                                                  {"half-begun", "rest", "half"},
                                                  {"half", "half-begun", "half", "rest", "rest"},
                                                  {"rest", "half-begun", "half-begun", "half", "half-begun"}}) {
        Whole merged(options, layers);
        for (const std::string& name : order) {
            FilmFile(folder / name).add_to(*merged.state);
        }
        merged.state->show_splats();
        EXPECT_TRUE(merged.bytes() == whole.bytes()) << order.front() << ", " << order.size() << " films";
    }
    Whole merged(options, layers);
    FilmFile(folder / "half").add_to(*merged.state);
    const std::string before = merged.bytes();
    EXPECT_THROW(FilmFile(folder / "third").add_to(*merged.state), FilmDamaged);
    EXPECT_TRUE(merged.bytes() == before);
}

TEST(Samples, MoreLaterAreTheSameAsMoreAtOnce) {
    Diagnostics diagnostics;
    std::optional<scene::Scene> scene = import_scene(LANCER_SOURCE_FOLDER "/scenes/gallery/cornell-box.toml", diagnostics);
    ASSERT_TRUE(scene);
    RenderOptions options;
    options.width = scene->settings.width = 45;
    options.height = scene->settings.height = 33;
    const auto device = make_cpu_device(compile_world(*scene, scene->cameras.front(), diagnostics), {});
    const FilmLayers layers{true, true, false, false, 3};
    options.spp = 1;
    Whole in_steps(options, layers);
    for (const int spp : {1, 3, 22, 40}) {
        options.spp = spp;
        render(*device, options, *in_steps.state);
        Whole at_once(options, layers);
        render(*device, options, *at_once.state);
        EXPECT_TRUE(in_steps.bytes() == at_once.bytes()) << spp << " samples";
    }
}

TEST(Shards, AreEvenAndCoverAll) {
    for (const int shards : {1, 2, 3, 8, 20}) {
        std::vector<int> counts(static_cast<std::size_t>(shards) + 1, 0);
        for (const int shard : shards_of_tiles(17, shards)) {
            ++counts.at(static_cast<std::size_t>(shard));
        }
        EXPECT_EQ(counts[0], 0);
        for (int shard = 1; shard <= shards; ++shard) {
            EXPECT_NEAR(counts[static_cast<std::size_t>(shard)], 17.0 / shards, 1.0) << shards;
        }
    }
}

TEST(FilmFile, EveryDamageIsNoticed) {
    RenderOptions options;
    options.width = 5;
    options.height = 4;
    options.spp = 1;
    Whole whole(options, {});
    whole.state->add_round(0);
    const tests::TemporaryFolder folder;
    const std::string path = folder / "film";
    write_film_file(path, {{{"key", "text"}}, {}}, *whole.state);
    const std::string good = folder.read("film");
    EXPECT_NO_THROW(FilmFile{path});
    const auto put = [&](const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; };
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string bad = good;
        bad[i] = static_cast<char>(bad[i] ^ 0x10);
        put(bad);
        EXPECT_THROW(FilmFile{path}, FilmDamaged) << "byte " << i;
        put(good.substr(0, i));
        EXPECT_THROW(FilmFile{path}, FilmDamaged) << "cut at " << i;
    }
    put(good + "x");
    EXPECT_THROW(FilmFile{path}, FilmDamaged);
}

}  // namespace
}  // namespace lancer
