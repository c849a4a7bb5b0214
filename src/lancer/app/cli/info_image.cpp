#include "lancer/app/cli/info_image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "lancer/app/exit_status.h"
#include "lancer/base/failure.h"
#include "lancer/image/layers.h"

namespace lancer::app {

namespace {

struct ChannelFacts {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    double mean = 0.0;      // of the finite values
    std::uint64_t bad = 0;  // not finite
};

ChannelFacts examine(const Channel& channel) {
    ChannelFacts facts;
    std::uint64_t good = 0;
    const auto add = [&](double value) {
        if (!std::isfinite(value)) {
            ++facts.bad;
            return;
        }
        facts.low = std::min(facts.low, value);
        facts.high = std::max(facts.high, value);
        facts.mean += value;
        ++good;
    };
    for (const float value : channel.values) {
        add(static_cast<double>(value));
    }
    for (const std::uint32_t value : channel.numbers) {
        add(static_cast<double>(value));
    }
    facts.mean = good > 0 ? facts.mean / static_cast<double>(good) : 0.0;
    return facts;
}

const char* word(Stored stored) { return stored == Stored::half ? "half" : stored == Stored::float32 ? "float" : "uint"; }

void print_text(const std::string& path, const LayeredImage& image) {
    const auto row = [](const std::string& name, const std::string& text) { fmt::print("{:<20} {}\n", name, text); };
    row("picture", path);
    row("size", fmt::format("{} x {}{}", image.width, image.height, image.display ? ", encoded for displays" : ""));
    row("channels", fmt::format("{}", image.channels.size()));
    for (const Channel& channel : image.channels) {
        const ChannelFacts facts = examine(channel);
        std::string text = image.display ? "" : fmt::format("{:<6}", word(channel.stored));
        text += facts.low <= facts.high ? fmt::format("{:.6g} to {:.6g}, mean {:.6g}", facts.low, facts.high, facts.mean) : "no value";
        if (facts.bad > 0) {
            text += fmt::format(", {} not a finite number", facts.bad);
        }
        row("  " + channel.name, text);
    }
    for (const auto& [key, value] : image.metadata) {
        row(key, value);
    }
}

nlohmann::ordered_json to_json(const std::string& path, const LayeredImage& image) {
    nlohmann::ordered_json json = {{"picture", path}, {"width", image.width}, {"height", image.height}, {"display", image.display}};
    json["channels"] = nlohmann::ordered_json::array();
    for (const Channel& channel : image.channels) {
        const ChannelFacts facts = examine(channel);
        json["channels"].push_back({{"name", channel.name},
                                    {"stored", word(channel.stored)},
                                    {"low", facts.low},
                                    {"high", facts.high},
                                    {"mean", facts.mean},
                                    {"not_finite", facts.bad}});
    }
    json["metadata"] = image.metadata;
    return json;
}

}  // namespace

int show_image_info(const std::string& path, bool as_json) {
    LayeredImage image;
    try {
        image = read_layers(path);
    } catch (const MachineFailure&) {
        throw;
    } catch (const std::runtime_error& problem) {
        fmt::print(stderr, "lancer: error: {}\n", problem.what());
        return exit_bad_input;
    }
    if (as_json) {
        fmt::print("{}\n", to_json(path, image).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    } else {
        print_text(path, image);
    }
    return exit_done;
}

}  // namespace lancer::app
