// A picture on disk that is written anew while a render goes on.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "lancer/app/prepare.h"
#include "lancer/film/film_state.h"

namespace lancer::app {

class Previews {
public:
    // Begins at once, on a thread of its own, and ends with this. All that is given must outlive it.
    Previews(std::string path, const FilmState& state, const Presentation& presentation);
    ~Previews();
    Previews(const Previews&) = delete;
    Previews& operator=(const Previews&) = delete;

private:
    void run();
    bool write();

    std::string path_;
    const FilmState& state_;
    const Presentation& presentation_;
    bool stopping_ = false;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::thread thread_;
};

}  // namespace lancer::app
