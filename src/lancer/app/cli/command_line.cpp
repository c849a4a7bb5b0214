#include "lancer/app/cli/command_line.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/app/cli/farm.h"
#include "lancer/app/cli/frames.h"
#include "lancer/app/cli/render_arguments.h"
#include "lancer/app/cli/spelling.h"
#include "lancer/app/exit_status.h"
#include "lancer/app/figures/figures.h"
#include "lancer/app/window/show.h"

namespace lancer::app {

namespace {

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return names;
}

std::vector<std::string> subcommand_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* sub : app.get_subcommands(nullptr)) {
        names.push_back(sub->get_name());
    }
    return names;
}

// Words that nobody claimed: an option or a subcommand that does not exist, or one word too many.
std::optional<std::string> explain_leftovers(const CLI::App& app) {
    const std::vector<std::string> words = app.remaining();
    if (words.empty()) {
        return std::nullopt;
    }
    for (const std::string& word : words) {
        if (word.size() > 1 && word.starts_with('-') && word != "--") {
            const std::string name = word.substr(0, word.find('='));
            return fmt::format("there is no option {};{}", name, did_you_mean(name, option_names(app)));
        }
    }
    const std::string& word = words.front();
    if (!app.get_subcommands(nullptr).empty()) {
        std::error_code ignored;
        if (app.get_parent() == nullptr && std::filesystem::exists(word, ignored)) {
            return fmt::format("what shall be done with {}? \"lancer view {}\" shows it, \"lancer render {} -o picture.png\" renders it",
                               word, shell_quoted({word}), shell_quoted({word}));
        }
        return fmt::format("there is no subcommand {};{}", word, did_you_mean(word, subcommand_names(app)));
    }
    return fmt::format("nothing is known to do with \"{}\"", word);
}

std::string without_empty_hint(std::string sentence) {
    if (sentence.ends_with(';')) {
        sentence.pop_back();
    }
    return sentence;
}

}  // namespace

int refuse(const std::string& sentence, const CLI::App& app) {
    std::string name = app.get_name();
    for (const CLI::App* above = app.get_parent(); above != nullptr; above = above->get_parent()) {
        name = above->get_name() + " " + name;
    }
    fmt::print(stderr, "{}: error: {}\n", name, sentence);
    fmt::print(stderr, "\"{} --help\" tells what can be said\n", name);
    return exit_bad_input;
}

void print_diagnostics(const Diagnostics& diagnostics, bool quiet) {
    for (const Diagnostic& diagnostic : diagnostics.list()) {
        if (!quiet || diagnostic.severity != Severity::note) {
            fmt::print(stderr, "{}{}\n", diagnostic.position.file.empty() ? "lancer: " : "", to_string(diagnostic));
        }
    }
}

int run_command_line(const std::vector<std::string>& words) {
    Work work;
    CLI::App program(
        "lancer: a ray tracer whose pictures you can trust.\n"
        "Without a subcommand: a window with the report's picture, or lancer.png where there is no display.",
        "lancer");
    program.set_version_flag("--version", "lancer " LANCER_VERSION, "Print the version");
    program.set_help_flag("-h,--help", "Print this help");
    program.footer(
        "Example:\n  lancer render scenes/report/figure-1.toml --size 1920x1080 --ssaa 4 -o figure-1.png\n\n"
        "-help, -threads N and -render-all may be written with one dash or two.\n"
        "Exit status: 0 done, 1 stopped before its goal, 2 bad input or usage, 3 the machine failed.");
    program.get_formatter()->column_width(34);

    std::optional<int> threads;
    bool render_all = false;
    add_threads_option(program, threads);
    program.add_flag("--render-all", render_all, "Write every figure of the report, made anew, into the folder figures");
    add_view(program, work);
    add_render(program, work);
    add_resume(program, work);
    add_merge(program, work);
    add_reproduce(program, work);
    add_info(program, work);
    add_import(program, work);
    add_convert(program, work);
    add_compare(program, work);
    add_movie(program, work);
    add_farm(program, work);
    add_figures(program, work);
    add_schema(program, work);
    add_bench(program, work);
    program.require_subcommand(0, 1);
    program.allow_extras();
    for (CLI::App* sub : program.get_subcommands(nullptr)) {
        sub->allow_extras();
        for (CLI::App* part : sub->get_subcommands(nullptr)) {
            part->allow_extras();
        }
    }

    const auto chosen = [&]() -> const CLI::App& {
        const CLI::App* app = &program;
        while (!app->get_subcommands().empty()) {
            app = app->get_subcommands().front();
        }
        return *app;
    };
    try {
        std::vector<std::string> reversed = with_two_dashes(words);
        std::reverse(reversed.begin(), reversed.end());  // CLI11 takes them from the back
        program.parse(std::move(reversed));
    } catch (const CLI::Success& request) {  // --help, --version
        return program.exit(request) == 0 ? exit_done : exit_bad_input;
    } catch (const CLI::ArgumentMismatch& error) {
        const std::string sentence = error.what();
        return refuse(sentence.substr(0, sentence.find(':')) + " needs a value", chosen());
    } catch (const CLI::ParseError& error) {
        return refuse(error.what(), chosen());
    }
    if (const auto sentence = explain_leftovers(program)) {
        return refuse(without_empty_hint(*sentence), program);
    }
    for (const CLI::App* app = &chosen(); app != &program; app = app->get_parent()) {
        if (const auto sentence = explain_leftovers(*app)) {
            return refuse(without_empty_hint(*sentence), *app);
        }
    }
    if (work) {
        return render_all || threads ? refuse("--threads and --render-all go after the subcommand, or stand without one", program) : work();
    }
    if (render_all) {
        FiguresRequest request;
        request.threads = threads;
        return write_figures(request);
    }
    return show_default_scene(threads);
}

}  // namespace lancer::app
