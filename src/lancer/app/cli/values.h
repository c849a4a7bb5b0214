// Options whose values are checked as they are read; a bad one is explained in a sentence.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace lancer::app {

struct ImageSize {
    int width = 0;
    int height = 0;
};

constexpr int max_side = 65536;
constexpr long long max_pixels = 1LL << 28;

// When an option is given twice the last one counts. `names` as CLI11 takes them: "-o,--output".
CLI::Option* add_whole(CLI::App& app, const std::string& names, std::optional<int>& value, int low, int high,
                       const std::string& description);
CLI::Option* add_real(CLI::App& app, const std::string& names, std::optional<double>& value, double low, double high,
                      const std::string& description);
CLI::Option* add_choice(CLI::App& app, const std::string& names, std::optional<std::string>& value, const std::vector<std::string>& choices,
                        const std::string& description);
CLI::Option* add_positional(CLI::App& app, const std::string& name, std::optional<std::string>& value, const std::string& description);
CLI::Option* add_text(CLI::App& app, const std::string& names, std::optional<std::string>& value, const std::string& type,
                      const std::string& description);
// A share: "1%", "0.5%", "0.01".
CLI::Option* add_percentage(CLI::App& app, const std::string& names, std::optional<double>& value, const std::string& description);
// Seconds: "30s", "2m", "1.5h", "500ms", "30". 0 stands for "off" where that may be said.
CLI::Option* add_duration(CLI::App& app, const std::string& names, std::optional<double>& value, const std::string& description,
                          bool may_be_off = false);
CLI::Option* add_size(CLI::App& app, const std::string& names, std::optional<ImageSize>& value, const std::string& description);

}  // namespace lancer::app
