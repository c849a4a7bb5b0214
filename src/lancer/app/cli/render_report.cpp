#include "lancer/app/cli/render_report.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "lancer/app/cli/progress.h"

namespace lancer::app {

namespace {

const char* in_words(PathFault::What what) {
    switch (what) {
        case PathFault::What::not_a_number:
            return "not a number";
        case PathFault::What::infinite:
            return "infinite";
        case PathFault::What::negative:
            return "negative";
        case PathFault::What::none:
            break;
    }
    return "wrong";
}

std::string where(const PathFault& fault, const World& world) {
    return fault.object < 0
               ? std::string("from the surroundings")
               : fmt::format("at vertex {}, on the {} \"{}\" of material \"{}\"", fault.vertex + 1, world.object_kind(fault.object),
                             world.object_name(fault.object), world.material_name(fault.material));
}

nlohmann::ordered_json bad_samples_json(const BadSamples& bad, const World& world) {
    nlohmann::ordered_json first = nlohmann::ordered_json::array();
    for (const BadSample& sample : bad.first()) {
        first.push_back({{"x", sample.x},
                         {"y", sample.y},
                         {"sample", sample.sample},
                         {"what", in_words(sample.fault.what)},
                         {"vertex", sample.fault.vertex + 1},
                         {"object", sample.fault.object < 0 ? "" : world.object_name(sample.fault.object)},
                         {"kind", sample.fault.object < 0 ? "" : world.object_kind(sample.fault.object)},
                         {"material", sample.fault.object < 0 ? "" : world.material_name(sample.fault.material)}});
    }
    return {{"count", bad.count()}, {"first", first}};
}

// "error", "time", "samples", or "stopped".
const char* ended_by(const RenderOptions& options, const RenderStatistics& done) {
    return !done.finished                                                            ? "stopped"
           : done.out_of_time                                                        ? "time"
           : options.goal.error > 0.0 && done.error.share >= options.goal.confidence ? "error"
                                                                                     : "samples";
}

nlohmann::ordered_json statistics_json(const Prepared& prepared, const RenderStatistics& done, const Times& times,
                                       const std::vector<std::string>& written) {
    return {
        {"version", LANCER_VERSION},
        {"command", prepared.metadata.at("lancer:command")},
        {"scene", prepared.scene.file},
        {"hash", prepared.scene.hash},
        {"width", prepared.options.width},
        {"height", prepared.options.height},
        {"antialiasing", prepared.metadata.at("lancer:antialiasing")},
        {"device", prepared.device->description()},
        {"threads", done.threads},
        {"finished", done.finished},
        {"samples", done.samples},
        {"rays",
         {{"camera", done.rays.camera}, {"secondary", done.rays.secondary}, {"shadow", done.rays.shadow}, {"total", done.rays.total()}}},
        {"rays_per_second", static_cast<double>(done.rays.total()) / std::max(times.render, 1e-9)},
        {"ended_by", ended_by(prepared.options, done)},
        {"error",
         {{"reached", done.error.reached},
          {"confidence", prepared.options.goal.confidence},
          {"share", done.error.share},
          {"heavy_tailed", done.error.heavy},
          {"floor", prepared.options.goal.floor}}},
        {"clamped", done.clamped},
        {"pixels_that_are_not_numbers", done.bad_pixels},
        {"bad_samples", bad_samples_json(done.bad_samples, *prepared.world)},
        {"seconds", {{"load", times.load}, {"prepare", times.prepare}, {"render", times.render}, {"write", times.write}}},
        {"processor_seconds", times.processor},
        {"written", written},
    };
}

}  // namespace

std::string statistics_as_json(const Prepared& prepared, const RenderStatistics& done, const Times& times,
                               const std::vector<std::string>& written, int indent) {
    return statistics_json(prepared, done, times, written).dump(indent);
}

namespace {

// What ended it, and how well the picture is known.
std::string goals_in_words(const RenderOptions& options, const RenderStatistics& done) {
    std::string words;
    if (options.seconds > 0.0 || options.goal.error > 0.0) {
        const bool good = options.goal.error > 0.0 && done.error.share >= options.goal.confidence;
        words += fmt::format("\nEnded by the {}.", done.out_of_time ? "time" : good ? "error" : "number of samples");
    }
    if (done.error.pixels > 0) {
        const double percent = 100.0;
        words += fmt::format("\nError: {:.3g}% or less for {:g}% of the pixels, at that confidence", done.error.reached * percent,
                             options.goal.confidence * percent);
        if (options.goal.error > 0.0) {
            words += fmt::format("; {:.1f}% of them are known within {:g}%", done.error.share * percent, options.goal.error * percent);
        }
        if (done.error.heavy > 0.0) {
            words += fmt::format("; {:.2g}% have a heavy tail and are not trusted", done.error.heavy * percent);
        }
        words += fmt::format(". {:.0f} samples a pixel in {}.", done.error.samples / static_cast<double>(done.error.pixels),
                             app::in_words(done.seconds));
    }
    if (done.clamped > 0.0) {
        words += fmt::format("\nClamping removed {:.2g}% of the light.", done.clamped * 100.0);
    }
    return words;
}

}  // namespace

std::string summary(const Prepared& prepared, const RenderStatistics& done, const Times& times, const std::vector<std::string>& written) {
    const std::string work = fmt::format("{}x{} in {} ({}, {} a second, {} {}; {})", prepared.options.width, prepared.options.height,
                                         in_words(times.render), with_prefix(static_cast<double>(done.samples), "samples"),
                                         with_prefix(static_cast<double>(done.rays.total()) / std::max(times.render, 1e-9), "rays"),
                                         done.threads, done.threads == 1 ? "thread" : "threads", prepared.device->description());
    const std::string files = written.empty() ? "Nothing" : fmt::format("{}", fmt::join(written, ", "));
    const std::uint64_t bad = done.bad_samples.count();
    const std::string without = bad == 0 ? "" : fmt::format("; without {} bad {}", bad, bad == 1 ? "sample" : "samples");
    return done.finished ? fmt::format("{} written: {}{}{}", files, work, without, goals_in_words(prepared.options, done))
                         : fmt::format("Stopped; {} written as far as it came: {}", files, work);
}

void report_bad_samples(const BadSamples& bad, const World& world) {
    if (bad.count() == 0) {
        return;
    }
    fmt::print(stderr, "lancer: warning: the light of {} was not a number, infinite or negative; the picture is made without {}\n",
               bad.count() == 1 ? "1 sample" : fmt::format("{} samples", bad.count()), bad.count() == 1 ? "it" : "them");
    for (const BadSample& sample : bad.first()) {
        fmt::print(stderr, "  pixel ({}, {}), sample {}: {} {}\n", sample.x, sample.y, sample.sample, in_words(sample.fault.what),
                   where(sample.fault, world));
    }
    if (bad.count() > bad.first().size()) {
        fmt::print(stderr, "  and {} more\n", bad.count() - bad.first().size());
    }
}

void report_bad_pixels(const RenderStatistics& done) {
    if (done.bad_pixels > 0) {
        fmt::print(stderr, "lancer: warning: {} of the picture {} not a number; the first is at ({}, {}), counted from the upper left\n",
                   done.bad_pixels == 1 ? "1 pixel" : fmt::format("{} pixels", done.bad_pixels), done.bad_pixels == 1 ? "is" : "are",
                   done.bad_x, done.bad_y);
    }
}

}  // namespace lancer::app
