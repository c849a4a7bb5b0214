// A picture, or the frames of an animation, cut into units of work that machines do without talking to each other.
//
// All that they share is a folder:
//   manifest.json    what is to be rendered, and what was given to the scheduler; written when work is submitted, and only then
//   task.sh, merge.sh  what the scheduler runs
//   shards/          films of shares that are done: FRAME.I-of-N.film
//   done/            a file for each frame (or "picture") whose pictures stand where they belong
//   failed/          a file for each unit that could not be done, with the exit status
//   log/             what each task said
//   running/         for each unit that a machine works on, the share of it that is done
//   started          there since the first task began to work
//   cancelled        there after `lancer farm cancel`
// Each of these files appears whole, by renaming, and is the same whoever makes it. So two machines may do the same unit, and one that is killed
// leaves nothing behind but time.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lancer/app/frames/frame_range.h"

namespace lancer::app {

// What the scheduler was given at one time.
struct FarmRound {
    std::string array;  // its name for the array of tasks, and for the merge
    std::string merge;
};

constexpr int farm_tries = 3;
constexpr double usual_checkpoint = 600.0;  // seconds: a thousand machines that write at once are many

struct FarmJob {
    std::string folder;   // of the job, by its full path
    std::string version;  // of lancer
    std::string program;  // the lancer that works, by its full path
    std::string where;    // the folder that names on the command line are seen from
    std::string scene;
    std::string hash;                  // of the scene and all that it reads
    std::vector<std::string> options;  // of lancer render
    std::vector<std::string> outputs;
    std::optional<FrameRange> frames;
    double fps = usual_fps;
    int shards = 1;  // of each picture
    int tasks = 1;
    bool keep_shards = false;
    double checkpoint = usual_checkpoint;  // seconds; 0: none
    std::vector<std::string> scheduler_options;
    std::vector<FarmRound> rounds;
    int tries_left = farm_tries;  // how often the merge may submit again what is missing

    int pictures() const { return frames ? frames->count() : 1; }
    int units() const { return pictures() * shards; }
    int picture_of(int unit) const { return unit / shards; }
    int shard_of(int unit) const { return unit % shards + 1; }
    int task_of(int unit) const { return unit % tasks + 1; }  // neighbours, which take about as long, go to different tasks

    std::string picture_name(int picture) const;             // "0012", "picture"
    std::vector<std::string> outputs_of(int picture) const;  // from `where`
    std::string unit_in_words(int unit) const;               // "frame 12, shard 3 of 16"

    std::string shard_file(int unit) const;
    std::string done_file(int picture) const;
    std::string failed_file(int unit) const;
    std::string running_file(int unit) const;
    std::string log_file(const std::string& task) const;
    std::string cancelled_file() const;
    std::string started_file() const;  // there since the first task began

    // Words for `lancer`, without the machine's own (threads, progress), seen from `where`.
    std::vector<std::string> render_words(int unit) const;
    std::vector<std::string> merge_words(int picture, const std::vector<std::string>& films) const;
    std::vector<std::string> shard_files(int picture) const;  // whether they are there or not; none where a picture is one unit

    // That both are the same work; else what differs, in words.
    std::optional<std::string> difference(const FarmJob& other) const;
};

std::string manifest_file(const std::string& folder);

// Nothing where there is none or it can't be understood; the sentence says why.
std::optional<FarmJob> read_farm_job(const std::string& folder, std::string& sentence);
void write_manifest(const FarmJob& job);  // throws MachineFailure

// Makes the folder with all that it holds. Throws MachineFailure.
void make_farm_folder(const FarmJob& job);

// What is there, by reading some folders, however many units there are.
struct FarmState {
    std::vector<bool> pictures;               // done
    std::vector<bool> units;                  // done, or part of a picture that is
    std::vector<std::pair<int, int>> failed;  // unit, exit status
    int units_done = 0;
    double units_begun = 0.0;  // of the others, what is done: the sum of their shares
    int pictures_done = 0;
    bool cancelled = false;
};
FarmState look_at(const FarmJob& job);

}  // namespace lancer::app
