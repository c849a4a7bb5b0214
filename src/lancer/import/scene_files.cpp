#include "lancer/import/scene_files.h"

#include <fmt/format.h>

#include "lancer/base/file.h"
#include "lancer/import/obj/obj.h"
#include "lancer/import/ply/ply.h"

namespace lancer {

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
    if (const auto bytes = read_file(path, named_at, diagnostics_)) {
        add_to_hash(bytes->view());
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
        if (const auto bytes = read_file(path, named_at, diagnostics_)) {
            add_to_hash(bytes->view());
            found->second = true;
        }
    }
    return found->second;
}

std::string SceneFiles::hash() const {
    return to_hexadecimal(hash_bytes({reinterpret_cast<const char*>(hashes_.data()), hashes_.size() * sizeof(Hash)}));
}

}  // namespace lancer
