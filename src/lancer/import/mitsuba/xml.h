// XML text to its tree, with lines and columns. Entities are not expanded but for XML's own five, and nothing outside the text is read.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "lancer/base/diagnostic.h"

namespace lancer::mitsuba {

class Xml {
public:
    // `file` is for messages. What is not well-formed is an error, and then there is no tree.
    static std::optional<Xml> parse(std::string_view text, const std::string& file, Diagnostics& diagnostics);

    pugi::xml_node root() const { return document_.document_element(); }
    // Of a node's tag.
    SourcePosition position(const pugi::xml_node& node) const;

private:
    SourcePosition position(std::ptrdiff_t offset) const;

    std::string file_;
    std::size_t size_ = 0;
    std::vector<std::size_t> lines_;  // where each begins
    pugi::xml_document document_;
};

}  // namespace lancer::mitsuba
