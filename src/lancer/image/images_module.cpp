#include "lancer/image/images_module.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <string>
#include <vector>

#include "lancer/base/failure.h"

namespace lancer {
namespace {

namespace fs = std::filesystem;

constexpr const char* file_name = "lancer_images.so";

std::vector<fs::path> places() {
    std::vector<fs::path> folders;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) {
        folders.push_back(program.parent_path());
        folders.push_back(program.parent_path() / LANCER_MODULES_FROM_PROGRAM);  // bin/../lib/lancer, wherever the installation was moved
    }
    folders.emplace_back(LANCER_MODULES_INSTALLED);  // for other programs that link the installed libraries
    folders.emplace_back(LANCER_MODULES_BUILT);      // for the tests
    return folders;
}

const LancerImages& load() {
    const std::vector<fs::path> folders = places();
    fs::path found = file_name;  // the system's search
    for (const fs::path& folder : folders) {
        std::error_code error;
        if (fs::is_regular_file(folder / file_name, error)) {
            found = folder / file_name;
            break;
        }
    }
    // Never unloaded: OpenImageIO has threads of its own.
    void* const module = ::dlopen(found.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!module) {
        const char* const reason = ::dlerror();
        if (found == file_name) {
            std::vector<std::string> searched;
            for (const fs::path& folder : folders) {
                searched.push_back(folder.lexically_normal().string());
            }
            throw MachineFailure(fmt::format(
                "{}, the part of lancer that reads images other than PNG and writes JPEG and TIFF, was not found in {}; it is built "
                "when the Debian package libopenimageio-dev is installed",
                file_name, fmt::join(searched, ", ")));
        }
        throw MachineFailure(fmt::format("cannot load {}: {}; it needs OpenImageIO, the Debian package libopenimageio2.4", found.string(),
                                         reason ? reason : "unknown reason"));
    }
    const auto* const interface = static_cast<const LancerImages*>(::dlsym(module, "lancer_images"));
    if (!interface || interface->version != lancer_images_version) {
        throw MachineFailure(fmt::format("{} belongs to another version of lancer", found.string()));
    }
    return *interface;
}

}  // namespace

const LancerImages& images_module() {
    static const LancerImages& module = load();
    return module;
}

}  // namespace lancer
