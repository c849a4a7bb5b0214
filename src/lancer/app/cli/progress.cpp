#include "lancer/app/cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

#include "lancer/base/failure.h"
#include "lancer/image/replace_file.h"

namespace lancer::app {

ProgressStyle choose_progress(const std::optional<std::string>& wanted, bool quiet) {
    if (wanted == "json") {
        return ProgressStyle::json;
    }
    if (quiet) {
        return ProgressStyle::none;
    }
    if (!wanted) {
        return isatty(STDERR_FILENO) != 0 ? ProgressStyle::bar : ProgressStyle::plain;
    }
    return *wanted == "bar" ? ProgressStyle::bar : ProgressStyle::plain;
}

std::string in_words(double seconds) {
    const long whole = std::lround(seconds);
    if (seconds < 9.995 && seconds != static_cast<double>(whole)) {
        return fmt::format("{:.{}f} s", seconds, seconds < 0.9995 ? 3 : 2);
    }
    if (whole < 60) {
        return fmt::format("{} s", whole);
    }
    if (whole < 3600) {
        return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    }
    return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

std::string with_prefix(double number, const std::string& unit) {
    const char* const prefixes[] = {"", "k ", "M ", "G ", "T "};
    std::size_t i = 0;
    while (number >= 999.5 && i + 1 < std::size(prefixes)) {
        number /= 1000.0;
        ++i;
    }
    const int digits = i == 0 || number >= 99.95 ? 0 : number >= 9.995 ? 1 : 2;
    return fmt::format("{:.{}f} {}{}", number, digits, prefixes[i], unit);
}

void ProgressPrinter::show(double share, double seconds, double seconds_left, const std::string& rate, const std::string& more) {
    if (style_ == ProgressStyle::none) {
        return;
    }
    // Nobody reads more often, and a terminal may be slow. Lines in a log are for work that takes long.
    const auto now = Clock::now();
    const auto pause = style_ == ProgressStyle::plain ? std::chrono::milliseconds(2000) : std::chrono::milliseconds(100);
    if (now - last_.value_or(start_) < pause) {
        return;
    }
    last_ = now;
    if (style_ == ProgressStyle::json) {
        fmt::print(stderr, "{{\"event\":\"progress\",\"share\":{:.4f},\"seconds\":{:.3f},\"seconds_left\":{:.3f}{}}}\n", share, seconds,
                   seconds_left, more);
    } else if (style_ == ProgressStyle::plain) {
        fmt::print(stderr, "{}: {:.0f} %{}{}, {} left\n", what_, std::floor(share * 100.0), rate.empty() ? "" : ", ", rate,
                   in_words(std::ceil(seconds_left)));
    } else {
        constexpr int cells = 24;
        const int full = std::clamp(static_cast<int>(share * cells), 0, cells);
        fmt::print(stderr, "\r{} [{:#<{}}{:-<{}}] {:3.0f} %{}{}, {} left\033[K", what_, "", full, "", cells - full,
                   std::floor(share * 100.0), rate.empty() ? "" : "  ", rate, in_words(std::ceil(seconds_left)));
        drawn_ = true;
    }
    std::fflush(stderr);
}

void ProgressPrinter::clear() {
    if (drawn_) {
        fmt::print(stderr, "\r\033[K");
        std::fflush(stderr);
        drawn_ = false;
    }
}

void RenderProgressPrinter::tile_done(const Film&, const Tile&, const RenderProgress& progress) {
    const double a_second = static_cast<double>(progress.samples_done) / std::max(progress.seconds, 1e-9);
    const bool has_error = progress.error > 0.0 && std::isfinite(progress.error);
    const std::string error = has_error ? fmt::format(", error {:.2g}%", progress.error * 100.0) : "";
    std::string more = fmt::format(",\"samples\":{},\"samples_per_second\":{:.0f}", progress.samples_done, a_second);
    more += has_error ? fmt::format(",\"error\":{:.6g}", progress.error) : "";
    printer_.show(progress.share, progress.seconds, progress.seconds_left, with_prefix(a_second, "samples/s") + error, more);
}

ProgressFile::~ProgressFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

void ProgressFile::tile_done(const Film& film, const Tile& tile, const RenderProgress& progress) {
    next_.tile_done(film, tile, progress);
    const auto now = Clock::now();
    if (last_ && now - *last_ < std::chrono::seconds(2)) {
        return;
    }
    last_ = now;
    try {
        replace_file(path_, fmt::format("{:.4f}\n", progress.share));
    } catch (const MachineFailure&) {  // the next time, maybe
    }
}

}  // namespace lancer::app
