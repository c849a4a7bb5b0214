// Reads the keys of one table as its description says, and complains about everything that the description does not allow.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/import/toml/messages.h"
#include "lancer/import/toml/notation.h"

namespace lancer::notation {

// Which tables may stand inside besides the described keys.
struct Inside {
    std::span<const Section> sections = {};
    bool named_tables = false;  // any key that holds a table
};

// Each getter is for keys of one Kind. A key that is not written gives its default; a wrong value is an error and gives the default, too.
class TableReader {
public:
    // Complains about unknown keys and missing required ones.
    TableReader(Messages& messages, const toml::table& table, const Table& description, const Inside& inside = {});

    bool has(std::string_view key) const { return table_.contains(key); }
    // No complaint so far: checks that compare several values make sense.
    bool good() const { return good_; }
    void spoil() { good_ = false; }  // the complaint was made elsewhere
    // Of the key's value; of the table when it is not written.
    SourcePosition position(std::string_view key) const;
    SourcePosition position() const { return messages_.at(table_); }
    void error(const SourcePosition& position, std::string message);
    void error(std::string_view key, std::string message) { error(position(key), std::move(message)); }

    double number(std::string_view key);
    std::optional<double> number_if_written(std::string_view key);
    int integer(std::string_view key);
    bool flag(std::string_view key);
    std::string text(std::string_view key);    // of Kind::text and Kind::file
    std::size_t choice(std::string_view key);  // index into the key's words
    std::vector<std::size_t> choices(std::string_view key);
    glm::dvec2 vector2(std::string_view key);
    glm::dvec3 vector3(std::string_view key);
    glm::dvec3 direction(std::string_view key);  // of length 1
    glm::ivec2 size(std::string_view key);
    std::vector<glm::vec3> vectors3(std::string_view key);
    std::vector<glm::vec2> vectors2(std::string_view key);
    std::vector<glm::uvec3> triangles(std::string_view key);
    std::vector<double> numbers(std::string_view key);
    std::map<std::string, std::string> texts(std::string_view key);

    // For kinds that are read elsewhere: the value when it is written.
    const toml::node* value(std::string_view key, Kind kind) const;
    const Key& described(std::string_view key, Kind kind) const;
    const Table& description() const { return description_; }
    Messages& messages() { return messages_; }

private:
    void complain_about_unknown(const toml::key& key, const Inside& inside);

    Messages& messages_;
    const toml::table& table_;
    const Table& description_;
    bool good_ = true;
};

// The same for a value that is no table's. On a mistake: an error, and false or nothing.
bool read_number(Messages& messages, const toml::node& node, const Key& key, double& number);
// `count` numbers in a list; `example` tells what was expected.
bool read_numbers(Messages& messages, const toml::node& node, const Key& key, std::size_t count, std::string_view example, double* numbers);
// Length 1; nothing for a vector without length.
std::optional<glm::dvec3> unit_vector(const glm::dvec3& vector);

// `"a", "b" or "c"`
std::string alternatives(const std::vector<std::string_view>& words);

}  // namespace lancer::notation
