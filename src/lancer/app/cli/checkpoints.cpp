#include "lancer/app/cli/checkpoints.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

#include "lancer/app/cli/film_about.h"
#include "lancer/base/failure.h"
#include "lancer/base/thread_clock.h"

namespace lancer::app {

namespace {

// Of the time between two checkpoints, a processor spends at most this share on writing one. Waiting for the disk holds nobody up.
constexpr double largest_share = 0.02;

}  // namespace

std::string checkpoint_path(const std::string& output) { return output + ".checkpoint"; }
std::string checkpoint_before_path(const std::string& output) { return output + ".checkpoint-before"; }

Checkpoints::Checkpoints(std::string output, FilmAbout about, const FilmState& state, CheckpointTimes times)
    : output_(std::move(output)), about_(std::move(about)), state_(state), times_(times), thread_([this] { run(); }) {}

int Checkpoints::stop() {
    {
        const std::scoped_lock lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_all();
    if (thread_.joinable()) {
        thread_.join();
    }
    return count_;
}

void Checkpoints::run() {
    using Clock = std::chrono::steady_clock;
    double pause = times_.first;
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, std::chrono::duration<double>(pause), [&] { return stopping_; })) {
        lock.unlock();
        const auto start = Clock::now();
        const double worked = thread_seconds();
        write();
        const double took = std::chrono::duration<double>(Clock::now() - start).count();
        pause = std::max(times_.every - took, (thread_seconds() - worked) / largest_share);
        lock.lock();
    }
}

bool Checkpoints::write(bool durable) {
    try {
        write_film_file(checkpoint_path(output_), about_, state_, checkpoint_before_path(output_), durable);
        ++count_;
        return true;
    } catch (const MachineFailure& failure) {
        if (!warned_) {  // a full disk stays full
            fmt::print(stderr, "lancer: warning: no checkpoint: {}\n", failure.what());
        }
        warned_ = true;
        return false;
    }
}

void Checkpoints::remove() {
    std::error_code ignored;
    std::filesystem::remove(checkpoint_path(output_), ignored);
    remove_before();
}

void Checkpoints::remove_before() {
    std::error_code ignored;
    std::filesystem::remove(checkpoint_before_path(output_), ignored);
}

std::unique_ptr<const FilmFile> find_film(const std::string& output) {
    std::vector<std::string> damaged;
    for (const std::string& path : {checkpoint_path(output), checkpoint_before_path(output), output}) {
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored) || (path == output && !is_film(path) && !path.ends_with(".checkpoint"))) {
            continue;
        }
        try {
            auto film = std::make_unique<const FilmFile>(path);
            for (const std::string& useless : damaged) {  // so that it does not push out the good one, which comes after it
                std::filesystem::remove(useless, ignored);
            }
            return film;
        } catch (const FilmDamaged& damage) {
            fmt::print(stderr, "lancer: warning: {}\n", damage.what());
            if (path != output) {
                damaged.push_back(path);
            }
        }
    }
    return nullptr;
}

}  // namespace lancer::app
