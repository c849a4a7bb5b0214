#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cassert>
#include <stdexcept>

#include "lancer/base/failure.h"
#include "lancer/base/file.h"
#include "lancer/image/encode.h"
#include "lancer/image/exr.h"
#include "lancer/image/hdr.h"
#include "lancer/image/image.h"
#include "lancer/image/images_module.h"
#include "lancer/image/png.h"
#include "lancer/image/replace_file.h"

namespace lancer {
namespace {

void append(void* receiver, const char* data, std::size_t size) { static_cast<std::string*>(receiver)->append(data, size); }

std::string encode_by_module(const char* format, const Image& image, const Metadata& metadata) {
    std::vector<LancerText> texts;
    for (const auto& [key, value] : metadata) {
        texts.push_back({key.c_str(), value.c_str()});
    }
    const std::vector<std::uint8_t> bytes = std::string_view(format) == "jpeg" ? quantise_srgb(image) : std::vector<std::uint8_t>{};
    const LancerImageToWrite job{format,
                                 image.width,
                                 image.height,
                                 image.channels,
                                 bytes.empty() ? image.pixels.data() : nullptr,
                                 bytes.empty() ? nullptr : bytes.data(),
                                 texts.data(),
                                 texts.size()};
    std::string result, reason;
    if (!images_module().encode(&job, &result, append, &reason, append)) {
        throw std::runtime_error(reason);
    }
    return result;
}

std::string encode(const std::string& ending, const Image& image, const Metadata& metadata) {
    if (ending == ".png") {
        return encode_png(image, metadata);
    }
    if (ending == ".exr") {
        return encode_exr(image, metadata);
    }
    if (ending == ".jpg" || ending == ".jpeg") {
        return encode_by_module("jpeg", without_alpha(image, false), metadata);
    }
    if (ending == ".hdr") {
        return encode_hdr(image, metadata);
    }
    if (ending == ".tif" || ending == ".tiff") {
        return encode_by_module("tiff", image, metadata);
    }
    throw std::runtime_error(fmt::format("images can be written as {}, not as \"{}\"", fmt::join(writable_endings(), ", "), ending));
}

}  // namespace

const std::vector<std::string>& writable_endings() {
    static const std::vector<std::string> endings = {".png", ".jpg", ".jpeg", ".exr", ".hdr", ".tif", ".tiff"};
    return endings;
}

void write_image(const std::string& path, const Image& image, const Metadata& metadata) {
    assert(image.width > 0 && image.height > 0 && image.channels >= 1 && image.channels <= 4);
    assert(image.pixels.size() ==
           static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * static_cast<std::size_t>(image.channels));
    std::string bytes;
    try {
        bytes = encode(file_ending(path), image, metadata);
    } catch (const std::exception& error) {
        throw MachineFailure(fmt::format("cannot write {}: {}", path, error.what()));
    }
    replace_file(path, bytes);
}

}  // namespace lancer
