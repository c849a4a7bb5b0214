// The .glb container: a header and chunks of JSON and binary data, all little-endian [Khronos 2021, chapter 4].
#include <cstring>

#include <fmt/format.h>

#include "lancer/import/gltf/document.h"

namespace lancer::gltf {

namespace {

constexpr std::uint64_t header_size = 12;
constexpr std::uint64_t chunk_header_size = 8;
constexpr std::uint32_t json_chunk = 0x4E4F534A;
constexpr std::uint32_t binary_chunk = 0x004E4942;

}  // namespace

// The first bytes say which of the two it is, whatever the file's name ends with.
bool Document::open_container(std::string_view& json) {
    const std::string_view file = bytes_.view();
    const auto word = [&](std::uint64_t byte) {
        std::uint32_t value = 0;
        for (std::uint64_t i = 4; i-- > 0;) {
            value = value << 8 | static_cast<unsigned char>(file[byte + i]);
        }
        return value;
    };
    const auto fail = [&](std::uint64_t byte, const std::string& message) {
        error_at(byte, message);
        return false;
    };
    if (file.substr(0, 4) != "glTF") {
        if (file_ending(path_) == ".glb") {
            is_binary_ = true;
            return fail(0, "this is no binary glTF file: expected its first bytes to be \"glTF\"");
        }
        json = file;
        return true;
    }
    is_binary_ = true;
    if (file.size() < header_size) {
        return fail(file.size(), "the file ends within its header");
    }
    if (word(4) != 2) {
        return fail(4, fmt::format("this is version {} of binary glTF: expected 2", word(4)));
    }
    const std::uint64_t length = word(8);
    if (length > file.size() || length < header_size + chunk_header_size) {
        return fail(8, fmt::format("the header says that the file has {} bytes, but it has {}", length, file.size()));
    }
    if (length < file.size()) {
        warning_at(length, fmt::format("{} bytes after the end that the header names are passed over", file.size() - length));
    }
    bool has_json = false;
    for (std::uint64_t at = header_size; at < length;) {
        if (length - at < chunk_header_size) {
            return fail(at, "the file ends within the header of a chunk");
        }
        const std::uint64_t size = word(at);
        const std::uint32_t type = word(at + 4);
        if (size > length - at - chunk_header_size) {
            return fail(at, fmt::format("a chunk of {} bytes, but only {} are left", size, length - at - chunk_header_size));
        }
        const std::string_view chunk = file.substr(at + chunk_header_size, size);
        if (!has_json) {
            if (type != json_chunk) {
                return fail(at + 4, "expected the first chunk to be JSON");
            }
            has_json = true;
            json = chunk;
            json_begin_ = at + chunk_header_size;
        } else if (type == json_chunk || (type == binary_chunk && has_binary_)) {
            warning_at(at + 4, "a second chunk of the same type is passed over");
        } else if (type == binary_chunk) {
            has_binary_ = true;
            binary_ = chunk;
        } else {
            warning_at(at + 4, fmt::format("a chunk of the unknown type {:#010x} is passed over", type));
        }
        if (size % 4 != 0) {
            warning_at(at, "the chunk's length is no multiple of 4");
        }
        at += chunk_header_size + size;
    }
    return true;
}

}  // namespace lancer::gltf
