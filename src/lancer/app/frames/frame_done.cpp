#include "lancer/app/frames/frame_done.h"

#include <filesystem>
#include <stdexcept>

#include "lancer/app/cli/film_about.h"
#include "lancer/base/file.h"
#include "lancer/film/film_file.h"
#include "lancer/image/layers.h"
#include "lancer/image/said.h"
#include "lancer/image/tiff_whole.h"

namespace lancer::app {

namespace {

// Reading all of it shows that it is whole.
Metadata texts_of(const std::string& path) {
    if (is_film(path)) {
        return FilmFile(path).about().texts;
    }
    if (const std::string ending = file_ending(path); ending == ".tif" || ending == ".tiff") {
        Diagnostics ignored;
        const auto bytes = read_file(path, {}, ignored);
        if (!bytes || !is_whole_tiff(bytes->view())) {
            return {};
        }
    }
    LayeredImage picture = read_layers(path);
    if (!picture.metadata.empty() || file_ending(path) == ".exr") {
        return std::move(picture.metadata);
    }
    Diagnostics ignored;
    const auto bytes = read_file(path, {}, ignored);
    return bytes ? texts_in_picture(bytes->view()) : Metadata();
}

}  // namespace

bool says(const Metadata& texts, const FrameFacts& facts) {
    const auto has = [&](const char* key, const std::string& value) {
        const auto found = texts.find(key);
        return found != texts.end() && found->second == value;
    };
    return has("lancer:version", LANCER_VERSION) && has("lancer:command", facts.command) && has("lancer:hash", facts.hash);
}

bool is_frame_done(const std::string& path, const FrameFacts& facts) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
        return false;
    }
    try {
        const Metadata texts = texts_of(path);
        return says(texts, facts) && !texts.contains("lancer:unfinished");
    } catch (const std::exception&) {
        return false;  // then it is made anew
    }
}

}  // namespace lancer::app
