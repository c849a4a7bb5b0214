#include "lancer/app/cli/compare_output.h"

#include <cctype>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "lancer/app/cli/outputs.h"
#include "lancer/image/magma.h"

namespace lancer::app {

namespace {

using Json = nlohmann::ordered_json;

std::string group_in_words(const std::vector<std::string>& files) {
    return files.size() == 1 ? files.front() : fmt::format("{} runs ({}, ...)", files.size(), files.front());
}

std::string short_number(double value) { return value == 0.0 ? "0" : fmt::format("{:.4g}", value); }

void print_row(const std::string& name, const std::vector<std::string>& cells) {
    std::string line = fmt::format("{:<11}", name);
    for (const std::string& cell : cells) {
        line += fmt::format(" {:>11}", cell);
    }
    fmt::print("{}\n", line);
}

// Columns are channels and their mean, as long as they fit on a line.
void print_errors(const Comparison& comparison) {
    constexpr std::size_t most_columns = 4;
    std::vector<std::string> names;
    std::vector<ChannelErrors> columns;
    for (const ChannelComparison& color : comparison.colors) {
        if (comparison.colors.size() <= most_columns) {
            names.push_back(color.name);
            columns.push_back(color.errors);
        }
    }
    if (columns.size() != 1) {
        names.push_back("all");
        columns.push_back(comparison.all);
    }
    print_row("", names);
    const auto row = [&](const char* name, auto value) {
        std::vector<std::string> cells;
        for (const ChannelErrors& errors : columns) {
            cells.push_back(value(errors));
        }
        print_row(name, cells);
    };
    row("mean", [](const ChannelErrors& e) { return short_number(e.mean); });
    row("reference", [](const ChannelErrors& e) { return short_number(e.reference_mean); });
    row("bias", [](const ChannelErrors& e) {
        return e.reference_mean != 0.0 ? fmt::format("{:+.3f} %", 100.0 * e.bias / std::fabs(e.reference_mean)) : short_number(e.bias);
    });
    row("MSE", [](const ChannelErrors& e) { return short_number(e.mse); });
    row("relMSE", [](const ChannelErrors& e) { return short_number(e.rel_mse); });
    row("MAE", [](const ChannelErrors& e) { return short_number(e.mae); });
    row("largest", [](const ChannelErrors& e) { return short_number(e.largest); });
}

void print_bias(const Comparison& comparison) {
    if (comparison.bias.empty()) {
        return;
    }
    fmt::print("\n{:<11} {:>11} {:>11} {:>11} {:>11} {:>11}\n", "noise", "p of means", "p of blocks", "worst z", "at", "|z| > 1.96");
    for (const BiasTest& test : comparison.bias) {
        fmt::print("{:<11} {:>11.3g}", test.name, test.means.p);
        if (test.blocks) {
            fmt::print(" {:>11.3g} {:>+11.2f} {:>11} {:>9.1f} %", test.blocks->worst_p, test.blocks->worst_z,
                       fmt::format("{},{}", test.blocks->worst_x, test.blocks->worst_y), 100.0 * test.blocks->share_beyond_95);
        }
        fmt::print("\n");
    }
    if (comparison.picture_is_exact || comparison.reference_is_exact) {
        fmt::print("The {} counts as exact: it has neither several runs nor variances.\n",
                   comparison.picture_is_exact ? "picture" : "reference");
    }
}

Json cells_as_json(const CellTests& cells) {
    return {{"side", cells.side},
            {"tested", cells.tested},
            {"share_beyond_95", cells.share_beyond_95},
            {"chi2", cells.chi2},
            {"chi2_p", cells.chi2_p},
            {"worst_z", cells.worst_z},
            {"worst_p", cells.worst_p},
            {"worst_at", {cells.worst_x, cells.worst_y}}};
}

Json errors_as_json(const ChannelErrors& errors) {
    return {{"mean", errors.mean},       {"reference_mean", errors.reference_mean},
            {"bias", errors.bias},       {"mse", errors.mse},
            {"relmse", errors.rel_mse},  {"mae", errors.mae},
            {"largest", errors.largest}, {"skipped", errors.skipped}};
}

Metadata plus(Metadata metadata, const std::string& key, const std::string& value) {
    metadata[key] = value;
    return metadata;
}

}  // namespace

void print_comparison(const ComparedFiles& files, const Comparison& comparison, const ComparisonOptions& options,
                      const std::vector<Limit>& limits) {
    fmt::print("{:<11} {}\n", "picture", group_in_words(files.pictures));
    fmt::print("{:<11} {}\n", "reference", group_in_words(files.references));
    fmt::print("{:<11} {} x {} pixels\n\n", "size", comparison.width, comparison.height);
    print_errors(comparison);
    if (comparison.flip) {
        fmt::print("{:<11} {:>11}", "FLIP", short_number(comparison.flip->mean()));
        if (comparison.exposures) {
            fmt::print("   ({} exposures, {:+.1f} to {:+.1f} stops)\n", comparison.exposures->count, comparison.exposures->first,
                       comparison.exposures->last);
        } else {
            fmt::print("   (as displays show it)\n");
        }
    }
    if (comparison.psnr) {
        fmt::print("{:<11} {:>8.2f} dB   (of the encoded values)\n", "PSNR", *comparison.psnr);
    }
    print_bias(comparison);
    for (std::size_t i = 0; i < comparison.others.size(); ++i) {
        const auto& [name, errors] = comparison.others[i];
        fmt::print("{}{:<20} MSE {:<11} MAE {:<11} largest {}\n", i == 0 ? "\n" : "", name, short_number(errors.mse),
                   short_number(errors.mae), short_number(errors.largest));
    }
    if (comparison.others.empty() && comparison.more_channels > 0) {
        fmt::print("\n{} more channels are in both; --channels compares them, too.\n", comparison.more_channels);
    }
    if (comparison.all.skipped > 0) {
        fmt::print("\nwarning: {} values are infinite or no number, and were left out\n", comparison.all.skipped);
    }
    const std::string said = verdict(comparison, options);
    fmt::print("\n{}{}.\n", static_cast<char>(std::toupper(said.front())), said.substr(1));
    for (const Limit& limit : limits) {
        if (limit.fails()) {
            fmt::print("{} is {}, more than the {} that is allowed.\n", limit.name, short_number(limit.found), short_number(limit.limit));
        }
    }
}

std::string comparison_as_json(const ComparedFiles& files, const Comparison& comparison, const ComparisonOptions& options,
                               const std::vector<Limit>& limits) {
    Json json = {
        {"pictures", files.pictures}, {"references", files.references}, {"width", comparison.width}, {"height", comparison.height}};
    json["all"] = errors_as_json(comparison.all);
    for (const auto* list : {&comparison.colors, &comparison.others}) {
        for (const ChannelComparison& channel : *list) {
            json["channels"][channel.name] = errors_as_json(channel.errors);
        }
    }
    if (comparison.flip) {
        json["flip"] = {{"mean", comparison.flip->mean()}, {"kind", comparison.exposures ? "hdr" : "ldr"}};
        if (comparison.exposures) {
            json["flip"]["exposures"] = {comparison.exposures->first, comparison.exposures->last, comparison.exposures->count};
        }
    }
    if (comparison.psnr && std::isfinite(*comparison.psnr)) {
        json["psnr"] = *comparison.psnr;
    }
    for (const BiasTest& test : comparison.bias) {
        Json& entry = json["bias"][test.name];
        entry = {{"difference", test.means.difference}, {"error", test.means.error}, {"p", test.means.p}};
        if (std::isfinite(test.means.freedom)) {
            entry["freedom"] = test.means.freedom;
        }
        if (test.pixels && test.blocks) {
            entry["pixels"] = cells_as_json(*test.pixels);
            entry["blocks"] = cells_as_json(*test.blocks);
        }
    }
    if (!comparison.bias.empty()) {
        json["p"] = comparison.headline_p;
        json["blocks_p"] = comparison.worst_block_p;
    }
    json["verdict"] = verdict(comparison, options);
    json["limits"] = Json::array();
    for (const Limit& limit : limits) {
        json["limits"].push_back({{"name", limit.name}, {"limit", limit.limit}, {"found", limit.found}, {"kept", !limit.fails()}});
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

void write_flip_image(const std::string& path, const FlipMap& map, const Metadata& metadata) {
    const Metadata described = plus(metadata, "lancer:content", "FLIP, 0 to 1");
    if (is_linear(path)) {
        write_image(path, Image{map.width, map.height, 1, map.values}, described);
        return;
    }
    ByteImage image{map.width, map.height, 3, {}};
    image.pixels.reserve(map.values.size() * 3);
    for (const float value : map.values) {
        const auto color = magma(value);
        image.pixels.insert(image.pixels.end(), color.begin(), color.end());
    }
    write_image(path, image, described);
}

void write_error_image(const std::string& path, const Comparison& comparison, const Metadata& metadata) {
    const std::vector<float>&a = comparison.mean.pixels, &b = comparison.reference_mean.pixels;
    if (is_linear(path)) {
        Image image{comparison.width, comparison.height, 3, a};
        for (std::size_t i = 0; i < a.size(); ++i) {
            image.pixels[i] -= b[i];
        }
        write_image(path, image, plus(metadata, "lancer:content", "the difference of two pictures"));
        return;
    }
    ByteImage image{comparison.width, comparison.height, 3, {}};
    image.pixels.reserve(a.size());
    for (std::size_t i = 0; i < a.size(); i += 3) {
        float sum = 0.0f;
        for (std::size_t c = i; c < i + 3; ++c) {
            sum += std::fabs(a[c] - b[c]) / (std::fabs(b[c]) + 0.01f);
        }
        const auto color = magma(sum / 3.0f);
        image.pixels.insert(image.pixels.end(), color.begin(), color.end());
    }
    write_image(path, image, plus(metadata, "lancer:content", "relative difference, 0 to 1"));
}

}  // namespace lancer::app
