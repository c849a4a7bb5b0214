#include "lancer/import/toml/table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/geometric.hpp>

namespace lancer::notation {

namespace {

// Squares and products of two lengths stay finite in single precision, and a length times itself does not vanish.
constexpr double longest = 1e15;   // metres
constexpr double shortest = 1e-9;  // metres

bool is_length(const Key& key) { return key.unit == "m"; }

std::string with_unit(const Key& key) { return key.unit.empty() ? std::string{} : fmt::format(" {}", key.unit); }

bool check_number(Messages& messages, const toml::node& node, const Key& key, double number) {
    const SourcePosition position = messages.at(node);
    if (!std::isfinite(number)) {
        messages.error(position, fmt::format("\"{}\" must be finite, not {}", key.name, number));
    } else if (!key.range.holds(number)) {
        messages.error(position, fmt::format("\"{}\" must be {}{}, not {}", key.name, to_words(key.range), with_unit(key), number));
    } else if (is_length(key) && std::abs(number) > longest) {
        messages.error(position, fmt::format("\"{}\" is too large: lengths may be up to {:g} m, not {}", key.name, longest, number));
    } else if (is_length(key) && key.range.least == 0.0 && number > 0.0 && number < shortest) {
        messages.error(position, fmt::format("\"{}\" is too small: lengths must be at least {:g} m, not {}", key.name, shortest, number));
    } else {
        return true;
    }
    return false;
}

template <class Vector, std::size_t count>
std::vector<Vector> read_list(TableReader& reader, std::string_view name, Kind kind, std::string_view example) {
    std::vector<Vector> list;
    const toml::node* node = reader.value(name, kind);
    if (!node) {
        return list;
    }
    const Key& key = reader.described(name, kind);
    const toml::array* array = node->as_array();
    if (!array) {
        reader.error(name, fmt::format("\"{}\" must be a list of {}, not {}", name, example, what_it_is(*node)));
        return list;
    }
    list.reserve(array->size());
    for (const toml::node& element : *array) {
        double numbers[count] = {};
        if (!read_numbers(reader.messages(), element, key, count, example, numbers)) {
            reader.spoil();
            continue;
        }
        Vector vector{};
        for (std::size_t i = 0; i < count; ++i) {
            vector[static_cast<int>(i)] = static_cast<typename Vector::value_type>(numbers[i]);
        }
        list.push_back(vector);
    }
    return list;
}

}  // namespace

bool read_number(Messages& messages, const toml::node& node, const Key& key, double& number) {
    if (const auto* integer = node.as_integer()) {
        number = static_cast<double>(integer->get());
    } else if (const auto* real = node.as_floating_point()) {
        number = real->get();
    } else {
        const std::string unit = key.unit.empty() ? "" : fmt::format(" ({})", key.unit);
        messages.error(messages.at(node), fmt::format("\"{}\" must be a number{}, not {}", key.name, unit, what_it_is(node)));
        return false;
    }
    return check_number(messages, node, key, number);
}

bool read_numbers(Messages& messages, const toml::node& node, const Key& key, std::size_t count, std::string_view example,
                  double* numbers) {
    const toml::array* array = node.as_array();
    if (!array) {
        messages.error(messages.at(node), fmt::format("\"{}\" must be {}, not {}", key.name, example, what_it_is(node)));
        return false;
    }
    if (array->size() != count) {
        messages.error(messages.at(node), fmt::format("\"{}\" must be {}: {} numbers, not {}", key.name, example, count, array->size()));
        return false;
    }
    const bool whole = key.kind == Kind::size || key.kind == Kind::triangles;
    bool good = true;
    for (std::size_t i = 0; i < count; ++i) {
        const toml::node& element = *array->get(i);
        if (whole && !element.is_integer()) {
            messages.error(messages.at(element), fmt::format("\"{}\" must be {} in whole numbers, not {}", key.name, example,
                                                             element.is_floating_point() ? "a fraction" : what_it_is(element)));
            good = false;
        } else {
            good = read_number(messages, element, key, numbers[i]) && good;
        }
    }
    return good;
}

std::optional<glm::dvec3> unit_vector(const glm::dvec3& vector) {
    const double largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
    if (!(largest > 0.0) || !std::isfinite(largest)) {
        return std::nullopt;
    }
    const double square = glm::dot(vector, vector);
    if (square > 1.0 - 1e-14 && square < 1.0 + 1e-14) {
        return vector;  // so that a direction that was written and read stays what it was
    }
    return glm::normalize(vector / largest);  // divided first: squares of the written numbers might overflow or vanish
}

std::string alternatives(const std::vector<std::string_view>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        text += fmt::format("{}\"{}\"", i == 0 ? "" : i + 1 == words.size() ? " or " : ", ", words[i]);
    }
    return text;
}

TableReader::TableReader(Messages& messages, const toml::table& table, const Table& description, const Inside& inside)
    : messages_(messages), table_(table), description_(description) {
    for (const auto& [key, value] : table) {
        const std::string_view word = key.str();
        const auto is_section = [word](const Section& section) { return section.name == word; };
        const bool known = description.find(word) || (inside.named_tables && value.is_table()) ||
                           std::any_of(inside.sections.begin(), inside.sections.end(), is_section);
        if (!known) {
            complain_about_unknown(key, inside);
        }
    }
    for (const Key& key : description.keys) {
        if (key.required && !has(key.name)) {
            error(position(), fmt::format("{} needs \"{}\"", description.what, key.name));
        }
    }
}

void TableReader::complain_about_unknown(const toml::key& key, const Inside& inside) {
    const std::string word(key.str());
    std::vector<std::string> names;
    for (const Key& known : description_.keys) {
        names.emplace_back(known.name);
    }
    for (const Section& section : inside.sections) {
        names.emplace_back(section.name);
    }
    std::string hint = did_you_mean(word, names);
    if (!hint.empty()) {
        hint = ";" + hint;
    } else {
        const auto same_name = [&](const Section& section) { return section.name == word; };
        const auto sections = file_sections();
        if (const auto section = std::find_if(sections.begin(), sections.end(), same_name); section != sections.end()) {
            hint = section->form == Form::color ? "; it belongs to the whole file: write it above the first [table]"
                                                : "; it belongs to the whole file";
        } else {
            hint = fmt::format("; it may have {}", fmt::join(names, ", "));
        }
    }
    error(messages_.at(key), fmt::format("{} has no \"{}\"{}", description_.what, word, hint));
}

SourcePosition TableReader::position(std::string_view key) const {
    const toml::node* node = table_.get(key);
    return node ? messages_.at(*node) : position();
}

void TableReader::error(const SourcePosition& position, std::string message) {
    good_ = false;
    messages_.error(position, std::move(message));
}

const Key& TableReader::described(std::string_view key, [[maybe_unused]] Kind kind) const {
    const Key* description = description_.find(key);
    assert(description && description->kind == kind);
    return *description;
}

const toml::node* TableReader::value(std::string_view key, Kind kind) const {
    described(key, kind);
    return table_.get(key);
}

std::optional<double> TableReader::number_if_written(std::string_view key) {
    const toml::node* node = value(key, Kind::number);
    double number = 0.0;
    if (!node) {
        return std::nullopt;
    }
    if (!read_number(messages_, *node, described(key, Kind::number), number)) {
        good_ = false;
        return std::nullopt;
    }
    return number;
}

double TableReader::number(std::string_view key) {
    const double* preset = std::get_if<double>(&described(key, Kind::number).preset);
    return number_if_written(key).value_or(preset ? *preset : 0.0);
}

int TableReader::integer(std::string_view key) {
    const Key& description = described(key, Kind::integer);
    const double* written = std::get_if<double>(&description.preset);
    const double preset = written ? *written : 0.0;
    const toml::node* node = value(key, Kind::integer);
    double number = preset;
    if (node && !node->is_integer()) {
        error(key, fmt::format("\"{}\" must be a whole number, not {}", key, node->is_floating_point() ? "a fraction" : what_it_is(*node)));
    } else if (node && !read_number(messages_, *node, description, number)) {
        good_ = false;
        number = preset;
    }
    return static_cast<int>(number);
}

bool TableReader::flag(std::string_view key) {
    const bool* const described_preset = std::get_if<bool>(&described(key, Kind::flag).preset);
    const bool preset = described_preset && *described_preset;  // none: what it is depends on other keys, and the caller knows
    const toml::node* node = value(key, Kind::flag);
    if (node && !node->is_boolean()) {
        error(key, fmt::format("\"{}\" must be true or false, not {}", key, what_it_is(*node)));
        return preset;
    }
    return node ? node->as_boolean()->get() : preset;
}

std::string TableReader::text(std::string_view key) {
    const toml::node* node = table_.get(key);
    if (!node) {
        return {};
    }
    const auto* string = node->as_string();
    if (!string) {
        error(key, fmt::format("\"{}\" must be text in quotes, not {}", key, what_it_is(*node)));
        return {};
    }
    if (string->get().empty()) {
        error(key, fmt::format("\"{}\" must not be empty", key));
    }
    return string->get();
}

std::size_t TableReader::choice(std::string_view key) {
    const Key& description = described(key, Kind::choice);
    const auto index_of = [&](std::string_view word) {
        return static_cast<std::size_t>(std::find(description.words.begin(), description.words.end(), word) - description.words.begin());
    };
    const std::string_view* word = std::get_if<std::string_view>(&description.preset);
    const std::size_t preset = word ? index_of(*word) : 0;
    const toml::node* node = value(key, Kind::choice);
    if (!node) {
        return preset;
    }
    const auto* string = node->as_string();
    const std::size_t index = string ? index_of(string->get()) : description.words.size();
    if (index == description.words.size()) {
        const std::string found = string ? fmt::format("\"{}\"", string->get()) : std::string(what_it_is(*node));
        error(key, fmt::format("\"{}\" must be {}, not {}", key, alternatives(description.words), found));
        return preset;
    }
    return index;
}

std::vector<std::size_t> TableReader::choices(std::string_view key) {
    const Key& description = described(key, Kind::choices);
    const toml::node* node = value(key, Kind::choices);
    if (!node) {
        return {};
    }
    const toml::array* list = node->as_array();
    if (!list) {
        error(key, fmt::format("\"{}\" must be a list of texts, not {}", key, what_it_is(*node)));
        return {};
    }
    std::vector<std::size_t> result;
    for (const toml::node& item : *list) {
        const auto* string = item.as_string();
        const auto found = string ? std::find(description.words.begin(), description.words.end(), string->get()) : description.words.end();
        if (found == description.words.end()) {
            const std::string hint = string ? did_you_mean(string->get(), {description.words.begin(), description.words.end()}) : "";
            error(messages_.at(item), fmt::format("\"{}\" takes {}, not {}{}", key, alternatives(description.words),
                                                  string ? fmt::format("\"{}\"", string->get()) : std::string(what_it_is(item)),
                                                  hint.empty() ? "" : ";" + hint));
        } else {
            result.push_back(static_cast<std::size_t>(found - description.words.begin()));
        }
    }
    return result;
}

glm::dvec2 TableReader::vector2(std::string_view key) {
    const Key& description = described(key, Kind::vector2);
    const glm::dvec2* preset = std::get_if<glm::dvec2>(&description.preset);
    glm::dvec2 vector(0.0);
    const toml::node* node = value(key, Kind::vector2);
    if (node && read_numbers(messages_, *node, description, 2, "two numbers [u, v]", &vector.x)) {
        return vector;
    }
    good_ = good_ && !node;
    return preset ? *preset : glm::dvec2(0.0);
}

glm::dvec3 TableReader::vector3(std::string_view key) {
    const Key& description = described(key, Kind::vector3);
    const glm::dvec3* preset = std::get_if<glm::dvec3>(&description.preset);
    glm::dvec3 vector(0.0);
    const toml::node* node = value(key, Kind::vector3);
    if (node && read_numbers(messages_, *node, description, 3, "three numbers [x, y, z]", &vector.x)) {
        return vector;
    }
    good_ = good_ && !node;
    return preset ? *preset : glm::dvec3(0.0);
}

glm::dvec3 TableReader::direction(std::string_view key) {
    const Key& description = described(key, Kind::direction);
    const glm::dvec3* preset = std::get_if<glm::dvec3>(&description.preset);
    const toml::node* node = value(key, Kind::direction);
    if (node) {
        glm::dvec3 vector(0.0);
        if (!read_numbers(messages_, *node, description, 3, "three numbers [x, y, z]", &vector.x)) {
            good_ = false;
        } else if (const auto unit = unit_vector(vector)) {
            return *unit;
        } else {
            error(key, fmt::format("\"{}\" must have a length: [0, 0, 0] points nowhere", key));
        }
    }
    return preset ? *preset : glm::dvec3(0.0, 1.0, 0.0);
}

glm::ivec2 TableReader::size(std::string_view key) {
    const Key& description = described(key, Kind::size);
    const glm::dvec2 preset = std::get<glm::dvec2>(description.preset);
    glm::dvec2 numbers(0.0);
    const toml::node* node = value(key, Kind::size);
    if (!node || !read_numbers(messages_, *node, description, 2, "[width, height]", &numbers.x)) {
        good_ = good_ && !node;
        numbers = preset;
    }
    return glm::ivec2(numbers);
}

std::vector<glm::vec3> TableReader::vectors3(std::string_view key) {
    return read_list<glm::vec3, 3>(*this, key, Kind::vectors3, "three numbers [x, y, z]");
}

std::vector<glm::vec2> TableReader::vectors2(std::string_view key) {
    return read_list<glm::vec2, 2>(*this, key, Kind::vectors2, "two numbers [u, v]");
}

std::vector<double> TableReader::numbers(std::string_view key) {
    std::vector<double> all;
    const toml::node* node = value(key, Kind::numbers);
    const toml::array* array = node ? node->as_array() : nullptr;
    if (node && !array) {
        error(key, fmt::format("\"{}\" must be a list of numbers, not {}", key, what_it_is(*node)));
    }
    for (std::size_t i = 0; array && i < array->size(); ++i) {
        double number = 0.0;
        good_ = read_number(messages_, *array->get(i), described(key, Kind::numbers), number) && good_;
        all.push_back(number);
    }
    return all;
}

std::map<std::string, std::string> TableReader::texts(std::string_view key) {
    std::map<std::string, std::string> all;
    const toml::node* node = value(key, Kind::texts);
    const toml::table* table = node ? node->as_table() : nullptr;
    if (node && !table) {
        error(key, fmt::format("\"{}\" must be texts with their names, {{ name = \"text\" }}, not {}", key, what_it_is(*node)));
    }
    for (const auto& [name, item] : table ? *table : toml::table()) {
        if (const auto* text = item.as_string()) {
            all[std::string(name.str())] = text->get();
        } else {
            error(messages_.at(item), fmt::format("\"{}\" must be text in quotes, not {}", name.str(), what_it_is(item)));
        }
    }
    return all;
}

std::vector<glm::uvec3> TableReader::triangles(std::string_view key) {
    return read_list<glm::uvec3, 3>(*this, key, Kind::triangles, "three corners [a, b, c]");
}

}  // namespace lancer::notation
