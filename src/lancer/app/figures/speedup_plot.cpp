#include "lancer/app/figures/speedup_plot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace lancer::app {

namespace {

const glm::dvec3 ink(0.15);
const glm::dvec3 faint(0.85);
const glm::dvec3 grey(0.55);
const glm::dvec3 blue(0.10, 0.35, 0.70);

constexpr double left = 80.0;
constexpr double right = 690.0;
constexpr double top = 60.0;
constexpr double bottom = 400.0;

}  // namespace

Drawing plot_speedup(const std::vector<Timing>& timings) {
    Drawing drawing;
    drawing.width = 720;
    drawing.height = 460;

    const int last = timings.back().threads;
    double most = last;
    for (const Timing& timing : timings) {
        most = std::max(most, timings.front().seconds / timing.seconds);
    }
    const int rows = static_cast<int>(std::ceil(most));
    const double columns = std::max(1, last - 1);  // threads begin at 1
    const auto place = [&](double threads, double speedup) {
        return glm::dvec2(left + (right - left) * (threads - 1.0) / columns, bottom - (bottom - top) * speedup / rows);
    };

    const int row_step = std::max(1, rows / 8);
    for (int row = 0; row <= rows; row += row_step) {
        drawing.lines.push_back({{place(1, row), {right, place(1, row).y}}, 1.0, faint, false});
        drawing.words.push_back({fmt::format("{}", row), place(1, row) + glm::dvec2(-12.0, 5.0), 15.0, Drawing::Align::right, ink});
    }
    const std::size_t label_step = std::max<std::size_t>(1, (timings.size() + 11) / 12);
    for (std::size_t i = 0; i < timings.size(); i += label_step) {
        const glm::dvec2 at = place(timings[i].threads, 0.0);
        drawing.lines.push_back({{at, at + glm::dvec2(0.0, 6.0)}, 1.0, ink, false});
        drawing.words.push_back({fmt::format("{}", timings[i].threads), at + glm::dvec2(0.0, 24.0), 15.0, Drawing::Align::middle, ink});
    }
    drawing.lines.push_back({{{left, top}, {left, bottom}, {right, bottom}}, 1.5, ink, false});

    Drawing::Line measured{{}, 2.5, blue, false};
    for (const Timing& timing : timings) {
        const double speedup = timings.front().seconds / timing.seconds;
        measured.points.push_back(place(timing.threads, speedup));
        drawing.dots.push_back({measured.points.back(), 4.5, blue});
        if (timings.size() <= 12) {
            drawing.words.push_back({fmt::format("{:.3g} s", timing.seconds),
                                     measured.points.back() + glm::dvec2(timing.threads == 1 ? 10.0 : 0.0, 24.0), 13.0,
                                     timing.threads == 1      ? Drawing::Align::left
                                     : timing.threads == last ? Drawing::Align::right
                                                              : Drawing::Align::middle,
                                     blue});
        }
    }
    drawing.lines.push_back({{place(1, 1), place(last, last)}, 1.5, grey, true});
    drawing.lines.push_back(measured);

    drawing.words.push_back({"How many times faster Figure 1 is rendered", {left, 32.0}, 18.0, Drawing::Align::left, ink});
    drawing.words.push_back({"threads", {(left + right) / 2.0, bottom + 48.0}, 15.0, Drawing::Align::middle, ink});
    drawing.lines.push_back({{{left + 20.0, top + 16.0}, {left + 50.0, top + 16.0}}, 2.5, blue, false});
    drawing.words.push_back({"measured", {left + 60.0, top + 21.0}, 15.0, Drawing::Align::left, ink});
    drawing.lines.push_back({{{left + 20.0, top + 40.0}, {left + 50.0, top + 40.0}}, 1.5, grey, true});
    drawing.words.push_back({"as many times as threads", {left + 60.0, top + 45.0}, 15.0, Drawing::Align::left, ink});
    return drawing;
}

}  // namespace lancer::app
