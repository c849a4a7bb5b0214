// Reading scenes from strings, and what was said about them.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/import/import.h"
#include "temporary_folder.h"

namespace lancer::testing {

struct Reading {
    std::optional<scene::Scene> scene;
    std::vector<std::string> messages;

    std::string all() const {
        std::string text;
        for (const std::string& message : messages) {
            text += message + "\n";
        }
        return text;
    }
};

inline Reading gather(std::optional<scene::Scene> scene, const Diagnostics& diagnostics) {
    Reading reading{std::move(scene), {}};
    for (const Diagnostic& diagnostic : diagnostics.list()) {
        reading.messages.push_back(to_string(diagnostic));
    }
    return reading;
}

inline Reading read_text(std::string_view text, const std::string& path = "scene.toml") {
    Diagnostics diagnostics;
    auto scene = import_toml(text, path, diagnostics);
    return gather(std::move(scene), diagnostics);
}

inline Reading read_path(const std::string& path) {
    Diagnostics diagnostics;
    auto scene = import_scene(path, diagnostics);
    return gather(std::move(scene), diagnostics);
}

// A text that must be fine, with a light and a shape added so that it is a whole scene.
inline scene::Scene read_part(const std::string& part) {
    const Reading reading = read_text(part + "\n[[light]]\ntype = 'point'\nposition = [0, 5, 0]\n");
    EXPECT_TRUE(reading.scene) << reading.all();
    return reading.scene.value_or(scene::Scene{});
}

using tests::TemporaryFolder;

// Of the whole project.
std::filesystem::path source_folder();

}  // namespace lancer::testing
