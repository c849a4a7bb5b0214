#include "lancer/app/cli/values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "lancer/base/diagnostic.h"

namespace lancer::app {

namespace {

// The name to speak of: the first long one.
std::string spoken(const std::string& names) {
    for (const std::string& name : CLI::detail::split(names, ',')) {
        if (name.starts_with("--")) {
            return name;
        }
    }
    return names;
}

// The whole text as a number, or nothing.
template <typename Number>
std::optional<Number> read_number(std::string_view text) {
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && !text.empty() ? std::optional(number) : std::nullopt;
}

CLI::Option* add(CLI::App& app, const std::string& names, const std::string& type, const std::string& description,
                 const std::function<void(const std::string&)>& read) {
    return app.add_option_function<std::string>(names, read, description)
        ->type_name(type)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

[[noreturn]] void refuse(const std::string& names, const std::string& expected, const std::string& text) {
    throw CLI::ValidationError(spoken(names), fmt::format("expected {}, not \"{}\"", expected, text));
}

}  // namespace

CLI::Option* add_whole(CLI::App& app, const std::string& names, std::optional<int>& value, int low, int high,
                       const std::string& description) {
    return add(app, names, "N", description, [=, &value](const std::string& text) {
        const std::optional<int> number = read_number<int>(text);
        if (!number || *number < low || *number > high) {
            refuse(names, fmt::format("a whole number from {} to {}", low, high), text);
        }
        value = *number;
    });
}

CLI::Option* add_real(CLI::App& app, const std::string& names, std::optional<double>& value, double low, double high,
                      const std::string& description) {
    return add(app, names, "X", description, [=, &value](const std::string& text) {
        const std::optional<double> number = read_number<double>(text);
        if (!number || !(*number >= low) || !(*number <= high)) {  // this way round for NaN
            refuse(names, fmt::format("a number from {} to {}", low, high), text);
        }
        value = *number;
    });
}

CLI::Option* add_choice(CLI::App& app, const std::string& names, std::optional<std::string>& value, const std::vector<std::string>& choices,
                        const std::string& description) {
    return add(app, names, CLI::detail::join(choices, "|"), description, [=, &value](const std::string& text) {
        if (std::find(choices.begin(), choices.end(), text) == choices.end()) {
            const std::string hint = did_you_mean(text, choices);
            throw CLI::ValidationError(spoken(names), fmt::format("expected {}, not \"{}\"{}", CLI::detail::join(choices, " or "), text,
                                                                  hint.empty() ? "" : ";" + hint));
        }
        value = text;
    });
}

CLI::Option* add_text(CLI::App& app, const std::string& names, std::optional<std::string>& value, const std::string& type,
                      const std::string& description) {
    return add(app, names, type, description, [=, &value](const std::string& text) {
        if (text.empty()) {
            refuse(names, "a name", text);
        }
        value = text;
    });
}

CLI::Option* add_percentage(CLI::App& app, const std::string& names, std::optional<double>& value, const std::string& description) {
    return add(app, names, "P%", description, [=, &value](const std::string& text) {
        const bool percent = text.ends_with('%');
        const std::optional<double> number = read_number<double>(text.substr(0, text.size() - (percent ? 1 : 0)));
        const double share = number.value_or(0.0) / (percent ? 100.0 : 1.0);
        if (!(share > 0.0) || !(share < 1.0)) {
            refuse(names, "a share above 0 and below 100%, as 1%", text);
        }
        value = share;
    });
}

CLI::Option* add_duration(CLI::App& app, const std::string& names, std::optional<double>& value, const std::string& description,
                          bool may_be_off) {
    return add(app, names, "TIME", description, [=, &value](const std::string& text) {
        if (may_be_off && text == "off") {
            value = 0.0;
            return;
        }
        const std::size_t digits = std::min(text.find_first_not_of("0123456789."), text.size());
        const std::string unit = text.substr(digits);
        const std::optional<double> number = read_number<double>(text.substr(0, digits));
        const double factor = unit == "ms"                   ? 1e-3
                              : unit.empty() || unit == "s"  ? 1.0
                              : unit == "m" || unit == "min" ? 60.0
                              : unit == "h"                  ? 3600.0
                                                             : 0.0;
        if (!number || !(*number * factor > 0.0) || *number * factor > 1e9) {
            refuse(names, fmt::format("a time, as 30s, 2m or 1h{}", may_be_off ? ", or off" : ""), text);
        }
        value = *number * factor;
    });
}

CLI::Option* add_positional(CLI::App& app, const std::string& name, std::optional<std::string>& value, const std::string& description) {
    return add(app, name, "", description, [&value](const std::string& text) { value = text; });
}

CLI::Option* add_size(CLI::App& app, const std::string& names, std::optional<ImageSize>& value, const std::string& description) {
    return add(app, names, "WxH", description, [=, &value](const std::string& text) {
        const std::size_t cross = std::min(text.find('x'), text.size());
        const int width = read_number<int>(text.substr(0, cross)).value_or(0);
        const int height = read_number<int>(text.substr(std::min(cross + 1, text.size()))).value_or(0);
        if (width < 1 || height < 1 || width > max_side || height > max_side) {
            refuse(names, fmt::format("width x height in pixels, as 1280x720, each from 1 to {}", max_side), text);
        }
        if (static_cast<long long>(width) * height > max_pixels) {
            refuse(names, fmt::format("at most {} million pixels", max_pixels / 1000000), text);
        }
        value = ImageSize{width, height};
    });
}

}  // namespace lancer::app
