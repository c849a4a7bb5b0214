#include "lancer/app/cli/outputs.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "lancer/base/file.h"
#include "lancer/film/develop.h"
#include "lancer/film/layered_picture.h"
#include "lancer/render/threads.h"

namespace lancer::app {

namespace fs = std::filesystem;

void check_file(const std::string& path, const std::string& option, Diagnostics& diagnostics) {
    if (path.empty()) {
        diagnostics.error({}, fmt::format("{}: the file needs a name", option));
        return;
    }
    std::error_code ignored;
    const fs::path file(path);
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!fs::exists(folder, ignored)) {
        diagnostics.error({}, fmt::format("{} {}: there is no folder {}", option, path, folder.string()));
    } else if (!fs::is_directory(folder, ignored)) {
        diagnostics.error({}, fmt::format("{} {}: {} is not a folder", option, path, folder.string()));
    } else if (fs::is_directory(file, ignored)) {
        diagnostics.error({}, fmt::format("{} {}: this is a folder; name a file in it", option, path));
    } else if (access(folder.c_str(), W_OK | X_OK) != 0) {
        diagnostics.error({}, fmt::format("{} {}: no permission to write in the folder {}", option, path, folder.string()));
    } else if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored)) {
        diagnostics.error({}, fmt::format("{} {}: this is not an ordinary file", option, path));
    }
}

bool is_picture(const std::string& path) {
    const std::vector<std::string>& endings = writable_endings();
    return std::find(endings.begin(), endings.end(), file_ending(path)) != endings.end();
}

void check_pictures(const std::vector<std::string>& paths, const std::string& option, Diagnostics& diagnostics) {
    std::vector<std::string> seen;
    for (const std::string& path : paths) {
        if (!path.empty() && !is_picture(path)) {
            const std::string ending = file_ending(path);
            const std::string hint = did_you_mean(ending, writable_endings());
            diagnostics.error({}, fmt::format("{} {}: {}; pictures end in {}{}", option, path,
                                              ending.empty() ? "the ending that tells the format is missing"
                                                             : ending + " is not a format that can be written",
                                              fmt::join(writable_endings(), ", "), hint.empty() ? "" : ";" + hint));
        }
        check_file(path, option, diagnostics);
        std::error_code ignored;
        const std::string whole = fs::weakly_canonical(fs::absolute(path, ignored), ignored).string();
        if (std::find(seen.begin(), seen.end(), whole) != seen.end()) {
            diagnostics.error({}, fmt::format("{} {}: this file is named twice", option, path));
        }
        seen.push_back(whole);
    }
}

bool is_linear(const std::string& path) {
    const std::string ending = file_ending(path);
    return ending != ".png" && ending != ".jpg" && ending != ".jpeg";
}

namespace {

ByteImage develop(const Film& film, const ViewTransform& view, int threads) {
    constexpr int rows = 16;
    ByteImage image{film.width, film.height, 3, std::vector<std::uint8_t>(film.radiance.size() * 3)};
    std::atomic<int> next{0};
    run_on_threads(threads, [&] {
        for (int first = next.fetch_add(rows); first < film.height; first = next.fetch_add(rows)) {
            develop_rows(film, view, first, std::min(first + rows, film.height), image);
        }
    });
    return image;
}

}  // namespace

bool holds_layers(const std::string& path) { return file_ending(path) == ".exr"; }

void write_film(const std::string& path, const Film& film, const Presentation& presentation, const FilmSums* sums) {
    const Metadata& metadata = presentation.metadata;
    if (!is_linear(path)) {
        const int threads = presentation.threads > 0 ? presentation.threads : hardware_threads();
        write_image(path, develop(film, presentation.view, threads), metadata);
        return;
    }
    if (holds_layers(path) && sums != nullptr && !presentation.contents.is_plain()) {
        write_layers(path, layered_picture(film, *sums, presentation.contents, presentation.names, metadata));
        return;
    }
    Image image{film.width, film.height, 3, {}};
    image.pixels.reserve(film.radiance.size() * 3);
    for (const glm::vec3& c : film.radiance) {
        image.pixels.insert(image.pixels.end(), {c.x, c.y, c.z});
    }
    write_image(path, image, metadata);
}

void write_sample_map(const std::string& path, const Film& film, const Metadata& metadata) {
    Image image;
    image.width = film.width;
    image.height = film.height;
    image.channels = 1;
    image.pixels.reserve(film.samples.size());
    const std::uint32_t most = std::max(1u, *std::max_element(film.samples.begin(), film.samples.end()));
    const bool linear = is_linear(path);
    for (const std::uint32_t count : film.samples) {
        const float number = static_cast<float>(count);
        // The file is encoded as sRGB: undone here. The root lifts the many pixels with few samples out of the dark.
        image.pixels.push_back(linear ? number : srgb_decode(std::sqrt(number / static_cast<float>(most))));
    }
    write_image(path, image, metadata);
}

}  // namespace lancer::app
