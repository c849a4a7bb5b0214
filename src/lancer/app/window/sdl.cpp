#include "lancer/app/window/sdl.h"

#include <dlfcn.h>

#include <fmt/format.h>

#include "lancer/base/failure.h"

namespace lancer::app {

namespace {

constexpr const char* library_name = "libSDL2-2.0.so.0";

template <typename Function>
void find(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (function == nullptr) {
        throw MachineFailure(fmt::format("{} is too old: it has no {}", library_name, name));
    }
}

Sdl load() {
    // Never unloaded: it may have threads of its own.
    void* const library = dlopen(library_name, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        throw MachineFailure(fmt::format("{} can't be loaded; the Debian package is libsdl2-2.0-0", library_name));
    }
    Sdl result;
#define LANCER_SDL_FIND(name) find(library, "SDL_" #name, result.name);
    LANCER_SDL_FUNCTIONS(LANCER_SDL_FIND)
#undef LANCER_SDL_FIND
    return result;
}

}  // namespace

const Sdl& sdl() {
    static const Sdl functions = load();
    return functions;
}

}  // namespace lancer::app
