// JSON as a flat tree whose values know where they stand [RFC 8259]. Strings without escapes point into the text, so a data URI costs nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lancer::gltf {

enum class JsonKind : std::uint8_t { null, boolean, number, string, array, object };

struct JsonValue {
    std::string_view key;     // in the object around it; empty in arrays
    std::string_view text;    // of strings, UTF-8
    double number = 0.0;      // of numbers; 0 or 1 of booleans
    std::uint64_t byte = 0;   // where it begins in the text
    std::uint32_t after = 0;  // index of the first value that is not inside this one
    std::uint32_t count = 0;  // of what an array or object holds
    JsonKind kind = JsonKind::null;
};

class JsonTree;

// A value of a tree, or nothing; nothing has no members and is of no kind. Cheap to copy; valid as long as its tree.
class Json {
public:
    Json() = default;
    Json(const JsonTree* tree, std::uint32_t index) : tree_(tree), index_(index) {}

    explicit operator bool() const { return tree_ != nullptr; }
    bool is(JsonKind kind) const { return tree_ != nullptr && value().kind == kind; }
    const JsonValue& value() const;
    std::uint32_t index() const { return index_; }

    // Of objects: the member of that name. Takes time in proportion to the number of members.
    Json operator[](std::string_view key) const;

    // The member's value, or the other one where there is no such member of that kind.
    double number(std::string_view key, double otherwise) const;
    std::string_view text(std::string_view key, std::string_view otherwise = {}) const;
    bool truth(std::string_view key, bool otherwise) const;
    std::optional<std::size_t> natural(std::string_view key) const;  // whole and not negative
    std::vector<double> numbers(std::string_view key) const;

    // Over the values of an array or object.
    class Iterator {
    public:
        Iterator(const JsonTree* tree, std::uint32_t index) : tree_(tree), index_(index) {}
        Json operator*() const { return {tree_, index_}; }
        Iterator& operator++();
        bool operator!=(const Iterator& other) const { return index_ != other.index_; }

    private:
        const JsonTree* tree_;
        std::uint32_t index_;
    };
    Iterator begin() const;
    Iterator end() const;
    std::size_t size() const { return tree_ == nullptr ? 0 : value().count; }

private:
    const JsonTree* tree_ = nullptr;
    std::uint32_t index_ = 0;
};

struct JsonProblem {
    std::uint64_t byte = 0;
    std::string message;
};

class JsonTree {
public:
    // `text` must outlive the tree. False and the problem when it is no JSON, is nested more than 100 deep or holds more than 8 million values.
    bool parse(std::string_view text, JsonProblem& problem);

    Json root() const { return values_.empty() ? Json() : Json(this, 0); }
    const std::vector<JsonValue>& values() const { return values_; }
    std::string_view text() const { return text_; }

    // "/meshes/0/primitives": where the value stands in the tree [RFC 6901].
    std::string pointer_to(Json json) const;

private:
    friend class JsonParser;
    std::string_view text_;
    std::vector<JsonValue> values_;
    std::deque<std::string> unescaped_;
};

}  // namespace lancer::gltf
