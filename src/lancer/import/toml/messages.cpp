#include "lancer/import/toml/messages.h"

namespace lancer::notation {

namespace {
constexpr int most_errors = 100;
}

SourcePosition Messages::at(const toml::source_region& source) const {
    return {file_, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

void Messages::error(const SourcePosition& position, std::string message) {
    ++errors_;
    if (errors_ <= most_errors) {
        diagnostics_.error(position, std::move(message));
    } else if (errors_ == most_errors + 1) {
        diagnostics_.error({file_, 0, 0}, "too many errors; the rest is not listed");
    }
}

bool Messages::full() const { return errors_ > most_errors; }

std::string_view what_it_is(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "a list";
        case toml::node_type::string:
            return "a string";
        case toml::node_type::integer:
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "true or false";
        case toml::node_type::date:
        case toml::node_type::time:
        case toml::node_type::date_time:
            return "a date or time";
        case toml::node_type::none:
            break;
    }
    return "nothing";
}

std::string some_of(const std::vector<std::string>& names) {
    constexpr std::size_t most = 20;
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < most; ++i) {
        text += (i == 0 ? "" : ", ") + names[i];
    }
    return names.size() > most ? text + " and " + std::to_string(names.size() - most) + " more" : text;
}

}  // namespace lancer::notation
