// Parts of lancer that are loaded when they are first needed, since the libraries that they bring along make every start slow.
#pragma once

#include <string>
#include <vector>

namespace lancer {

struct ModuleWords {
    const char* file;      // "lancer_images.so"
    const char* symbol;    // what it exports: a struct that begins with its version
    const char* library;   // that it needs: "OpenImageIO"
    const char* package;   // Debian's, with that library
    const char* what;      // "the part of lancer that ..."
    const char* to_build;  // Debian's package that it is built with
};

// Beside the program, in the library folder of the installation, in the folder where lancer was built.
std::vector<std::string> module_folders();

// The address of the symbol, of the module in the first folder that has one of this version, or else where the system keeps libraries. Throws
// MachineFailure with what is missing and which package has it. A module is never unloaded.
const void* find_module(const ModuleWords& words, int version, const std::vector<std::string>& folders);

}  // namespace lancer
