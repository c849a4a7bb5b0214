#include "lancer/image/said.h"

#include <algorithm>
#include <cstdint>

namespace lancer {

namespace {

constexpr std::string_view png_signature("\x89PNG\r\n\x1a\n", 8);

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t number = 0;
    for (const char byte : bytes.substr(0, 4)) {
        number = number << 8 | static_cast<std::uint8_t>(byte);
    }
    return number;
}

// What stands in front of the next zero byte, which is taken as well.
std::string_view take_text(std::string_view& bytes) {
    const std::size_t end = std::min(bytes.find('\0'), bytes.size());
    const std::string_view text = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    return text;
}

// Chunks: length, type, content, checksum.
Metadata texts_in_png(std::string_view bytes) {
    Metadata texts;
    bytes.remove_prefix(png_signature.size());
    while (bytes.size() >= 12) {
        const std::size_t length = big_endian(bytes);
        const std::string_view type = bytes.substr(4, 4);
        if (length > bytes.size() - 12) {
            break;
        }
        std::string_view content = bytes.substr(8, length);
        if (type == "tEXt" || type == "iTXt") {
            const std::string_view key = take_text(content);
            const bool is_packed = type == "iTXt" && !content.empty() && content.front() != '\0';
            if (type == "iTXt") {
                content.remove_prefix(std::min<std::size_t>(2, content.size()));
                take_text(content);  // the language
                take_text(content);  // the key in it
            }
            if (!is_packed) {
                texts.emplace(key, content);
            }
        }
        bytes.remove_prefix(length + 12);
    }
    return texts;
}

Metadata texts_in_lines(std::string_view bytes) {
    constexpr std::string_view start = "lancer:";
    Metadata texts;
    for (std::size_t at = bytes.find(start); at != std::string_view::npos; at = bytes.find(start, at)) {
        const std::string_view line = bytes.substr(at, bytes.substr(at).find_first_of(std::string_view("\n\0", 2)));
        const std::size_t end = line.find_first_of(":=", start.size());
        if (end != std::string_view::npos && line.find(' ') >= end) {
            const bool is_colon = line[end] == ':';
            texts.emplace(line.substr(0, end), line.substr(std::min(line.size(), end + (is_colon ? 2 : 1))));
        }
        at += std::max<std::size_t>(line.size(), start.size());
    }
    return texts;
}

}  // namespace

Metadata texts_in_picture(std::string_view bytes) { return bytes.starts_with(png_signature) ? texts_in_png(bytes) : texts_in_lines(bytes); }

}  // namespace lancer
