#include "lancer/import/mitsuba/xml.h"

#include <algorithm>

#include <fmt/format.h>

namespace lancer::mitsuba {

namespace {

// Many exporters leave the byte order mark of UTF-8 at the beginning.
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

}  // namespace

std::optional<Xml> Xml::parse(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark) {
        text.remove_prefix(byte_order_mark.size());
    }
    std::optional<Xml> xml(std::in_place);
    xml->file_ = file;
    xml->size_ = text.size();
    xml->lines_.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n') {
            xml->lines_.push_back(i + 1);
        }
    }
    const pugi::xml_parse_result result = xml->document_.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result) {
        diagnostics.error(xml->position(result.offset), fmt::format("no well-formed XML: {}", result.description()));
        return std::nullopt;
    }
    if (!xml->root()) {
        diagnostics.error({file, 1, 1}, "expected a <scene>, found nothing");
        return std::nullopt;
    }
    return xml;
}

SourcePosition Xml::position(const pugi::xml_node& node) const { return position(std::max<std::ptrdiff_t>(0, node.offset_debug() - 1)); }

SourcePosition Xml::position(std::ptrdiff_t offset) const {
    const std::size_t at = std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, offset)), size_);
    const auto line = std::upper_bound(lines_.begin(), lines_.end(), at) - 1;
    return {file_, static_cast<int>(line - lines_.begin()) + 1, static_cast<int>(at - *line) + 1};
}

}  // namespace lancer::mitsuba
