#include "lancer/app/cli/previews.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include <fmt/format.h>

#include "lancer/app/cli/outputs.h"
#include "lancer/base/failure.h"

namespace lancer::app {

namespace {

constexpr double shortest_pause = 1.0;  // seconds
constexpr double largest_share = 0.02;  // of the time, spent on previews

// What is there; a tile is copied while nobody adds to it.
Film snapshot(const FilmState& state) {
    Film film(state.film().width, state.film().height);
    for (std::size_t tile = 0; tile < state.tiles().size(); ++tile) {
        const auto lock = state.lock(tile);
        if (state.rounds(tile) == 0) {
            continue;
        }
        const Tile& place = state.tiles()[tile];
        for (int y = place.y0; y < place.y1; ++y) {
            const auto first = static_cast<std::ptrdiff_t>(film.index(place.x0, y));
            std::copy_n(state.film().radiance.begin() + first, place.width(), film.radiance.begin() + first);
        }
    }
    return film;
}

}  // namespace

Previews::Previews(std::string path, const FilmState& state, const Presentation& presentation)
    : path_(std::move(path)), state_(state), presentation_(presentation), thread_([this] { run(); }) {}

Previews::~Previews() {
    {
        const std::scoped_lock lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

void Previews::run() {
    using Clock = std::chrono::steady_clock;
    double pause = shortest_pause;
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, std::chrono::duration<double>(pause), [&] { return stopping_; })) {
        lock.unlock();
        const auto start = Clock::now();
        const bool written = write();
        pause = std::max(shortest_pause, std::chrono::duration<double>(Clock::now() - start).count() / largest_share);
        lock.lock();
        if (!written) {
            return;
        }
    }
}

bool Previews::write() {
    try {
        Presentation plain;
        plain.metadata = presentation_.metadata;
        plain.view = presentation_.view;
        plain.threads = 1;
        write_film(path_, snapshot(state_), plain);
        return true;
    } catch (const MachineFailure& failure) {
        fmt::print(stderr, "lancer: warning: no preview: {}\n", failure.what());
        return false;
    }
}

}  // namespace lancer::app
