// The files that a scene is made of: each mesh is read once, and all bytes go into the scene's hash.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/base/diagnostic.h"
#include "lancer/base/hash.h"
#include "lancer/scene/scene.h"

namespace lancer {

class SceneFiles {
public:
    explicit SceneFiles(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    void add_to_hash(std::string_view bytes) { hashes_.push_back(hash_bytes(bytes)); }

    // By the file's ending, .obj or .ply. Null when it can't be read; the diagnostics say why, once for each file.
    std::shared_ptr<const scene::TriangleMesh> mesh(const std::string& path, const SourcePosition& named_at);

    // Whether the picture is there; its pixels are read later.
    bool image(const std::string& path, const SourcePosition& named_at);

    // Of everything so far, in the order of reading; hexadecimal.
    std::string hash() const;

private:
    Diagnostics& diagnostics_;
    std::vector<Hash> hashes_;
    std::map<std::string, std::shared_ptr<const scene::TriangleMesh>> meshes_;
    std::map<std::string, bool> images_;
};

}  // namespace lancer
