// The files that a scene is made of: each mesh is read once, and all bytes go into the scene's hash.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/base/diagnostic.h"
#include "lancer/base/file.h"
#include "lancer/base/hash.h"
#include "lancer/import/import.h"
#include "lancer/import/volume/voxel_file.h"
#include "lancer/scene/scene.h"
#include "lancer/spectrum/curve.h"

namespace lancer {

class SceneFiles {
public:
    // `scene` is the file that names all others; of the options, `sandbox` and `magenta_textures` are kept to.
    SceneFiles(std::string scene, const ImportOptions& options, Diagnostics& diagnostics)
        : scene_(std::move(scene)), options_(options), diagnostics_(diagnostics) {}

    // Any file, read and hashed. In a sandbox, files outside the scene's folder are errors.
    std::optional<FileBytes> open(const std::string& path, const SourcePosition& named_at,
                                  std::size_t limit = static_cast<std::size_t>(-1));

    // The same, where the scene makes sense without the file: then it is a warning that ends with `without`.
    std::optional<FileBytes> open_or_warn(const std::string& path, const SourcePosition& named_at, const std::string& without);

    void add_to_hash(const std::string& path, std::string_view bytes);

    // By the file's ending, .obj, .ply or .meshes; `part` is for the latter. Null when it can't be read; the diagnostics say why, once for each
    // file.
    std::shared_ptr<const scene::TriangleMesh> mesh(const std::string& path, const SourcePosition& named_at, std::size_t part = 0);

    // Whether the picture is there; its pixels are read later. Without it: an error, or a warning where missing pictures are to be magenta.
    bool image(const std::string& path, const SourcePosition& named_at);

    // The same for a texture, which becomes a magenta picture of one pixel where that is wanted. False after an error.
    bool image(scene::ImageTexture& texture, const SourcePosition& named_at);

    // A measured curve of one value a wavelength, with the same value beyond its ends. Nothing when it can't be read, as above.
    std::optional<SpectralCurve> curve(const std::string& path, const SourcePosition& named_at);

    // The intensities of an .ies file. Null when it can't be read, as above.
    std::shared_ptr<const scene::Photometry> photometry(const std::string& path, const SourcePosition& named_at);

    // Around the reading of a scene that another one includes. False, with an error, for one that is being read already, includes nested more
    // than 16 deep, and more than 1000 of them in all.
    bool enter(const std::string& path, const SourcePosition& named_at);
    void leave() { reading_.pop_back(); }

    // A grid of numbers, by the file's ending: .vdb, .vol or .raw. Nothing when it can't be read, as above.
    std::optional<VoxelFile> voxels(const std::string& path, const VoxelWords& words, const SourcePosition& named_at);

    // Of everything so far, in the order of reading; hexadecimal.
    std::string hash() const;
    const std::vector<scene::InputFile>& inputs() const { return inputs_; }

private:
    bool is_allowed(const std::string& path, const SourcePosition& named_at);

    std::string scene_;
    ImportOptions options_;
    Diagnostics& diagnostics_;
    std::vector<Hash> hashes_;
    std::vector<scene::InputFile> inputs_;
    std::map<std::string, std::vector<std::shared_ptr<const scene::TriangleMesh>>> meshes_;  // the parts of each file
    std::vector<std::string> reading_;                                                       // scenes around the one that is read now
    std::size_t includes_ = 0;
    std::map<std::string, bool> images_;
    std::map<std::string, std::optional<SpectralCurve>> curves_;
    std::map<std::string, std::shared_ptr<const scene::Photometry>> photometries_;
};

}  // namespace lancer
