#include "lancer/import/ply/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace lancer::ply {

int Element::find(std::string_view property) const {
    for (std::size_t i = 0; i < properties.size(); ++i) {
        if (properties[i].name == property) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

bool Element::has_lists() const {
    return std::any_of(properties.begin(), properties.end(), [](const Property& p) { return p.is_list; });
}

std::size_t Element::smallest_size() const {
    std::size_t size = 0;
    for (const Property& property : properties) {
        size += size_of(property.is_list ? property.count_type : property.type);
    }
    return size;
}

namespace {

struct TypeName {
    std::string_view name;
    Type type;
};

constexpr TypeName type_names[] = {
    {"char", Type::int8},     {"int8", Type::int8},       {"uchar", Type::uint8},    {"uint8", Type::uint8},
    {"short", Type::int16},   {"int16", Type::int16},     {"ushort", Type::uint16},  {"uint16", Type::uint16},
    {"int", Type::int32},     {"int32", Type::int32},     {"uint", Type::uint32},    {"uint32", Type::uint32},
    {"float", Type::float32}, {"float32", Type::float32}, {"double", Type::float64}, {"float64", Type::float64}};

// Nobody needs more, and looking names up stays quick.
constexpr std::size_t most_elements = 64;
constexpr std::size_t most_properties = 1024;

class HeaderReader {
public:
    HeaderReader(std::string_view bytes, MeshMessages& messages) : bytes_(bytes), messages_(messages) {}

    std::optional<Header> run() {
        if (!next_line() || word() != "ply") {
            messages_.error(1, 1, "this is no PLY file: it does not begin with \"ply\"");
            return std::nullopt;
        }
        while (next_line()) {
            const std::string_view keyword = word();
            if (keyword == "end_header") {
                finish();
                return messages_.has_errors() ? std::nullopt : std::optional(std::move(header_));
            }
            if (keyword == "format") {
                format();
            } else if (keyword == "element") {
                element();
            } else if (keyword == "property") {
                property();
            } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
                error(fmt::format("expected format, element, property, comment or end_header, not {}", quoted(keyword)));
            }
            if (messages_.has_too_many_errors()) {
                return std::nullopt;
            }
        }
        messages_.error(header_.lines, 0, "the header has no end_header");
        return std::nullopt;
    }

private:
    // Lines end with \n or \r\n, or all with a lone \r, which the first one tells. So data that begin with \n are not mistaken for a line's end.
    bool next_line() {
        if (header_.size >= bytes_.size()) {
            return false;
        }
        if (header_.lines == 0) {
            const std::size_t first = bytes_.find_first_of("\r\n");
            if (first != std::string_view::npos && bytes_[first] == '\r' && bytes_.substr(first, 2) != "\r\n") {
                line_end_ = '\r';
            }
        }
        const std::size_t end = std::min(bytes_.find(line_end_, header_.size), bytes_.size());
        line_ = bytes_.substr(header_.size, end - header_.size);
        if (line_.ends_with('\r')) {
            line_.remove_suffix(1);
        }
        at_ = 0;
        header_.size = std::min(end + 1, bytes_.size());
        ++header_.lines;
        return true;
    }

    std::string_view word() {
        const std::size_t begin = std::min(line_.find_first_not_of(" \t", at_), line_.size());
        const std::size_t end = std::min(line_.find_first_of(" \t", begin), line_.size());
        at_ = end;
        word_column_ = static_cast<int>(begin) + 1;
        return line_.substr(begin, end - begin);
    }

    void error(std::string message) { messages_.error(header_.lines, word_column_, std::move(message)); }

    void format() {
        const std::string_view name = word();
        if (name == "ascii") {
            header_.format = Format::ascii;
        } else if (name == "binary_little_endian") {
            header_.format = Format::little_endian;
        } else if (name == "binary_big_endian") {
            header_.format = Format::big_endian;
        } else {
            return error(fmt::format("the format must be ascii, binary_little_endian or binary_big_endian, not {}", quoted(name)));
        }
        has_format_ = true;
        if (const std::string_view version = word(); version != "1.0") {
            error(fmt::format("the version must be 1.0, not {}", quoted(version)));
        }
    }

    void element() {
        Element element;
        element.name = word();
        element.line = header_.lines;
        const auto same = [&](const Element& other) { return other.name == element.name; };
        if (std::any_of(header_.elements.begin(), header_.elements.end(), same)) {
            error(fmt::format("a second element {}", quoted(element.name)));
        }
        const std::string_view count = word();
        const auto [stop, problem] = std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (problem != std::errc{} || stop != count.data() + count.size()) {
            error(fmt::format("expected how many {} there are, not {}", quoted(element.name), quoted(count)));
        }
        if (header_.elements.size() == most_elements) {
            return error(fmt::format("too many elements: at most {}", most_elements));
        }
        header_.elements.push_back(std::move(element));
    }

    bool type(Type& result) {
        const std::string_view name = word();
        for (const TypeName& known : type_names) {
            if (known.name == name) {
                result = known.type;
                return true;
            }
        }
        error(fmt::format("unknown type {}; the types are char, uchar, short, ushort, int, uint, float, double and list", quoted(name)));
        return false;
    }

    void property() {
        if (header_.elements.empty()) {
            return error("a property before the first element");
        }
        Property property;
        const std::size_t begin = at_;
        if (word() == "list") {
            property.is_list = true;
            if (!type(property.count_type)) {
                return;
            }
            if (!is_whole(property.count_type)) {
                return error("the length of a list must have a whole type");
            }
        } else {
            at_ = begin;
        }
        if (!type(property.type)) {
            return;
        }
        property.name = word();
        if (header_.elements.back().properties.size() == most_properties) {
            return error(fmt::format("too many properties: at most {}", most_properties));
        }
        header_.elements.back().properties.push_back(std::move(property));
    }

    void finish() {
        if (!has_format_) {
            messages_.error(header_.lines, 1, "the header has no format");
        }
    }

    std::string_view bytes_;
    MeshMessages& messages_;
    Header header_;
    std::string_view line_;
    std::size_t at_ = 0;
    int word_column_ = 1;
    char line_end_ = '\n';
    bool has_format_ = false;
};

}  // namespace

std::optional<Header> read_header(std::string_view bytes, MeshMessages& messages) { return HeaderReader(bytes, messages).run(); }

}  // namespace lancer::ply
