// Writes a film now and then while it is made, so that nothing is lost.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include "lancer/film/film_file.h"

namespace lancer::app {

struct CheckpointTimes {  // seconds
    double first = 60.0;  // after the start
    double every = 30.0;
};

// Where the checkpoint of a picture or a shard stands, and the one before it.
std::string checkpoint_path(const std::string& output);
std::string checkpoint_before_path(const std::string& output);

class Checkpoints {
public:
    // Begins at once, on a thread of its own. `state` must outlive this.
    Checkpoints(std::string output, FilmAbout about, const FilmState& state, CheckpointTimes times);
    ~Checkpoints() { stop(); }
    Checkpoints(const Checkpoints&) = delete;
    Checkpoints& operator=(const Checkpoints&) = delete;

    // No more after this. Returns how many there were.
    int stop();

    // One now, from the caller's thread, after stop(). False, and a warning, when it can't be written. `durable`: waits for the disk.
    bool write(bool durable = true);
    // After stop(): removes what was written, or only the one before the last.
    void remove();
    void remove_before();

private:
    void run();

    std::string output_;
    FilmAbout about_;
    const FilmState& state_;
    CheckpointTimes times_;
    int count_ = 0;
    bool warned_ = false;
    bool stopping_ = false;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::thread thread_;
};

// The newest film that can be gone on with: the checkpoint, the one before it, or `output` itself if that is a film. Says on standard error what was
// passed over. Null when there is none. Throws MachineFailure.
std::unique_ptr<const FilmFile> find_film(const std::string& output);

}  // namespace lancer::app
