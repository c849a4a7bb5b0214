// Scene files, and what they read, that the program carries with it.
#pragma once

#include <span>
#include <string_view>

namespace lancer::app {

struct EmbeddedFile {
    std::string_view path;  // as in the source tree: "scenes/report/figure-1.toml"
    std::string_view bytes;
};

std::span<const EmbeddedFile> embedded_scenes();

constexpr std::string_view default_scene_path = "scenes/report/figure-1.toml";

}  // namespace lancer::app
