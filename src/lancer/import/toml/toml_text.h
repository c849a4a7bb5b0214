// TOML as text: whoever reads a number gets the same bits again.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lancer::notation {

// The shortest digits that mean this number and no other.
std::string number_text(double number);
// In quotes. Bytes that are no UTF-8 become question marks: TOML has no way to say them.
std::string quoted_text(std::string_view text);
// A name as it stands in a header: with quotes where it needs some.
std::string key_text(std::string_view name);
std::string list_text(const std::vector<double>& numbers);
std::string list_text(const glm::dvec2& v);
std::string list_text(const glm::dvec3& v);

// Keys with their values, of a table that is written below a header or in braces. With a preset, what equals it is left out.
class Fields {
public:
    void raw(std::string_view key, std::string toml) { list_.push_back({std::string(key), std::move(toml)}); }
    void number(std::string_view key, double value) { raw(key, number_text(value)); }
    void number(std::string_view key, double value, double preset);
    void flag(std::string_view key, bool value, bool preset);
    void text(std::string_view key, std::string_view value) { raw(key, quoted_text(value)); }
    void text(std::string_view key, std::string_view value, std::string_view preset);
    void vector(std::string_view key, const glm::dvec2& value, const glm::dvec2& preset);
    void vector(std::string_view key, const glm::dvec3& value) { raw(key, list_text(value)); }
    void vector(std::string_view key, const glm::dvec3& value, const glm::dvec3& preset);

    bool empty() const { return list_.empty(); }
    std::string lines() const;   // key = value, one a line
    std::string braces() const;  // { key = value, ... }

private:
    struct Field {
        std::string key;
        std::string toml;
    };
    std::vector<Field> list_;
};

}  // namespace lancer::notation
