// A render from the command line: what was asked for, and doing it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lancer/app/cli/render_arguments.h"
#include "lancer/app/frames/frame_progress.h"
#include "lancer/app/frames/frame_range.h"
#include "lancer/base/diagnostic.h"
#include "lancer/film/film_file.h"

namespace CLI {
class App;
}  // namespace CLI

namespace lancer::app {

// `shard` of `shards` equal shares of the work, from 1 on.
struct Shard {
    int shard = 1;
    int shards = 1;
};

struct RenderJob {
    std::vector<std::string> files;  // the scene, and pictures that follow an -o
    std::vector<std::string> outputs;
    std::optional<std::string> sample_map;
    std::optional<std::string> stats;
    std::optional<std::string> progress;
    std::optional<std::string> progress_file;
    std::optional<Shard> shard;
    std::optional<FrameRange> frames;  // one picture for each
    std::optional<double> fps;
    std::optional<std::string> only_if;  // the hash that the scene must have
    FramePart part;                      // of more than this picture
    bool keeps_film = true;              // beside a picture that took long, for more samples later
    std::optional<double> checkpoint;    // seconds; 0: none
    std::optional<std::string> preview;
    bool quiet = false;
    RenderArguments render;
};

// Positional words beside the scene are pictures: `-o out.exr out.png`. A sentence where scene or pictures are missing.
std::optional<std::string> sort_files(RenderJob& job);

// Errors where the pictures and films can't be written.
void check_outputs(const RenderJob& job, Diagnostics& diagnostics);

// The options of `lancer render`.
void add_job_options(CLI::App& app, RenderJob& job);

// What a job goes on with, or repeats.
struct Begun {
    std::string name;                      // of the file that tells of it
    Metadata metadata;                     // what it says of itself; the job must say the same
    std::unique_ptr<const FilmFile> film;  // null: nothing but the above is there
    std::string output;                    // that the checkpoints belong to
};

// Renders and writes. Returns the exit status; throws MachineFailure.
int run_render_job(const CLI::App& app, RenderJob job, std::optional<Begun> begun = std::nullopt);

// The words after "lancer" that make the job again.
std::vector<std::string> words_of(const RenderJob& job);

// The job of such words; nothing where they make none. Those that come later count.
std::optional<RenderJob> job_of_words(const std::vector<std::string>& words);

}  // namespace lancer::app
