#include "lancer/image/signature.h"

#include <array>
#include <fstream>

namespace lancer {

std::string image_format(std::string_view first_bytes, std::string_view ending) {
    using namespace std::string_view_literals;
    struct Signature {
        std::string_view bytes;
        const char* format;
    };
    // Left out on purpose: DDS and GIF, whose readers hang or take gigabytes on some broken files (OpenImageIO 2.4).
    static constexpr Signature signatures[] = {
        {"\x89PNG\r\n\x1a\n"sv, "png"},
        {"\xff\xd8\xff"sv, "jpeg"},
        {"\x76\x2f\x31\x01"sv, "openexr"},
        {"#?RADIANCE"sv, "hdr"},
        {"#?RGBE"sv, "hdr"},
        {"II*\0"sv, "tiff"},
        {"MM\0*"sv, "tiff"},
        {"II+\0"sv, "tiff"},
        {"MM\0+"sv, "tiff"},
        {"BM"sv, "bmp"},
    };
    for (const Signature& signature : signatures) {
        if (first_bytes.substr(0, signature.bytes.size()) == signature.bytes) {
            return signature.format;
        }
    }
    if (first_bytes.substr(0, 4) == "RIFF"sv && first_bytes.size() >= 12 && first_bytes.substr(8, 4) == "WEBP"sv) {
        return "webp";
    }
    // P1 to P6, PF and Pf, then white space.
    if (first_bytes.size() >= 3 && first_bytes[0] == 'P' && "123456Ff"sv.find(first_bytes[1]) != std::string_view::npos &&
        " \t\r\n#"sv.find(first_bytes[2]) != std::string_view::npos) {
        return "pnm";
    }
    return ending == ".tga"sv ? "targa" : "";
}

bool exr_attributes_fit(const std::string& path, std::uint64_t file_bytes) {
    std::ifstream file(path, std::ios::binary);
    std::array<char, 8> preamble{};  // magic number and version
    file.read(preamble.data(), preamble.size());
    const int last_empty_name = (preamble[5] & 0x10) != 0 ? 2 : 1;  // of several parts, or of one
    const auto skip_name = [&file] {                                // the length of a zero-terminated name
        int length = 0;
        while (file && file.get() > 0) {
            ++length;
        }
        return length;
    };
    // Headers, each ended by an empty name; several parts are ended by one more. What is missing, the library will notice.
    int empty_names = 0;
    while (file && empty_names < last_empty_name) {
        if (skip_name() == 0) {
            ++empty_names;
            continue;
        }
        empty_names = 0;
        skip_name();  // the type
        std::array<unsigned char, 4> bytes{};
        file.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
        const std::uint32_t size =
            std::uint32_t{bytes[0]} | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 | std::uint32_t{bytes[3]} << 24;
        if (file && size > file_bytes) {
            return false;
        }
        file.seekg(size, std::ios::cur);
    }
    return true;
}

}  // namespace lancer
