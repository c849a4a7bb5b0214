#include "lancer/app/window/window.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <fmt/format.h>

#include "lancer/app/cli/outputs.h"
#include "lancer/app/cli/progress.h"
#include "lancer/app/window/canvas.h"
#include "lancer/app/window/painter.h"
#include "lancer/app/window/sdl.h"
#include "lancer/base/failure.h"

namespace lancer::app {

namespace {

struct Destroy {
    void operator()(SDL_Window* window) const { sdl().DestroyWindow(window); }
    void operator()(SDL_Renderer* renderer) const { sdl().DestroyRenderer(renderer); }
    void operator()(SDL_Texture* texture) const { sdl().DestroyTexture(texture); }
};
template <typename T>
using Owned = std::unique_ptr<T, Destroy>;

template <typename T>
Owned<T> own(T* pointer, const char* what) {
    if (pointer == nullptr) {
        throw MachineFailure(fmt::format("{} could not be made: {}", what, sdl().GetError()));
    }
    return Owned<T>(pointer);
}

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

// The largest size with the picture's shape that leaves a little of the screen free, and is no larger than the picture.
SDL_Point window_size(int width, int height) {
    SDL_Rect usable = {0, 0, 1280, 720};
    sdl().GetDisplayUsableBounds(0, &usable);
    const double scale = std::min({1.0, 0.95 * usable.w / width, 0.9 * usable.h / height});
    return {std::max(1, static_cast<int>(std::lround(width * scale))), std::max(1, static_cast<int>(std::lround(height * scale)))};
}

// The largest rectangle in the middle of the window that has the picture's shape.
SDL_Rect letterbox(int window_width, int window_height, int width, int height) {
    const double scale = std::min(static_cast<double>(window_width) / width, static_cast<double>(window_height) / height);
    SDL_Rect box = {0, 0, std::max(1, static_cast<int>(std::lround(width * scale))),
                    std::max(1, static_cast<int>(std::lround(height * scale)))};
    box.x = (window_width - box.w) / 2;
    box.y = (window_height - box.h) / 2;
    return box;
}

class Window {
public:
    Window(const Prepared& prepared, const std::string& title, const std::string& save_as)
        : prepared_(prepared), title_(title), save_as_(save_as), canvas_(prepared.options.width, prepared.options.height, prepared.view) {
        const SDL_Point size = window_size(canvas_.width(), canvas_.height());
        window_ = own(sdl().CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size.x, size.y,
                                         SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI),
                      "the window");
        renderer_ = own(sdl().CreateRenderer(window_.get(), -1, 0), "the window's renderer");
        sdl().SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "linear");
        make_texture();
        draw();
    }

    void run() {
        Painter painter(prepared_, canvas_);
        bool told = false;
        while (!closed_) {
            SDL_Event event;
            if (sdl().WaitEventTimeout(&event, told ? 1000 : 30) != 0) {
                do {
                    handle(event);
                } while (sdl().PollEvent(&event) != 0);
            }
            upload_changes();
            if (redraw_) {
                draw();
            }
            if (!told) {
                told = painter.is_done();
                show_progress(painter);
            }
        }
    }

private:
    void make_texture() {
        texture_ = own(
            sdl().CreateTexture(renderer_.get(), SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_STREAMING, canvas_.width(), canvas_.height()),
            "the picture's texture");
        canvas_.forget_what_was_taken();
        upload_changes();
    }

    void upload_changes() {
        canvas_.take_changes([&](const std::uint32_t* pixels, int stride, const Tile& changed) {
            const SDL_Rect area = {changed.x0, changed.y0, changed.width(), changed.height()};
            sdl().UpdateTexture(texture_.get(), &area, pixels, stride * static_cast<int>(sizeof(std::uint32_t)));
            redraw_ = true;
        });
    }

    void draw() {
        int width = 1;
        int height = 1;
        sdl().GetRendererOutputSize(renderer_.get(), &width, &height);
        const SDL_Rect box = letterbox(width, height, canvas_.width(), canvas_.height());
        sdl().SetRenderDrawColor(renderer_.get(), 24, 24, 24, 255);
        sdl().RenderClear(renderer_.get());
        sdl().RenderCopy(renderer_.get(), texture_.get(), nullptr, &box);
        sdl().RenderPresent(renderer_.get());
        redraw_ = false;
    }

    void handle(const SDL_Event& event) {
        switch (event.type) {
            case SDL_QUIT:
                closed_ = true;
                break;
            case SDL_WINDOWEVENT:
                redraw_ = true;
                break;
            case SDL_RENDER_TARGETS_RESET:
            case SDL_RENDER_DEVICE_RESET:
                make_texture();
                break;
            case SDL_KEYDOWN:
                if (event.key.keysym.sym == SDLK_ESCAPE) {
                    closed_ = true;
                } else if (event.key.keysym.sym == SDLK_s && event.key.repeat == 0) {
                    save();
                }
                break;
            default:
                break;
        }
    }

    void show_progress(const Painter& painter) {
        std::string state;
        if (painter.is_done()) {
            const RenderStatistics& done = painter.statistics();
            state = in_words(done.seconds);
        } else {
            const RenderProgress progress = canvas_.progress();
            state = fmt::format("{:.0f} %", std::floor(100.0 * progress.share));
            if (progress.seconds > 1.0) {
                state += fmt::format(", {:.0f} s left", std::ceil(progress.seconds_left));
            }
        }
        state_ = state;
        set_title();
    }

    void set_title() {
        const std::string title = fmt::format("{}: {}, {}", title_, state_, note_);
        if (title != shown_title_) {
            shown_title_ = title;
            sdl().SetWindowTitle(window_.get(), title.c_str());
        }
    }

    void save() {
        try {
            write_film(save_as_, canvas_.snapshot(), prepared_);
            fmt::print("Saved as {}\n", save_as_);
            note_ = "saved as " + save_as_;
        } catch (const MachineFailure& failure) {
            fmt::print(stderr, "lancer: error: {}\n", failure.what());
            note_ = "could not be saved";
        }
        set_title();
        std::fflush(stdout);
    }

    const Prepared& prepared_;
    std::string title_;
    std::string save_as_;
    Canvas canvas_;
    Owned<SDL_Window> window_;
    Owned<SDL_Renderer> renderer_;
    Owned<SDL_Texture> texture_;
    std::string state_;             // how far the picture is
    std::string note_ = "S saves";  // or what came of it
    std::string shown_title_;
    bool redraw_ = true;
    bool closed_ = false;
};

}  // namespace

Display::Display() {
    // Left alone, SDL might take over a text console, or draw to nowhere.
    std::string drivers;
    if (is_set("SDL_VIDEODRIVER")) {
        drivers = std::getenv("SDL_VIDEODRIVER");
    } else if (is_set("DISPLAY")) {
        drivers = is_set("WAYLAND_DISPLAY") ? "x11,wayland" : "x11";
    } else if (is_set("WAYLAND_DISPLAY")) {
        drivers = "wayland";
    } else {
        reason_ = "neither DISPLAY nor WAYLAND_DISPLAY is set";
        return;
    }
    try {
        sdl().SetHint(SDL_HINT_VIDEODRIVER, drivers.c_str());
        there_ = sdl().InitSubSystem(SDL_INIT_VIDEO) == 0;
        if (!there_) {
            reason_ = sdl().GetError();
        }
    } catch (const MachineFailure& failure) {
        reason_ = failure.what();
    }
}

Display::~Display() {
    if (there_) {
        sdl().QuitSubSystem(SDL_INIT_VIDEO);
        sdl().Quit();
    }
}

void run_window(const Display&, const Prepared& prepared, const std::string& title, const std::string& save_as) {
    Window(prepared, title, save_as).run();
}

}  // namespace lancer::app
