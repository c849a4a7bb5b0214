#include "lancer/app/farm/farm_job.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unordered_set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "lancer/base/failure.h"
#include "lancer/image/replace_file.h"

namespace lancer::app {

namespace fs = std::filesystem;

namespace {

constexpr int manifest_format = 1;

std::unordered_set<std::string> names_in(const std::string& folder) {
    std::unordered_set<std::string> names;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        names.insert(entry.path().filename().string());
    }
    return names;
}

std::string name_of(const std::string& path) { return fs::path(path).filename().string(); }

nlohmann::ordered_json to_json(const FarmJob& job) {
    nlohmann::ordered_json json = {{"format", manifest_format}, {"lancer", job.version}, {"program", job.program},
                                   {"folder", job.where},       {"scene", job.scene},    {"hash", job.hash},
                                   {"options", job.options},    {"outputs", job.outputs}};
    if (job.frames) {
        json["frames"] = {{"first", job.frames->first}, {"last", job.frames->last}, {"step", job.frames->step}, {"fps", job.fps}};
    }
    json["shards"] = job.shards;
    json["tasks"] = job.tasks;
    json["keep_shards"] = job.keep_shards;
    json["checkpoint"] = job.checkpoint;
    json["scheduler_options"] = job.scheduler_options;
    json["tries_left"] = job.tries_left;
    json["rounds"] = nlohmann::ordered_json::array();
    for (const FarmRound& round : job.rounds) {
        json["rounds"].push_back({{"array", round.array}, {"merge", round.merge}});
    }
    return json;
}

FarmJob from_json(const nlohmann::json& json, const std::string& folder) {
    FarmJob job;
    std::error_code ignored;
    job.folder = fs::weakly_canonical(fs::absolute(folder, ignored), ignored).string();
    job.version = json.at("lancer");
    job.program = json.at("program");
    job.where = json.at("folder");
    job.scene = json.at("scene");
    job.hash = json.at("hash");
    job.options = json.at("options").get<std::vector<std::string>>();
    job.outputs = json.at("outputs").get<std::vector<std::string>>();
    if (json.contains("frames")) {
        const nlohmann::json& frames = json.at("frames");
        job.frames = FrameRange{frames.at("first"), frames.at("last"), frames.at("step")};
        job.fps = frames.at("fps");
    }
    job.shards = json.at("shards");
    job.tasks = json.at("tasks");
    job.keep_shards = json.at("keep_shards");
    job.checkpoint = json.at("checkpoint");
    job.scheduler_options = json.at("scheduler_options").get<std::vector<std::string>>();
    job.tries_left = json.at("tries_left");
    for (const nlohmann::json& round : json.at("rounds")) {
        job.rounds.push_back({round.at("array"), round.at("merge")});
    }
    const bool good_frames = !job.frames || (job.frames->first >= 0 && job.frames->first <= job.frames->last &&
                                             job.frames->last <= last_frame && job.frames->step >= 1 && job.fps > 0.0);
    if (!good_frames || job.shards < 1 || job.tasks < 1 || job.outputs.empty()) {
        throw std::runtime_error("numbers that make no sense");
    }
    return job;
}

}  // namespace

std::string manifest_file(const std::string& folder) { return (fs::path(folder) / "manifest.json").string(); }

std::string FarmJob::picture_name(int picture) const { return frames ? fmt::format("{:04}", frames->number(picture)) : "picture"; }

std::vector<std::string> FarmJob::outputs_of(int picture) const {
    std::vector<std::string> result = outputs;
    for (std::string& output : result) {
        output = frames ? numbered(output, frames->number(picture)) : output;
    }
    return result;
}

std::string FarmJob::unit_in_words(int unit) const {
    const std::string frame = frames ? fmt::format("frame {}", frames->number(picture_of(unit))) : "";
    const std::string shard = shards > 1 ? fmt::format("shard {} of {}", shard_of(unit), shards) : "";
    return frame.empty() && shard.empty() ? "the picture" : frame + (frame.empty() || shard.empty() ? "" : ", ") + shard;
}

std::string FarmJob::shard_file(int unit) const {
    return (fs::path(folder) / "shards" / fmt::format("{}.{}-of-{}.film", picture_name(picture_of(unit)), shard_of(unit), shards)).string();
}
std::string FarmJob::done_file(int picture) const { return (fs::path(folder) / "done" / picture_name(picture)).string(); }
std::string FarmJob::failed_file(int unit) const { return (fs::path(folder) / "failed" / fmt::format("{}", unit)).string(); }
std::string FarmJob::running_file(int unit) const { return (fs::path(folder) / "running" / fmt::format("{}", unit)).string(); }
std::string FarmJob::log_file(const std::string& task) const { return (fs::path(folder) / "log" / (task + ".log")).string(); }
std::string FarmJob::cancelled_file() const { return (fs::path(folder) / "cancelled").string(); }
std::string FarmJob::started_file() const { return (fs::path(folder) / "started").string(); }

std::vector<std::string> FarmJob::render_words(int unit) const {
    std::vector<std::string> words = {"render", scene};
    words.insert(words.end(), options.begin(), options.end());
    if (frames) {
        const int frame = frames->number(picture_of(unit));
        words.insert(words.end(), {"--frames", fmt::format("{}:{}", frame, frame), "--fps", fmt::format("{}", fps)});
    }
    if (shards > 1) {
        words.insert(words.end(), {"--shard", fmt::format("{}/{}", shard_of(unit), shards), "-o", shard_file(unit)});
        return words;
    }
    for (const std::string& output : outputs) {
        words.insert(words.end(), {"-o", output});
    }
    return words;
}

std::vector<std::string> FarmJob::shard_files(int picture) const {
    std::vector<std::string> files;
    for (int shard = 0; shard < shards && shards > 1; ++shard) {
        files.push_back(shard_file(picture * shards + shard));
    }
    return files;
}

std::vector<std::string> FarmJob::merge_words(int picture, const std::vector<std::string>& films) const {
    std::vector<std::string> words = {"merge"};
    words.insert(words.end(), films.begin(), films.end());
    for (const std::string& output : outputs_of(picture)) {
        words.insert(words.end(), {"-o", output});
    }
    return words;
}

std::optional<std::string> FarmJob::difference(const FarmJob& other) const {
    const auto differs = [](const char* what) { return std::optional<std::string>(what); };
    const auto range = [](const FarmJob& job) { return job.frames ? in_words(*job.frames) + fmt::format(" {}", job.fps) : ""; };
    return version != other.version       ? differs("another version of lancer")
           : where != other.where         ? differs("another folder that it was submitted from")
           : scene != other.scene         ? differs("another scene")
           : hash != other.hash           ? differs("a scene, or files that it reads, that have changed")
           : options != other.options     ? differs("other options")
           : outputs != other.outputs     ? differs("other files after -o")
           : range(*this) != range(other) ? differs("other frames")
           : shards != other.shards       ? differs("another number of shards")
                                          : std::nullopt;
}

std::optional<FarmJob> read_farm_job(const std::string& folder, std::string& sentence) {
    const std::string path = manifest_file(folder);
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        std::error_code ignored;
        sentence = fs::is_directory(folder, ignored)
                       ? fmt::format("{} is no job of a farm: there is no manifest.json in it", folder)
                       : fmt::format("there is no folder {}; jobs of a farm are the folders that \"lancer farm submit\" names", folder);
        return std::nullopt;
    }
    try {
        const nlohmann::json json = nlohmann::json::parse(file);
        if (json.at("format") != manifest_format) {
            sentence = fmt::format("{} was written by another version of lancer", path);
            return std::nullopt;
        }
        return from_json(json, folder);
    } catch (const std::exception& error) {
        sentence = fmt::format("{} can't be understood: {}", path, error.what());
        return std::nullopt;
    }
}

void write_manifest(const FarmJob& job) { replace_file(manifest_file(job.folder), to_json(job).dump(2) + "\n"); }

void make_farm_folder(const FarmJob& job) {
    for (const char* name : {"shards", "done", "failed", "running", "log"}) {
        std::error_code error;
        fs::create_directories(fs::path(job.folder) / name, error);
        if (error) {
            throw MachineFailure(fmt::format("cannot make the folder {}/{}: {}", job.folder, name, error.message()));
        }
    }
}

FarmState look_at(const FarmJob& job) {
    FarmState state;
    std::error_code ignored;
    state.cancelled = fs::exists(job.cancelled_file(), ignored);
    const std::unordered_set<std::string> done = names_in((fs::path(job.folder) / "done").string());
    const std::unordered_set<std::string> shards = names_in((fs::path(job.folder) / "shards").string());
    const std::unordered_set<std::string> failed = names_in((fs::path(job.folder) / "failed").string());
    const std::unordered_set<std::string> running = names_in((fs::path(job.folder) / "running").string());
    for (int picture = 0; picture < job.pictures(); ++picture) {
        state.pictures.push_back(done.contains(job.picture_name(picture)));
        state.pictures_done += state.pictures.back() ? 1 : 0;
    }
    for (int unit = 0; unit < job.units(); ++unit) {
        const bool is_done = state.pictures[static_cast<std::size_t>(job.picture_of(unit))] ||
                             (job.shards > 1 && shards.contains(name_of(job.shard_file(unit))));
        state.units.push_back(is_done);
        state.units_done += is_done ? 1 : 0;
        if (!is_done && running.contains(fmt::format("{}", unit))) {
            double share = 0.0;
            std::ifstream(job.running_file(unit)) >> share;
            state.units_begun += std::clamp(share, 0.0, 1.0);
        }
        if (!is_done && failed.contains(fmt::format("{}", unit))) {
            int status = 0;
            std::ifstream(job.failed_file(unit)) >> status;
            state.failed.emplace_back(unit, status);
        }
    }
    return state;
}

}  // namespace lancer::app
