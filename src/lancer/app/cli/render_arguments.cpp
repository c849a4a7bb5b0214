#include "lancer/app/cli/render_arguments.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/import_arguments.h"
#include "lancer/image/view.h"
#include "lancer/render/render.h"
#include "lancer/world/compile.h"

namespace lancer::app {

void add_threads_option(CLI::App& app, std::optional<int>& threads) {
    add_whole(app, "--threads,--thread", threads, 1, max_threads, "How many threads work; all that the machine has if not given")
        ->group("Machine");
}

void add_render_options(CLI::App& app, RenderArguments& arguments) {
    add_size(app, "--size", arguments.size, "Width and height of the picture in pixels")->group("Picture");
    add_text(app, "--camera", arguments.camera, "NAME", "Which of the scene's cameras; the first if not given")->group("Picture");
    app.add_option("--lights", arguments.lights, "Only these lights, by name or number from 1; their shares are scaled to sum to 1 again")
        ->type_name("NAME,NAME")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->group("Picture");
    add_real(app, "--exposure", arguments.exposure, -100.0, 100.0,
             "Stops by which PNG and JPEG are brightened; EXR, HDR and TIFF keep the light as it is")
        ->group("Picture");
    add_choice(app, "--view", arguments.view, view_names(), "How PNG, JPEG and the window show what is too bright for a display")
        ->group("Picture");
    add_choice(app, "--integrator", arguments.integrator, {"auto", "whitted", "path", "direct", "light", "bdpt", "vcm"},
               "How light is followed")
        ->group("Light");
    add_whole(app, "--bounces", arguments.bounces, 0, max_path_bounces, "How often light goes on after the first hit, at most")
        ->group("Light");
    add_whole(app, "--diffuse-bounces", arguments.diffuse_bounces, 0, max_path_bounces, "How many of them off matt surfaces (path)")
        ->group("Light");
    add_whole(app, "--glossy-bounces", arguments.glossy_bounces, 0, max_path_bounces, "How many of them off mirrors and gloss (path)")
        ->group("Light");
    add_whole(app, "--transmission-bounces", arguments.transmission_bounces, 0, max_path_bounces,
              "How many of them through surfaces (path)")
        ->group("Light");
    add_choice(app, "--direct-samples", arguments.direct_samples, {"mis", "emitter", "bsdf"},
               "How lamps are found: both ways together, by asking lamps, by scattered rays (direct)")
        ->group("Light");
    add_whole(app, "--spp", arguments.spp, 1, 1 << 20, "Samples a pixel (path)")->group("Light");
    add_percentage(app, "--error", arguments.error,
                   "Render until the picture is known so well, and put samples where they are missing (path)")
        ->group("Light");
    add_percentage(app, "--confidence", arguments.confidence,
                   "The share of pixels, and the chance, that --error speaks of; 95% if not given")
        ->group("Light");
    add_duration(app, "--time", arguments.seconds, "Render so long; with --error or --spp, what comes first ends it (path)")
        ->group("Light");
    add_real(app, "--clamp", arguments.clamp, 1e-6, 1e30,
             "Make samples that are brighter than X as dark as X: less noise, less right (path)")
        ->group("Light");
    app.add_flag("--rgb", arguments.rgb, "Paths carry linear RGB instead of wavelengths: quicker, less right (path)")->group("Light");
    add_whole(app, "--seed", arguments.seed, 0, 2147483647, "Another number, another noise (path)")->group("Light");
    add_choice(app, "--aa", arguments.antialiasing, {"uniform", "adaptive"},
               "Smooth edges by a regular grid of samples in each pixel, or by subdividing where neighbours differ")
        ->group("Anti-aliasing");
    add_whole(app, "--ssaa", arguments.ssaa, 1, max_ssaa, "N x N samples in each pixel (uniform)")->group("Anti-aliasing");
    add_real(app, "--adaptive-threshold", arguments.adaptive_threshold, 0.0, 1.0,
             "Difference of what is displayed, from 0 to 1, above which a pixel is subdivided (adaptive)")
        ->group("Anti-aliasing");
    add_whole(app, "--adaptive-depth", arguments.adaptive_depth, 0, max_adaptive_depth, "How often at most, each time in four (adaptive)")
        ->group("Anti-aliasing");
    add_threads_option(app, arguments.threads);
    add_choice(app, "--trace", arguments.trace, {"auto", "lanes", "bvh"},
               "How rays find what they hit: all shapes at once, or a bounding volume hierarchy. The picture is the same")
        ->group("Machine");
    add_import_options(app, arguments.import);
}

void add_file_options(CLI::App& app, RenderArguments& arguments) {
    app.add_option("--aov", arguments.aovs,
                   "What EXR files hold beside the picture, such as albedo,normal,depth; \"--aov list\" tells all (path)")
        ->type_name("NAME,NAME")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->group("EXR files");
    add_whole(app, "--spectral-bins", arguments.spectral_bins, 0, 471, "Channels of spectral radiance, evenly from 360 to 830 nm (path)")
        ->group("EXR files");
    app.add_flag("--float", arguments.wide, "32-bit floats instead of halves")->group("EXR files");
}

std::vector<std::string> words_of(const RenderArguments& arguments) {
    std::vector<std::string> words = words_of(arguments.import);
    const auto add = [&](const char* name, const auto& value) {
        if (value) {
            words.push_back(name);
            words.push_back(fmt::format("{}", *value));
        }
    };
    if (arguments.size) {
        words.push_back("--size");
        words.push_back(fmt::format("{}x{}", arguments.size->width, arguments.size->height));
    }
    add("--camera", arguments.camera);
    if (!arguments.lights.empty()) {
        words.push_back("--lights");
        words.push_back(CLI::detail::join(arguments.lights, ","));
    }
    add("--exposure", arguments.exposure);
    add("--view", arguments.view);
    add("--integrator", arguments.integrator);
    add("--bounces", arguments.bounces);
    add("--diffuse-bounces", arguments.diffuse_bounces);
    add("--glossy-bounces", arguments.glossy_bounces);
    add("--transmission-bounces", arguments.transmission_bounces);
    add("--direct-samples", arguments.direct_samples);
    add("--spp", arguments.spp);
    add("--error", arguments.error ? std::optional(fmt::format("{}%", *arguments.error * 100.0)) : std::nullopt);
    add("--confidence", arguments.confidence ? std::optional(fmt::format("{}%", *arguments.confidence * 100.0)) : std::nullopt);
    add("--time", arguments.seconds ? std::optional(fmt::format("{}s", *arguments.seconds)) : std::nullopt);
    add("--clamp", arguments.clamp);
    if (arguments.rgb) {
        words.push_back("--rgb");
    }
    add("--seed", arguments.seed);
    add("--aa", arguments.antialiasing);
    add("--ssaa", arguments.ssaa);
    add("--adaptive-threshold", arguments.adaptive_threshold);
    add("--adaptive-depth", arguments.adaptive_depth);
    if (!arguments.aovs.empty()) {
        words.push_back("--aov");
        words.push_back(CLI::detail::join(arguments.aovs, ","));
    }
    add("--spectral-bins", arguments.spectral_bins);
    if (arguments.wide) {
        words.push_back("--float");
    }
    return words;
}

}  // namespace lancer::app
