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

std::string encode_by_module(LancerImageToWrite job, const Metadata& metadata) {
    std::vector<LancerText> texts;
    for (const auto& [key, value] : metadata) {
        texts.push_back({key.c_str(), value.c_str()});
    }
    job.texts = texts.data();
    job.text_count = texts.size();
    std::string result, reason;
    if (!images_module().encode(&job, &result, append, &reason, append)) {
        throw std::runtime_error(reason);
    }
    return result;
}

[[noreturn]] void refuse(const std::string& ending) {
    throw std::runtime_error(fmt::format("images can be written as {}, not as \"{}\"", fmt::join(writable_endings(), ", "), ending));
}

std::string encode(const std::string& ending, const ByteImage& image, const Metadata& metadata) {
    if (ending == ".png") {
        return encode_png(image, metadata);
    }
    if (ending == ".jpg" || ending == ".jpeg") {
        return encode_by_module({"jpeg", image.width, image.height, image.channels, nullptr, image.pixels.data(), nullptr, 0}, metadata);
    }
    refuse(ending);
}

std::string encode(const std::string& ending, const Image& image, const Metadata& metadata) {
    if (ending == ".png") {
        return encode_png(quantise_srgb(image), metadata);
    }
    if (ending == ".exr") {
        return encode_exr(image, metadata);
    }
    if (ending == ".jpg" || ending == ".jpeg") {
        return encode(ending, quantise_srgb(without_alpha(image, false)), metadata);
    }
    if (ending == ".hdr") {
        return encode_hdr(image, metadata);
    }
    if (ending == ".tif" || ending == ".tiff") {
        return encode_by_module({"tiff", image.width, image.height, image.channels, image.pixels.data(), nullptr, nullptr, 0}, metadata);
    }
    refuse(ending);
}

template <class AnyImage>
void write(const std::string& path, const AnyImage& image, const Metadata& metadata) {
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

}  // namespace

const std::vector<std::string>& writable_endings() {
    static const std::vector<std::string> endings = {".png", ".jpg", ".jpeg", ".exr", ".hdr", ".tif", ".tiff"};
    return endings;
}

void write_image(const std::string& path, const Image& image, const Metadata& metadata) { write(path, image, metadata); }
void write_image(const std::string& path, const ByteImage& image, const Metadata& metadata) { write(path, image, metadata); }

}  // namespace lancer
