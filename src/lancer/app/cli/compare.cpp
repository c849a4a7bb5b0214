// lancer compare PICTURE REFERENCE
#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "lancer/app/cli/command_line.h"
#include "lancer/app/cli/compare_output.h"
#include "lancer/app/cli/outputs.h"
#include "lancer/app/cli/spelling.h"
#include "lancer/app/cli/values.h"
#include "lancer/app/exit_status.h"
#include "lancer/base/failure.h"
#include "lancer/image/exact.h"

namespace lancer::app {

namespace {

struct Arguments {
    std::vector<std::string> pictures, references;
    bool exact = false;
    bool json = false;
    bool channels = false;
    std::optional<std::string> flip_image, error_image;
    std::optional<double> max_mse, max_relmse, max_flip, min_p, pixels_per_degree;
    std::optional<int> block;

    bool has_limits() const { return max_mse || max_relmse || max_flip || min_p; }
    std::string command() const {
        std::vector<std::string> words = {"lancer", "compare"};
        words.insert(words.end(), pictures.begin(), pictures.end());
        words.push_back("--with");
        words.insert(words.end(), references.begin(), references.end());
        return shell_quoted(words);
    }
};

// What is wrong with the words, or nothing. Afterwards both groups have their pictures.
std::optional<std::string> sort_out(Arguments& arguments) {
    if (arguments.references.empty() && arguments.pictures.size() == 2) {
        arguments.references = {arguments.pictures.back()};
        arguments.pictures.pop_back();
    }
    if (arguments.references.empty() || arguments.pictures.empty()) {
        return arguments.pictures.size() > 2
                   ? "two pictures are compared; of several runs, name those of the first picture, then --with and those of the second"
                   : "which two pictures? For example: lancer compare a.exr b.exr";
    }
    if (arguments.exact && (arguments.pictures.size() > 1 || arguments.references.size() > 1)) {
        return "--exact compares two files, not groups of them";
    }
    if (arguments.exact && (arguments.flip_image || arguments.error_image || arguments.has_limits())) {
        return "--exact only tells whether the pixels are the same; it takes no limits and makes no pictures";
    }
    return std::nullopt;
}

int compare_exactly(const Arguments& arguments) {
    const std::string &a = arguments.pictures.front(), &b = arguments.references.front();
    const LayeredImage image = read_layers(a);
    const std::string difference = exact_difference(image, a, read_layers(b), b);
    if (arguments.json) {
        nlohmann::ordered_json json;
        json["pictures"] = arguments.pictures;
        json["references"] = arguments.references;
        json["same"] = difference.empty();
        json["difference"] = difference;
        fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    } else if (difference.empty()) {
        fmt::print("The pixels are the same: {} x {}, {} channel{}.\n", image.width, image.height, image.channels.size(),
                   image.channels.size() == 1 ? "" : "s");
    } else {
        fmt::print("The pixels are not the same: {}.\n", difference);
    }
    return difference.empty() ? exit_done : exit_stopped;
}

std::vector<Limit> limits_of(const Arguments& arguments, const Comparison& comparison) {
    std::vector<Limit> limits;
    const auto add = [&](const char* name, const std::optional<double>& limit, double found) {
        if (limit) {
            limits.push_back({name, *limit, found});
        }
    };
    add("MSE", arguments.max_mse, comparison.all.mse);
    add("relMSE", arguments.max_relmse, comparison.all.rel_mse);
    add("FLIP", arguments.max_flip, comparison.flip ? comparison.flip->mean() : 0.0);
    if (arguments.has_limits() && comparison.all.skipped > 0) {  // what was left out kept no limit
        limits.push_back({"The number of values that are infinite or no number", 0.0, static_cast<double>(comparison.all.skipped)});
    }
    return limits;
}

int compare_pictures(const Arguments& arguments) {
    Diagnostics diagnostics;
    for (const auto& [path, option] :
         {std::pair(arguments.flip_image, "--flip-image"), std::pair(arguments.error_image, "--error-image")}) {
        if (path) {
            check_pictures({*path}, option, diagnostics);
        }
    }
    if (diagnostics.has_errors()) {
        print_diagnostics(diagnostics);
        return exit_bad_input;
    }
    ComparisonOptions options;
    options.others = arguments.channels;
    options.block = arguments.block.value_or(options.block);
    options.significance = arguments.min_p.value_or(options.significance);
    options.pixels_per_degree = arguments.pixels_per_degree.value_or(options.pixels_per_degree);
    const Comparison comparison = compare(Runs::read(arguments.pictures), Runs::read(arguments.references), options);
    if (arguments.min_p && comparison.bias.empty()) {
        throw std::runtime_error(
            "--min-p: nothing is known of the noise; give several runs of a picture, or files with variance.R, variance.G and variance.B");
    }
    if ((arguments.flip_image || arguments.error_image || arguments.max_flip) && !comparison.flip) {
        throw std::runtime_error("the pictures have neither R, G and B nor Y, which FLIP and pictures of errors need");
    }
    const std::vector<Limit> limits = limits_of(arguments, comparison);
    const bool differs = arguments.min_p && comparison.headline_p < *arguments.min_p;
    const Metadata metadata = {{"Software", "lancer " LANCER_VERSION}, {"lancer:command", arguments.command()}};
    if (arguments.flip_image) {
        write_flip_image(*arguments.flip_image, *comparison.flip, metadata);
    }
    if (arguments.error_image) {
        write_error_image(*arguments.error_image, comparison, metadata);
    }
    const ComparedFiles files{arguments.pictures, arguments.references};
    if (arguments.json) {
        fmt::print("{}\n", comparison_as_json(files, comparison, options, limits));
    } else {
        print_comparison(files, comparison, options, limits);
    }
    const bool kept = std::none_of(limits.begin(), limits.end(), [](const Limit& limit) { return limit.fails(); });
    return kept && !differs ? exit_done : exit_stopped;
}

}  // namespace

void add_compare(CLI::App& program, Work& work) {
    CLI::App* app = program.add_subcommand("compare", "Tell how two pictures differ, and whether it is more than noise");
    const auto arguments = std::make_shared<Arguments>();
    app->add_option("PICTURE", arguments->pictures,
                    "The picture, and the reference that it is held against; or several runs of the picture")
        ->type_name("");
    app->add_option("--with", arguments->references, "The reference, or several runs of it")->type_name("REFERENCE");
    app->add_flag("--exact", arguments->exact,
                  "Only whether all channels are the same to the last bit; what the files say of themselves may differ");
    app->add_flag("--json", arguments->json, "For programs");
    app->add_flag("--channels", arguments->channels, "Compare all the other channels, too");
    add_whole(*app, "--block", arguments->block, 1, 4096, "Side of the blocks that are tested, in pixels; 16 if not given");
    add_text(*app, "--flip-image", arguments->flip_image, "FILE", "Write a map of what a person sees differ: black none, yellow all")
        ->group("Pictures");
    add_text(*app, "--error-image", arguments->error_image, "FILE",
             "Write a map of the relative difference; in EXR, HDR and TIFF the difference itself")
        ->group("Pictures");
    add_real(*app, "--pixels-per-degree", arguments->pixels_per_degree, 1.0, 1000.0, "How finely FLIP sees; 67 if not given")
        ->group("Pictures");
    add_real(*app, "--max-mse", arguments->max_mse, 0.0, 1e30, "Exit with 1 when MSE is larger")->group("Limits");
    add_real(*app, "--max-relmse", arguments->max_relmse, 0.0, 1e30, "Exit with 1 when relMSE is larger")->group("Limits");
    add_real(*app, "--max-flip", arguments->max_flip, 0.0, 1.0, "Exit with 1 when the mean of FLIP is larger")->group("Limits");
    add_real(*app, "--min-p", arguments->min_p, 0.0, 1.0,
             "Exit with 1 when the means differ so much that noise does so with a smaller chance only")
        ->group("Limits");
    app->footer(
        "Exit status: 0 compared, 1 a limit is exceeded or --exact found a difference, 2 bad input or usage.\n\n"
        "Example:\n  lancer compare picture.exr reference.exr --flip-image flip.png\n"
        "  lancer compare a1.exr a2.exr a3.exr --with b1.exr b2.exr b3.exr --min-p 0.001");
    app->callback([app, arguments, &work] {
        work = [app, arguments]() -> int {
            if (const auto sentence = sort_out(*arguments)) {
                return refuse(*sentence, *app);
            }
            try {
                return arguments->exact ? compare_exactly(*arguments) : compare_pictures(*arguments);
            } catch (const MachineFailure&) {
                throw;
            } catch (const std::runtime_error& error) {  // a file that can't be read, or pictures that can't be compared
                fmt::print(stderr, "lancer compare: error: {}\n", error.what());
                return exit_bad_input;
            }
        };
    });
}

}  // namespace lancer::app
