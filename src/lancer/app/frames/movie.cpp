#include "lancer/app/frames/movie.h"

#include <unistd.h>

#include <charconv>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "lancer/app/farm/program.h"
#include "lancer/base/failure.h"
#include "lancer/base/file.h"
#include "lancer/film/develop.h"
#include "lancer/image/layers.h"

namespace lancer::app {

namespace fs = std::filesystem;

namespace {

// The file until it is whole.
class Unfinished {
public:
    explicit Unfinished(const fs::path& output)
        : path_((output.parent_path() / fmt::format(".lancer-{}.part{}", ::getpid(), output.extension().string())).string()) {}
    ~Unfinished() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;

    const std::string& path() const { return path_; }

private:
    std::string path_;
};

Film film_of(const LayeredImage& picture, const std::string& path) {
    const bool is_grey = find_channel(picture, "R") == nullptr && find_channel(picture, "Y") != nullptr;
    if (!is_grey && find_channel(picture, "R") == nullptr) {
        throw std::runtime_error(fmt::format("{} has no channels R, G and B", path));
    }
    const std::vector<std::string> names = is_grey ? std::vector<std::string>{"Y", "Y", "Y"} : std::vector<std::string>{"R", "G", "B"};
    const Image image = picture_of(picture, names);
    Film film(image.width, image.height);
    for (std::size_t i = 0; i < film.radiance.size(); ++i) {
        film.radiance[i] = {image.pixels[3 * i], image.pixels[3 * i + 1], image.pixels[3 * i + 2]};
    }
    return film;
}

std::string text_of(const LayeredImage& picture, const std::string& key) {
    const auto found = picture.metadata.find(key);
    return found == picture.metadata.end() ? "" : found->second;
}

// What is encoded for displays has been through a view already.
ViewTransform view_of(const MovieRequest& request, const LayeredImage& first) {
    const std::string said = request.view.value_or(first.display ? "" : text_of(first, "lancer:view"));
    double exposure = 0.0;
    if (const std::string number = text_of(first, "lancer:exposure"); !first.display) {
        std::from_chars(number.data(), number.data() + number.size(), exposure);
    }
    return {find_view(said).value_or(View::srgb), request.exposure.value_or(exposure)};
}

std::vector<std::string> words_for(const std::string& path, const MovieRequest& request, int width, int height) {
    std::vector<std::string> words = {"ffmpeg",
                                      "-hide_banner",
                                      "-loglevel",
                                      "error",
                                      "-y",
                                      "-f",
                                      "rawvideo",
                                      "-pix_fmt",
                                      "rgb24",
                                      "-video_size",
                                      fmt::format("{}x{}", width, height),
                                      "-framerate",
                                      fmt::format("{}", request.fps),
                                      "-i",
                                      "-"};
    const auto add = [&](std::initializer_list<const char*> more) { words.insert(words.end(), more.begin(), more.end()); };
    const std::string ending = file_ending(path);
    if (ending == ".gif") {
        add({"-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse"});
    } else {
        // Players want an even number of pixels, and BT.709 as the meaning of the numbers.
        add({"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"});
        add({"-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1", "-color_range", "tv"});
        ending == ".webm" ? add({"-c:v", "libvpx-vp9", "-crf", "20", "-b:v", "0"}) : add({"-c:v", "libx264", "-crf", "16"});
        if (ending == ".mp4" || ending == ".mov") {
            add({"-movflags", "+faststart"});
        }
    }
    words.push_back(path);
    return words;
}

}  // namespace

const std::vector<std::string>& movie_endings() {
    static const std::vector<std::string> endings = {".mp4", ".mkv", ".mov", ".webm", ".gif"};
    return endings;
}

bool make_movie(const MovieRequest& request, const std::function<void(int)>& tell, const std::atomic<bool>& interrupted) {
    if (!find_program("ffmpeg")) {
        throw MachineFailure("ffmpeg, which makes films of pictures, is not on this machine (on Debian: apt-get install ffmpeg)");
    }
    const Unfinished file(request.output);
    std::optional<ProgramInput> ffmpeg;
    ViewTransform view;
    ByteImage frame;
    int done = 0;
    for (const std::string& path : request.pictures) {
        if (interrupted) {
            return false;
        }
        const LayeredImage picture = read_layers(path);
        if (!ffmpeg) {
            view = view_of(request, picture);
            frame = {picture.width, picture.height, 3,
                     std::vector<std::uint8_t>(3 * static_cast<std::size_t>(picture.width * picture.height))};
            ffmpeg.emplace(words_for(file.path(), request, picture.width, picture.height));
        } else if (picture.width != frame.width || picture.height != frame.height) {
            throw std::runtime_error(fmt::format("{} is {}x{}, and the frames before it are {}x{}", path, picture.width, picture.height,
                                                 frame.width, frame.height));
        }
        develop_rows(film_of(picture, path), view, 0, frame.height, frame);
        if (!ffmpeg->write({reinterpret_cast<const char*>(frame.pixels.data()), frame.pixels.size()})) {
            break;  // it has ended, and its status says how
        }
        tell(++done);
    }
    if (const int status = ffmpeg->finish(); status != 0) {
        throw MachineFailure(fmt::format("ffmpeg ended with {}; what it said stands above", status));
    }
    fs::rename(file.path(), request.output);
    return true;
}

}  // namespace lancer::app
