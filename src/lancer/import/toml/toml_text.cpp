#include "lancer/import/toml/toml_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

namespace lancer::notation {

namespace {

// How many bytes the UTF-8 character at the front has; 0 where it is none.
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    const std::size_t length = first < 0x80                    ? 1
                               : first >= 0xc2 && first < 0xe0 ? 2
                               : first >= 0xe0 && first < 0xf0 ? 3
                               : first >= 0xf0 && first < 0xf5 ? 4
                                                               : 0;
    if (length == 0 || length > text.size()) {
        return 0;
    }
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80) {
            return 0;
        }
    }
    const unsigned second = length > 1 ? byte(1) : 0;
    const bool is_longer_than_needed = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool is_no_character = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
    return is_longer_than_needed || is_no_character ? 0 : length;
}

bool is_bare(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-'; }

}  // namespace

std::string number_text(double number) {
    std::string text = fmt::format("{}", number);
    return text == "-0" ? "-0.0" : text;  // whole numbers have no sign of zero
}

std::string quoted_text(std::string_view text) {
    std::string quoted = "\"";
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        const char c = text.front();
        if (length == 0) {
            quoted += '?';
        } else if (length > 1) {
            quoted += text.substr(0, length);
        } else if (c == '"' || c == '\\') {
            quoted += {'\\', c};
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            quoted += c;
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return quoted + '"';
}

std::string key_text(std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), is_bare) ? std::string(name) : quoted_text(name);
}

std::string list_text(const std::vector<double>& numbers) {
    std::string text = "[";
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        text += (i == 0 ? "" : ", ") + number_text(numbers[i]);
    }
    return text + "]";
}

std::string list_text(const glm::dvec2& v) { return list_text(std::vector<double>{v.x, v.y}); }
std::string list_text(const glm::dvec3& v) { return list_text(std::vector<double>{v.x, v.y, v.z}); }

void Fields::number(std::string_view key, double value, double preset) {
    if (value != preset) {
        number(key, value);
    }
}

void Fields::flag(std::string_view key, bool value, bool preset) {
    if (value != preset) {
        raw(key, value ? "true" : "false");
    }
}

void Fields::text(std::string_view key, std::string_view value, std::string_view preset) {
    if (value != preset) {
        text(key, value);
    }
}

void Fields::vector(std::string_view key, const glm::dvec2& value, const glm::dvec2& preset) {
    if (value != preset) {
        raw(key, list_text(value));
    }
}

void Fields::vector(std::string_view key, const glm::dvec3& value, const glm::dvec3& preset) {
    if (value != preset) {
        vector(key, value);
    }
}

std::string Fields::lines() const {
    std::string text;
    for (const Field& field : list_) {
        text += field.key + " = " + field.toml + "\n";
    }
    return text;
}

std::string Fields::braces() const {
    std::string text = "{ ";
    for (std::size_t i = 0; i < list_.size(); ++i) {
        text += (i == 0 ? "" : ", ") + list_[i].key + " = " + list_[i].toml;
    }
    return text + " }";
}

}  // namespace lancer::notation
