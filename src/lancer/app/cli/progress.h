// Tells on standard error how far a render is: a bar that moves on a terminal, a line now and then elsewhere, or JSON for programs.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "lancer/render/render.h"

namespace lancer::app {

enum class ProgressStyle { none, bar, plain, json };

// `wanted`: "bar", "plain", "json" or nothing said; then a bar where standard error is a terminal.
ProgressStyle choose_progress(const std::optional<std::string>& wanted, bool quiet);

// One line that is drawn over again.
class ProgressPrinter {
public:
    // `done` of `total` in any unit; `rate` is text such as "12.3 M samples/s", maybe empty.
    ProgressPrinter(ProgressStyle style, std::string what) : style_(style), what_(std::move(what)) {}
    ~ProgressPrinter() { clear(); }

    // `more`: what programs are told besides, as JSON's ",\"key\":value".
    void show(double share, double seconds, double seconds_left, const std::string& rate, const std::string& more = "");
    void clear();  // removes the bar, so that something else can be printed

private:
    using Clock = std::chrono::steady_clock;

    ProgressStyle style_;
    std::string what_;
    std::optional<Clock::time_point> last_;
    Clock::time_point start_ = Clock::now();
    bool drawn_ = false;
};

class RenderProgressPrinter : public RenderObserver {
public:
    RenderProgressPrinter(ProgressStyle style, std::string what) : printer_(style, std::move(what)) {}
    void tile_done(const Film& film, const Tile& tile, const RenderProgress& progress) override;
    void clear() { printer_.clear(); }

private:
    ProgressPrinter printer_;
};

// Keeps a file current that tells others how far the work is: its share, from 0 to 1. Removes it in the end. A file that can't be written is no reason to stop.
class ProgressFile : public RenderObserver {
public:
    // Passes on to `next` what it is told; `next` must outlive it.
    ProgressFile(std::string path, RenderObserver& next) : path_(std::move(path)), next_(next) {}
    ~ProgressFile() override;
    void tile_done(const Film& film, const Tile& tile, const RenderProgress& progress) override;

private:
    using Clock = std::chrono::steady_clock;

    std::string path_;
    RenderObserver& next_;
    std::optional<Clock::time_point> last_;
};

std::string in_words(double seconds);                             // "0.213 s", "1 min 05 s"
std::string with_prefix(double number, const std::string& unit);  // "12.3 M rays"

}  // namespace lancer::app
