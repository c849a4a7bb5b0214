// SDL, loaded when a window is wanted: linking it costs every start of the program 7 ms, and a machine without a screen need not have it.
#pragma once

#include <SDL.h>

namespace lancer::app {

// The functions in use, by their names without SDL_.
#define LANCER_SDL_FUNCTIONS(F) \
    F(CreateRenderer)           \
    F(CreateTexture)            \
    F(CreateWindow)             \
    F(DestroyRenderer)          \
    F(DestroyTexture)           \
    F(DestroyWindow)            \
    F(GetDisplayUsableBounds)   \
    F(GetError)                 \
    F(GetRendererOutputSize)    \
    F(InitSubSystem)            \
    F(PollEvent)                \
    F(Quit)                     \
    F(QuitSubSystem)            \
    F(RenderClear)              \
    F(RenderCopy)               \
    F(RenderPresent)            \
    F(SetHint)                  \
    F(SetRenderDrawColor)       \
    F(SetWindowTitle)           \
    F(UpdateTexture)            \
    F(WaitEventTimeout)

struct Sdl {
#define LANCER_SDL_MEMBER(name) decltype(&SDL_##name) name = nullptr;
    LANCER_SDL_FUNCTIONS(LANCER_SDL_MEMBER)
#undef LANCER_SDL_MEMBER
};

// Loads it when called first. Throws MachineFailure where it is not installed.
const Sdl& sdl();

}  // namespace lancer::app
