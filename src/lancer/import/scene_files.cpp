#include "lancer/import/scene_files.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "lancer/import/ies/ies.h"
#include "lancer/import/mesh/mesh_file.h"
#include "lancer/import/obj/obj.h"
#include "lancer/import/ply/ply.h"
#include "lancer/spectrum/curve_file.h"

namespace lancer {

// Links count as what they lead to.
bool SceneFiles::is_allowed(const std::string& path, const SourcePosition& named_at) {
    if (!options_.sandbox) {
        return true;
    }
    namespace fs = std::filesystem;
    std::error_code problem;
    const fs::path folder = fs::weakly_canonical(fs::absolute(scene_, problem).parent_path(), problem);
    const fs::path inside = fs::weakly_canonical(fs::absolute(path, problem), problem).lexically_relative(folder);
    if (problem || inside.empty() || *inside.begin() == "..") {
        diagnostics_.error(named_at, fmt::format("\"{}\" lies outside the scene's folder, and this scene may read nothing else", path));
        return false;
    }
    return true;
}

void SceneFiles::add_to_hash(const std::string& path, std::string_view bytes) {
    hashes_.push_back(hash_bytes(bytes));
    inputs_.push_back({path, to_hexadecimal(hashes_.back())});
}

std::optional<FileBytes> SceneFiles::open(const std::string& path, const SourcePosition& named_at, std::size_t limit) {
    if (!is_allowed(path, named_at)) {
        return std::nullopt;
    }
    auto bytes = read_file(path, named_at, diagnostics_, limit);
    if (bytes) {
        add_to_hash(path, bytes->view());
    }
    return bytes;
}

std::optional<FileBytes> SceneFiles::open_or_warn(const std::string& path, const SourcePosition& named_at, const std::string& without) {
    Diagnostics problems;
    std::swap(problems, diagnostics_);
    auto bytes = open(path, named_at);
    std::swap(problems, diagnostics_);
    for (const Diagnostic& problem : problems.list()) {
        diagnostics_.warning(problem.position, problem.message + ": " + without);
    }
    return bytes;
}

std::shared_ptr<const scene::TriangleMesh> SceneFiles::mesh(const std::string& path, const SourcePosition& named_at, std::size_t part) {
    const std::string ending = file_ending(path);
    if (ending != ".obj" && ending != ".ply" && ending != ".meshes") {
        diagnostics_.error(named_at, fmt::format("\"{}\": meshes are read from .obj, .ply and .meshes files", path));
        return nullptr;
    }
    const auto [found, is_new] = meshes_.try_emplace(path);
    std::vector<std::shared_ptr<const scene::TriangleMesh>>& parts = found->second;
    if (is_new) {
        if (const auto bytes = open(path, named_at)) {
            if (ending == ".meshes") {
                parts = read_meshes(bytes->view(), path, diagnostics_);
            } else if (auto mesh =
                           ending == ".obj" ? read_obj(bytes->view(), path, diagnostics_) : read_ply(bytes->view(), path, diagnostics_)) {
                parts.push_back(std::make_shared<const scene::TriangleMesh>(std::move(*mesh)));
            }
        }
    }
    if (part >= parts.size() && !parts.empty()) {
        diagnostics_.error(named_at, fmt::format("there is no part {} in \"{}\": it has {}, counted from 0", part, path, parts.size()));
    }
    return part < parts.size() ? parts[part] : nullptr;
}

bool SceneFiles::image(const std::string& path, const SourcePosition& named_at) {
    const auto [found, is_new] = images_.try_emplace(path, false);
    if (is_new) {
        Diagnostics problems;
        std::swap(problems, diagnostics_);
        found->second = open(path, named_at).has_value();
        std::swap(problems, diagnostics_);
        if (problems.has_errors() && options_.magenta_textures) {
            diagnostics_.warning(named_at, problems.list().front().message + ": it is magenta instead");
        } else {
            diagnostics_.append(std::move(problems));
        }
    }
    return found->second;
}

bool SceneFiles::image(scene::ImageTexture& texture, const SourcePosition& named_at) {
    if (image(texture.file, named_at)) {
        return true;
    }
    if (options_.magenta_textures) {
        texture.bytes = std::make_shared<const std::string>("P6 1 1 255\n\xff\x01\xff");
    }
    return options_.magenta_textures;
}

std::optional<SpectralCurve> SceneFiles::curve(const std::string& path, const SourcePosition& named_at) {
    const auto [found, is_new] = curves_.try_emplace(path);
    if (is_new) {
        if (const auto bytes = open(path, named_at)) {
            if (const auto curves = parse_curves(bytes->view(), path, 1, SpectralCurve::Beyond::constant, diagnostics_)) {
                found->second = curves->front();
            }
        }
    }
    return found->second;
}

std::shared_ptr<const scene::Photometry> SceneFiles::photometry(const std::string& path, const SourcePosition& named_at) {
    const auto [found, is_new] = photometries_.try_emplace(path);
    if (is_new) {
        if (const auto bytes = open(path, named_at)) {
            if (auto read = read_ies(bytes->view(), path, diagnostics_)) {
                found->second = std::make_shared<const scene::Photometry>(std::move(*read));
            }
        }
    }
    return found->second;
}

bool SceneFiles::enter(const std::string& path, const SourcePosition& named_at) {
    constexpr std::size_t deepest = 16;
    constexpr std::size_t most = 1000;
    std::error_code problem;
    const std::string file = std::filesystem::weakly_canonical(std::filesystem::absolute(path, problem), problem).string();
    if (std::find(reading_.begin(), reading_.end(), file) != reading_.end()) {
        diagnostics_.error(named_at, fmt::format("\"{}\" includes itself", path));
        return false;
    }
    if (reading_.size() > deepest) {
        diagnostics_.error(named_at, fmt::format("scenes are included more than {} deep", deepest));
        return false;
    }
    if (++includes_ > most + 1) {
        diagnostics_.error(named_at, fmt::format("more than {} scenes are included", most));
        return false;
    }
    reading_.push_back(file);
    return true;
}

std::optional<VoxelFile> SceneFiles::voxels(const std::string& path, const VoxelWords& words, const SourcePosition& named_at) {
    const auto bytes = open(path, named_at);
    return bytes ? read_voxels(bytes->view(), path, words, named_at, diagnostics_) : std::nullopt;
}

std::string SceneFiles::hash() const {
    return to_hexadecimal(hash_bytes({reinterpret_cast<const char*>(hashes_.data()), hashes_.size() * sizeof(Hash)}));
}

}  // namespace lancer
