#include "lancer/image/modules.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "lancer/base/failure.h"

namespace lancer {
namespace {

namespace fs = std::filesystem;

// Null and a sentence when the file can't be used.
const void* open_module(const ModuleWords& words, int version, const std::string& file, std::string& problem) {
    void* const module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!module) {
        const char* const reason = ::dlerror();
        problem = fmt::format("cannot load {}: {}; it needs {}, the Debian package {}", file, reason ? reason : "for an unknown reason",
                              words.library, words.package);
        return nullptr;
    }
    const void* const found = ::dlsym(module, words.symbol);
    if (!found || *static_cast<const int*>(found) != version) {
        problem = fmt::format("{} belongs to another version of lancer", file);
        return nullptr;
    }
    return found;
}

}  // namespace

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

const void* find_module(const ModuleWords& words, int version, const std::vector<std::string>& folders) {
    std::string problem;
    for (const std::string& folder : folders) {
        std::error_code error;
        const fs::path file = fs::path(folder) / words.file;
        if (!fs::is_regular_file(file, error)) {
            continue;
        }
        if (const void* const found = open_module(words, version, file.string(), problem)) {
            return found;
        }
    }
    std::string ignored;
    if (const void* const found = open_module(words, version, words.file, ignored)) {
        return found;
    }
    throw MachineFailure(!problem.empty() ? problem
                                          : fmt::format("{}, {}, is not in {}; it is built when the Debian package {} is installed",
                                                        words.file, words.what, fmt::join(folders, ", "), words.to_build));
}

}  // namespace lancer
