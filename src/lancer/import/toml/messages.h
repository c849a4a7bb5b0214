// Diagnostics that know where a TOML value stands.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "lancer/base/diagnostic.h"

namespace lancer::notation {

// Stops listing after a few hundred errors: a broken file of a million lines is not worth a million messages.
class Messages {
public:
    Messages(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

    SourcePosition at(const toml::source_region& source) const;
    SourcePosition at(const toml::node& node) const { return at(node.source()); }
    SourcePosition at(const toml::key& key) const { return at(key.source()); }

    void error(const SourcePosition& position, std::string message);
    void warning(const SourcePosition& position, std::string message) { diagnostics_.warning(position, std::move(message)); }
    void note(const SourcePosition& position, std::string message) { diagnostics_.note(position, std::move(message)); }

    bool full() const;  // no error will be listed any more: no need to find good words for it

    const std::string& file() const { return file_; }
    Diagnostics& diagnostics() { return diagnostics_; }

private:
    std::string file_;
    Diagnostics& diagnostics_;
    int errors_ = 0;
};

// "a number", "a string", ...: what a value is, for people.
std::string_view what_it_is(const toml::node& node);

// The first few of many names: "a, b, c and 5 more".
std::string some_of(const std::vector<std::string>& names);

}  // namespace lancer::notation
