#include "lancer/import/pbrt/files.h"

#include <filesystem>
#include <system_error>

#include "lancer/base/file.h"

namespace lancer::pbrt {

std::string find_file(const ImportContext& context, const std::string& name, const SourceText& named_in) {
    const std::string beside_scene = path_beside(context.path, name);
    if (named_in.path() == context.path || name.find('\0') != std::string::npos) {
        return beside_scene;
    }
    std::error_code problem;
    const std::string beside_text = path_beside(named_in.path(), name);
    const bool elsewhere = !std::filesystem::exists(beside_scene, problem) && std::filesystem::exists(beside_text, problem);
    return elsewhere ? beside_text : beside_scene;
}

}  // namespace lancer::pbrt
