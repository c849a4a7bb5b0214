#include "lancer/image/images_module.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "lancer/base/failure.h"

namespace lancer {
namespace {

namespace fs = std::filesystem;

constexpr const char* file_name = "lancer_images.so";

std::vector<std::string> module_folders() {
    std::vector<std::string> folders;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
    if (!error) {
        folders.push_back(program.string());
        // bin/../lib/lancer, wherever the installation was moved.
        folders.push_back((program / LANCER_MODULES_FROM_PROGRAM).lexically_normal().string());
    }
    folders.emplace_back(LANCER_MODULES_BUILT);      // for the tests
    folders.emplace_back(LANCER_MODULES_INSTALLED);  // for other programs that link the installed libraries
    return folders;
}

// Null and a sentence when the file can't be used. A module is never unloaded: OpenImageIO has threads of its own.
const LancerImages* open_module(const std::string& file, std::string& problem) {
    void* const module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!module) {
        const char* const reason = ::dlerror();
        problem = fmt::format("cannot load {}: {}; it needs OpenImageIO, the Debian package libopenimageio2.4", file,
                              reason ? reason : "for an unknown reason");
        return nullptr;
    }
    const auto* const images = static_cast<const LancerImages*>(::dlsym(module, "lancer_images"));
    if (!images || images->version != lancer_images_version) {
        problem = fmt::format("{} belongs to another version of lancer", file);
        return nullptr;
    }
    return images;
}

}  // namespace

const LancerImages& load_images_module(const std::vector<std::string>& folders) {
    std::string problem;
    for (const std::string& folder : folders) {
        std::error_code error;
        const fs::path file = fs::path(folder) / file_name;
        if (!fs::is_regular_file(file, error)) {
            continue;
        }
        if (const LancerImages* const images = open_module(file.string(), problem)) {
            return *images;
        }
    }
    std::string ignored;
    if (const LancerImages* const images = open_module(file_name, ignored)) {
        return *images;
    }
    throw MachineFailure(!problem.empty() ? problem
                                          : fmt::format("{}, the part of lancer that reads images other than PNG and writes JPEG and TIFF, "
                                                        "is not in {}; it is built when the Debian package libopenimageio-dev is installed",
                                                        file_name, fmt::join(folders, ", ")));
}

const LancerImages& images_module() {
    static const LancerImages& module = load_images_module(module_folders());
    return module;
}

}  // namespace lancer
