// What can be said on the command line about a picture: common to `render` and `view`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lancer/app/cli/values.h"
#include "lancer/import/import.h"

namespace CLI {
class App;
}  // namespace CLI

namespace lancer::app {

// What is not given stays as the scene says.
struct RenderArguments {
    ImportOptions import;
    std::optional<ImageSize> size;
    std::optional<std::string> camera;
    std::optional<std::string> integrator;
    std::optional<int> bounces;
    std::optional<int> diffuse_bounces;
    std::optional<int> glossy_bounces;
    std::optional<int> transmission_bounces;
    std::optional<std::string> direct_samples;
    std::optional<int> spp;
    std::optional<double> error;       // relative
    std::optional<double> confidence;  // a share
    std::optional<double> seconds;
    std::optional<double> clamp;
    bool rgb = false;
    std::optional<int> seed;
    std::optional<int> ssaa;
    std::optional<std::string> antialiasing;
    std::optional<double> adaptive_threshold;
    std::optional<int> adaptive_depth;
    std::optional<double> exposure;
    std::optional<std::string> view;
    std::vector<std::string> aovs;  // empty: what the scene says
    std::optional<int> spectral_bins;
    bool wide = false;
    std::vector<std::string> lights;  // empty: all of them
    std::optional<int> threads;       // unset: all hardware threads
    std::optional<std::string> trace;
};

void add_threads_option(CLI::App& app, std::optional<int>& threads);
void add_render_options(CLI::App& app, RenderArguments& arguments);
// What files can hold and windows can't show.
void add_file_options(CLI::App& app, RenderArguments& arguments);

// The options that were given and change the picture, as words of a command line, always in the same order. So that the same picture is
// written into its file with the same words, whatever the number of threads.
std::vector<std::string> words_of(const RenderArguments& arguments);

}  // namespace lancer::app
