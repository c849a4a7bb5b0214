#include "lancer/import/scene_files.h"

#include <filesystem>

#include <fmt/format.h>

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

std::optional<FileBytes> SceneFiles::open(const std::string& path, const SourcePosition& named_at) {
    if (!is_allowed(path, named_at)) {
        return std::nullopt;
    }
    auto bytes = read_file(path, named_at, diagnostics_);
    if (bytes) {
        add_to_hash(path, bytes->view());
    }
    return bytes;
}

std::shared_ptr<const scene::TriangleMesh> SceneFiles::mesh(const std::string& path, const SourcePosition& named_at) {
    const auto [found, is_new] = meshes_.try_emplace(path);
    if (!is_new) {
        return found->second;
    }
    const std::string ending = file_ending(path);
    if (ending != ".obj" && ending != ".ply") {
        diagnostics_.error(named_at, fmt::format("\"{}\": meshes are read from .obj and .ply files", path));
        return nullptr;
    }
    if (const auto bytes = open(path, named_at)) {
        auto mesh = ending == ".obj" ? read_obj(bytes->view(), path, diagnostics_) : read_ply(bytes->view(), path, diagnostics_);
        if (mesh) {
            found->second = std::make_shared<const scene::TriangleMesh>(std::move(*mesh));
        }
    }
    return found->second;
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

std::optional<SpectralCurve> SceneFiles::curve(const std::string& path, const SourcePosition& named_at) {
    const auto [found, is_new] = curves_.try_emplace(path);
    if (is_new) {
        if (const auto bytes = read_file(path, named_at, diagnostics_)) {
            add_to_hash(path, bytes->view());
            if (const auto curves = parse_curves(bytes->view(), path, 1, SpectralCurve::Beyond::constant, diagnostics_)) {
                found->second = curves->front();
            }
        }
    }
    return found->second;
}

std::optional<VoxelFile> SceneFiles::voxels(const std::string& path, const VoxelWords& words, const SourcePosition& named_at) {
    const auto bytes = open(path, named_at);
    return bytes ? read_voxels(bytes->view(), path, words, named_at, diagnostics_) : std::nullopt;
}

std::string SceneFiles::hash() const {
    return to_hexadecimal(hash_bytes({reinterpret_cast<const char*>(hashes_.data()), hashes_.size() * sizeof(Hash)}));
}

}  // namespace lancer
