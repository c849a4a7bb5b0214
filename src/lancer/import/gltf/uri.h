// How glTF names other files, or holds them within [RFC 2397, RFC 3986].
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lancer::gltf {

struct DataUri {
    std::string_view media_type;  // "image/png"
    std::string_view payload;
    bool base64 = false;
};

// Nothing when it is no data URI.
std::optional<DataUri> split_data_uri(std::string_view uri);

// The bytes of the payload; nothing when it is no base64, or no percent encoding.
std::optional<std::string> decode(const DataUri& uri);

// "Box%20With%20Spaces.bin" as a file's name; nothing where a percent sign is not followed by two hexadecimal digits.
std::optional<std::string> decode_percent(std::string_view text);

// "http:" of "http://example.org/a.bin"; empty for what names a file.
std::string_view scheme_of(std::string_view uri);

}  // namespace lancer::gltf
