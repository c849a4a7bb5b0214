// What is said about a render when it is done: to people, and to programs.
#pragma once

#include <string>
#include <vector>

#include "lancer/app/prepare.h"
#include "lancer/render/render.h"

namespace lancer::app {

struct Times {  // seconds
    double load = 0.0;
    double prepare = 0.0;
    double render = 0.0;
    double write = 0.0;
    double processor = 0.0;  // of all threads, while rendering
};

// Numbers about the render, as JSON.
std::string statistics_as_json(const Prepared& prepared, const RenderStatistics& done, const Times& times,
                               const std::vector<std::string>& written, int indent);

// One sentence.
std::string summary(const Prepared& prepared, const RenderStatistics& done, const Times& times, const std::vector<std::string>& written);

// Warnings on standard error.
void report_bad_samples(const BadSamples& bad, const World& world);
void report_bad_pixels(const RenderStatistics& done);

}  // namespace lancer::app
