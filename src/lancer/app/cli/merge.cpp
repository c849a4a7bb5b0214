// lancer merge FILMS -o PICTURE
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/film_about.h"
#include "lancer/app/cli/outputs.h"
#include "lancer/app/exit_status.h"
#include "lancer/base/failure.h"
#include "lancer/film/film_file.h"

namespace lancer::app {

namespace {

struct Arguments {
    std::vector<std::string> files;
    std::vector<std::string> outputs;
    bool partial = false;
    bool quiet = false;
};

// Films of one picture, joined.
class Merger {
public:
    // Throws FilmDamaged.
    void add(const std::string& path) {
        const FilmFile file(path);
        if (!state_) {
            first_ = path;
            about_ = file.about();
            shape_ = file.shape();
            film_ = Film(shape_.width, shape_.height);
            if (shape_.sums) {
                sums_.emplace(shape_.width, shape_.height, shape_.layers);
            }
            state_.emplace(film_, sums_ ? &*sums_ : nullptr, shape_.tile_size);
        } else if (!belongs(file)) {
            return;
        }
        const RenderOptions options = options_of(file.about(), shape_);
        given_.insert({options.shards, options.shard});
        file.add_to(*state_);
    }

    void show() {
        if (state_) {
            state_->show_splats();
        }
    }

    const std::vector<std::string>& foreign() const { return foreign_; }

    // What is missing, in words; empty where nothing is.
    std::vector<std::string> missing() const {
        const RenderOptions options = options_of(about_, shape_);
        const bool one_split = std::all_of(given_.begin(), given_.end(), [&](const auto& one) { return one.first == options.shards; });
        const int shards = one_split ? options.shards : 1;
        const std::vector<int> owners = shards_of_tiles(state_->tiles().size(), shards);
        std::set<int> unfinished;
        for (std::size_t tile = 0; tile < owners.size(); ++tile) {
            if (!is_finished(options, *state_, tile)) {
                unfinished.insert(owners[tile]);
            }
        }
        std::vector<std::string> sentences;
        for (const int shard : unfinished) {
            if (!one_split) {
                sentences.emplace_back("parts of the picture are missing");
            } else if (given_.contains({shards, shard})) {
                sentences.push_back(shards == 1 ? fmt::format("{} is not finished", first_)
                                                : fmt::format("shard {} of {} is not finished", shard, shards));
            } else {
                sentences.push_back(fmt::format("shard {} of {} is missing", shard, shards));
            }
        }
        return sentences;
    }

    const FilmState& state() const { return *state_; }
    const FilmAbout& about() const { return about_; }

private:
    bool belongs(const FilmFile& file) {
        std::vector<std::string> reasons = differences(about_.texts, file.about().texts);
        if (reasons.empty() && (about_.text("lancer:command") != file.about().text("lancer:command") || !(file.shape() == shape_))) {
            reasons.push_back(fmt::format("it was rendered by \"{}\", and the first by \"{}\"", file.about().text("lancer:command"),
                                          about_.text("lancer:command")));
        }
        if (!reasons.empty()) {
            foreign_.push_back(fmt::format("{} is no part of the same picture as {}: {}", file.path(), first_, fmt::join(reasons, "; ")));
        }
        return reasons.empty();
    }

    std::string first_;
    FilmAbout about_;
    FilmShape shape_;
    Film film_;
    std::optional<FilmSums> sums_;
    std::optional<FilmState> state_;
    std::set<std::pair<int, int>> given_;  // shards, shard
    std::vector<std::string> foreign_;
};

void say(const char* severity, const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) {
        fmt::print(stderr, "lancer merge: {}: {}\n", severity, sentence);
    }
}

bool has_bad_outputs(const Arguments& arguments) {
    Diagnostics diagnostics;
    std::vector<std::string> pictures;
    for (const std::string& path : arguments.outputs) {
        if (is_film(path)) {
            check_file(path, "-o", diagnostics);
        } else {
            pictures.push_back(path);
        }
    }
    check_pictures(pictures, "-o", diagnostics);
    print_diagnostics(diagnostics);
    return diagnostics.has_errors();
}

int merge(const CLI::App& app, const Arguments& arguments) {
    if (arguments.files.empty()) {
        return refuse("which films? For example: lancer merge out.*.film -o out.exr", app);
    }
    if (arguments.outputs.empty()) {
        return refuse("where shall the picture go? For example: -o out.exr", app);
    }
    if (has_bad_outputs(arguments)) {
        return exit_bad_input;
    }
    Merger merger;
    std::vector<std::string> damaged;
    for (const std::string& path : arguments.files) {
        try {
            merger.add(path);
        } catch (const FilmDamaged& damage) {
            damaged.emplace_back(damage.what());
        }
    }
    merger.show();
    say("error", damaged);
    say("error", merger.foreign());
    if (!damaged.empty() || !merger.foreign().empty()) {
        return exit_bad_input;
    }
    const std::vector<std::string> missing = merger.missing();
    say(arguments.partial ? "warning" : "error", missing);
    if (!missing.empty() && !arguments.partial) {
        fmt::print(stderr, "lancer merge: nothing was written; --partial writes what is there\n");
        return exit_bad_input;
    }
    const Presentation presentation = presentation_of(merger.about());
    const FilmState& state = merger.state();
    for (const std::string& path : arguments.outputs) {
        if (is_film(path)) {
            write_film_file(path, about_merged(merger.about(), arguments.outputs), state);
        } else {
            write_film(path, state.film(), presentation, presentation.contents.is_plain() ? nullptr : state.sums());
        }
    }
    if (!arguments.quiet) {
        fmt::print("{} written: {} {}, {}x{}{}\n", fmt::join(arguments.outputs, ", "), arguments.files.size(),
                   arguments.files.size() == 1 ? "film" : "films", state.film().width, state.film().height,
                   missing.empty() ? "" : ", not complete");
    }
    return missing.empty() ? exit_done : exit_stopped;
}

}  // namespace

void add_merge(CLI::App& program, Work& work) {
    CLI::App* app = program.add_subcommand("merge", "Join the shards of a picture that several machines have rendered");
    const auto arguments = std::make_shared<Arguments>();
    app->add_option("FILMS", arguments->files, "What \"lancer render --shard I/N\" wrote, in any order; checkpoints, too")->type_name("");
    app->add_option("-o,--output", arguments->outputs,
                    "Where the picture goes, as for render, or .film to go on with; may be given several times")
        ->type_name("FILE")
        ->allow_extra_args(false);
    app->add_flag("--partial", arguments->partial, "Write what is there even where shards are missing or not finished");
    app->add_flag("--quiet", arguments->quiet, "Say nothing but warnings and errors");
    app->footer(
        "Exit status: 0 done, 1 written as far as it came (--partial), 2 bad input: nothing was written.\n\n"
        "Example:\n  lancer render scene.toml --shard 1/2 -o out.exr\n  lancer render scene.toml --shard 2/2 -o out.exr\n"
        "  lancer merge out.1-of-2.film out.2-of-2.film -o out.exr");
    app->callback([app, arguments, &work] { work = [app, arguments] { return merge(*app, *arguments); }; });
}

}  // namespace lancer::app
