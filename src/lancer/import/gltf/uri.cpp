#include "lancer/import/gltf/uri.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

namespace lancer::gltf {

namespace {

constexpr std::uint8_t no_digit = 0xFF;

constexpr std::array<std::uint8_t, 256> make_base64_digits() {
    std::array<std::uint8_t, 256> digits{};
    for (std::uint8_t& digit : digits) {
        digit = no_digit;
    }
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < alphabet.size(); ++i) {
        digits[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
    }
    return digits;
}

constexpr std::array<std::uint8_t, 256> base64_digits = make_base64_digits();

std::optional<std::string> decode_base64(std::string_view text) {
    while (!text.empty() && text.back() == '=') {
        text.remove_suffix(1);
    }
    if (text.size() % 4 == 1) {
        return std::nullopt;
    }
    std::string bytes;
    bytes.resize(text.size() / 4 * 3 + (text.size() % 4 == 0 ? 0 : text.size() % 4 - 1));
    std::uint32_t bits = 0, held = 0;
    std::size_t out = 0;
    for (const char c : text) {
        const std::uint8_t digit = base64_digits[static_cast<unsigned char>(c)];
        if (digit == no_digit) {
            return std::nullopt;
        }
        bits = bits << 6 | digit;
        held += 6;
        if (held >= 8) {
            held -= 8;
            bytes[out++] = static_cast<char>(bits >> held & 0xFF);
        }
    }
    return bytes;
}

}  // namespace

std::optional<DataUri> split_data_uri(std::string_view uri) {
    constexpr std::string_view prefix = "data:";
    const std::size_t comma = uri.find(',');
    if (uri.substr(0, prefix.size()) != prefix || comma == std::string_view::npos) {
        return std::nullopt;
    }
    DataUri parts;
    parts.media_type = uri.substr(prefix.size(), comma - prefix.size());
    parts.payload = uri.substr(comma + 1);
    constexpr std::string_view mark = ";base64";
    if (parts.media_type.size() >= mark.size() && parts.media_type.substr(parts.media_type.size() - mark.size()) == mark) {
        parts.base64 = true;
        parts.media_type.remove_suffix(mark.size());
    }
    parts.media_type = parts.media_type.substr(0, parts.media_type.find(';'));
    return parts;
}

std::optional<std::string> decode(const DataUri& uri) { return uri.base64 ? decode_base64(uri.payload) : decode_percent(uri.payload); }

std::optional<std::string> decode_percent(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded.push_back(text[i]);
            continue;
        }
        const std::string_view digits = text.substr(i + 1, 2);
        unsigned value = 0;
        const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
        if (digits.size() != 2 || parsed.ptr != digits.data() + 2) {
            return std::nullopt;
        }
        decoded.push_back(static_cast<char>(value));
        i += 2;
    }
    return decoded;
}

std::string_view scheme_of(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    const std::size_t slash = uri.find('/');
    const bool has = colon != std::string_view::npos && colon > 1 && (slash == std::string_view::npos || colon < slash);
    return has ? uri.substr(0, colon + 1) : std::string_view();
}

}  // namespace lancer::gltf
