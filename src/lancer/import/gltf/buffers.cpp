#include "lancer/import/gltf/buffers.h"

#include <fmt/format.h>

#include "lancer/import/gltf/meshopt.h"
#include "lancer/import/gltf/uri.h"

namespace lancer::gltf {

Buffers::Buffers(Document& document, SceneFiles& files)
    : document_(document), files_(files), buffers_(document.items("buffers").size()), views_(document.items("bufferViews").size()),
      total_(document.bytes().size()) {}

std::optional<std::string_view> Buffers::buffer(std::size_t index) {
    Kept& kept = buffers_[index];
    if (!kept.is_known) {
        kept.is_known = true;
        load(index, kept);
    }
    return kept.bytes;
}

void Buffers::load(std::size_t index, Kept& kept) {
    const Json buffer = document_.items("buffers")[index];
    const std::size_t length = buffer.natural("byteLength").value_or(0);
    if (buffer["uri"]) {
        load_uri(buffer, kept);
    } else if (index == 0 && document_.binary() != nullptr) {
        kept.bytes = *document_.binary();
    } else {
        document_.error(buffer, "the buffer has no bytes: expected a \"uri\"");
    }
    if (kept.bytes && kept.bytes->size() < length) {
        document_.error(buffer["byteLength"], fmt::format("{} bytes: there are only {}", length, kept.bytes->size()));
        kept.bytes.reset();
    }
    if (kept.bytes) {
        kept.bytes = kept.bytes->substr(0, length);
    }
}

void Buffers::load_uri(Json buffer, Kept& kept) {
    const Json uri = buffer["uri"];
    const std::string_view text = uri.value().text;
    if (const auto data = split_data_uri(text)) {
        if (data->media_type != "application/octet-stream" && data->media_type != "application/gltf-buffer") {
            document_.warning(uri,
                              fmt::format("data of the type \"{}\": expected application/octet-stream", data->media_type.substr(0, 80)));
        }
        if (auto bytes = decode(*data)) {
            kept.decoded = std::move(*bytes);
            kept.bytes = kept.decoded;
            total_ += kept.decoded.size();
        } else {
            document_.error(uri, "the data URI is no valid base64");
        }
        return;
    }
    if (!scheme_of(text).empty()) {
        document_.error(uri, fmt::format("\"{}\": lancer reads no files from the network", text.substr(0, 80)));
        return;
    }
    const auto name = decode_percent(text);
    if (!name || name->find('\0') != std::string::npos) {
        document_.error(uri, "expected a file's name, with %XX for characters that URIs don't allow");
        return;
    }
    auto file = files_.open(path_beside(document_.path(), *name), document_.position(uri));
    if (!file && *name != text) {
        // Some exporters leave percent signs as they are. The error has been said already, so it is only about the decoded name.
        return;
    }
    if (file) {
        kept.file = std::move(*file);
        kept.bytes = kept.file.view();
        total_ += kept.file.size;
    }
}

// Where the view lies in its buffer.
std::optional<std::string_view> Buffers::part(Json view) {
    const auto number = view.natural("buffer");
    const std::size_t offset = view.natural("byteOffset").value_or(0);
    const std::size_t length = view.natural("byteLength").value_or(0);
    const auto bytes = number && *number < buffers_.size() ? buffer(*number) : std::nullopt;
    if (!bytes) {
        return std::nullopt;
    }
    if (offset > bytes->size() || length > bytes->size() - offset) {
        document_.error(view, fmt::format("bytes {} to {} of a buffer of {}", offset, offset + length, bytes->size()));
        return std::nullopt;
    }
    return bytes->substr(offset, length);
}

std::optional<std::string_view> Buffers::view(std::size_t index) {
    Kept& kept = views_[index];
    if (!kept.is_known) {
        kept.is_known = true;
        const Json view = document_.items("bufferViews")[index];
        if (const Json compression = document_.extension(view, "EXT_meshopt_compression")) {
            decompress(compression, kept);
        } else {
            kept.bytes = part(view);
        }
    }
    return kept.bytes;
}

void Buffers::decompress(Json compression, Kept& kept) {
    const auto packed = part(compression);
    if (!packed) {
        return;
    }
    MeshoptView view;
    view.bytes = *packed;
    view.count = compression.natural("count").value_or(0);
    view.stride = compression.natural("byteStride").value_or(0);
    view.mode = compression.text("mode");
    view.filter = compression.text("filter", "NONE");
    std::string problem;
    if (auto decoded = decode_meshopt(view, problem)) {
        kept.decoded = std::move(*decoded);
        kept.bytes = kept.decoded;
        total_ += kept.decoded.size();
        document_.honoured("EXT_meshopt_compression", compression);
    } else {
        document_.error(compression, problem);
    }
}

}  // namespace lancer::gltf
