#include "lancer/app/cli/film_about.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "lancer/base/file.h"

namespace lancer::app {

namespace {

constexpr const char* ours = "film:";  // in front of what does not belong into pictures

double number_in(const std::string& text) {
    double number = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

int whole_in(const std::string& text) { return static_cast<int>(number_in(text)); }

// File names and their hashes, of "lancer:inputs".
std::map<std::string, std::string> files_in(const Metadata& metadata) {
    std::map<std::string, std::string> files;
    const auto found = metadata.find("lancer:inputs");
    std::istringstream lines(found == metadata.end() ? "" : found->second);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t space = std::min(line.find(' '), line.size());
        files[line.substr(std::min(space + 1, line.size()))] = line.substr(0, space);
    }
    return files;
}

}  // namespace

FilmAbout about_film(const Prepared& prepared, const std::vector<std::string>& words) {
    const RenderOptions& options = prepared.options;
    FilmAbout about;
    about.texts = prepared.metadata;
    about.texts["film:folder"] = std::filesystem::current_path().string();
    about.texts["film:wide"] = prepared.contents.wide ? "yes" : "no";
    about.texts["film:spectral-bins"] = fmt::format("{}", prepared.contents.spectral_bins);
    about.texts["film:error"] = fmt::format("{}", options.goal.error);
    about.texts["film:confidence"] = fmt::format("{}", options.goal.confidence);
    about.texts["film:floor"] = fmt::format("{}", options.goal.floor);
    about.texts["film:spp"] = fmt::format("{}", options.spp);
    about.texts["film:shard"] = fmt::format("{}", options.shard);
    about.texts["film:shards"] = fmt::format("{}", options.shards);
    about.texts["film:end"] = fmt::format("{}", options.goal.plan.end);
    for (const int pixels : options.goal.plan.wanted) {
        about.lists["wanted"].push_back(fmt::format("{}", pixels));
    }
    about.lists["words"] = words;
    for (const Aov aov : prepared.contents.aovs) {
        const auto kind = std::find_if(aov_kinds().begin(), aov_kinds().end(), [&](const AovKind& k) { return k.aov == aov; });
        about.lists["aovs"].emplace_back(kind->name);
    }
    about.lists["objects"] = prepared.names.objects;
    about.lists["materials"] = prepared.names.materials;
    return about;
}

Presentation presentation_of(const FilmAbout& about) {
    Presentation presentation;
    for (const auto& [key, text] : about.texts) {
        if (!key.starts_with(ours)) {
            presentation.metadata[key] = text;
        }
    }
    presentation.view = ViewTransform(find_view(about.text("lancer:view")).value_or(View::srgb), number_in(about.text("lancer:exposure")));
    for (const std::string& name : about.list("aovs")) {
        if (const std::optional<Aov> aov = find_aov(name)) {
            presentation.contents.aovs.push_back(*aov);
        }
    }
    presentation.contents.spectral_bins = whole_in(about.text("film:spectral-bins"));
    presentation.contents.confidence = number_in(about.text("film:confidence"));
    presentation.contents.floor = number_in(about.text("film:floor"));
    presentation.contents.wide = about.text("film:wide") == "yes";
    presentation.names = {about.list("objects"), about.list("materials")};
    return presentation;
}

RenderOptions options_of(const FilmAbout& about, const FilmShape& shape) {
    RenderOptions options;
    options.width = shape.width;
    options.height = shape.height;
    options.spp = whole_in(about.text("film:spp"));
    options.intervals = shape.layers.runs;
    options.goal.error = number_in(about.text("film:error"));
    options.goal.confidence = number_in(about.text("film:confidence"));
    options.goal.floor = number_in(about.text("film:floor"));
    options.goal.plan.end = number_in(about.text("film:end"));
    for (const std::string& pixels : about.list("wanted")) {
        options.goal.plan.wanted.push_back(whole_in(pixels));
    }
    if (options.goal.plan.wanted.size() != cut_tiles(shape.width, shape.height, shape.tile_size).size()) {
        options.goal.plan = {};
    }
    options.shard = std::max(1, whole_in(about.text("film:shard")));
    options.shards = std::max(1, whole_in(about.text("film:shards")));
    return options;
}

std::vector<std::string> differences(const Metadata& before, const Metadata& now) {
    std::vector<std::string> sentences;
    const auto text = [](const Metadata& metadata, const std::string& key) {
        const auto found = metadata.find(key);
        return found == metadata.end() ? std::string() : found->second;
    };
    static const std::vector<std::pair<const char*, const char*>> shared = {
        {"lancer:version", "version of lancer"}, {"lancer:camera", "camera"}, {"lancer:integrator", "integrator"},
        {"lancer:bounces", "number of bounces"}, {"lancer:seed", "seed"},     {"lancer:scene", "scene"},
    };
    for (const auto& [key, name] : shared) {
        if (text(before, key) != text(now, key)) {
            sentences.push_back(fmt::format("the {} was \"{}\" and is \"{}\" now", name, text(before, key), text(now, key)));
        }
    }
    const auto files_before = files_in(before);
    const auto files_now = files_in(now);
    for (const auto& [path, hash] : files_before) {
        const auto found = files_now.find(path);
        if (found == files_now.end()) {
            sentences.push_back(fmt::format("{} is not read any more", path));
        } else if (found->second != hash) {
            sentences.push_back(fmt::format("{} has changed", path));
        }
    }
    for (const auto& [path, hash] : files_now) {
        if (!files_before.contains(path)) {
            sentences.push_back(fmt::format("{} is new", path));
        }
    }
    return sentences;
}

FilmAbout about_merged(FilmAbout about, const std::vector<std::string>& outputs) {
    about.texts["film:shard"] = "1";
    about.texts["film:shards"] = "1";
    about.texts["film:folder"] = std::filesystem::current_path().string();
    std::vector<std::string> words;
    const std::vector<std::string>& before = about.list("words");
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] == "--shard" || before[i] == "-o") {
            ++i;
        } else {
            words.push_back(before[i]);
        }
    }
    for (const std::string& output : outputs) {
        words.insert(words.end(), {"-o", output});
    }
    about.lists["words"] = words;
    return about;
}

bool is_film(const std::string& path) { return file_ending(path) == ".film"; }

std::string shard_path(const std::string& picture, int shard, int shards) {
    return is_film(picture) ? picture
                            : std::filesystem::path(picture).replace_extension(fmt::format("{}-of-{}.film", shard, shards)).string();
}

}  // namespace lancer::app
