#include "lancer/app/cli/picture_words.h"

#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>

#include "lancer/app/cli/spelling.h"
#include "lancer/base/failure.h"
#include "lancer/image/layers.h"

namespace lancer::app {

std::optional<PictureWords> words_of_picture(const std::string& path) {
    PictureWords found;
    try {
        found.metadata = read_layers(path).metadata;
    } catch (const MachineFailure&) {
        throw;
    } catch (const std::runtime_error& error) {
        fmt::print(stderr, "lancer: error: {}\n", error.what());
        return std::nullopt;
    }
    const auto command = found.metadata.find("lancer:command");
    const auto words = command == found.metadata.end() ? std::nullopt : shell_words(command->second);
    if (!words || words->size() < 3 || words->at(1) != "render") {
        fmt::print(stderr, "lancer: error: {} does not say how it was rendered\n", path);
        return std::nullopt;
    }
    found.words.assign(words->begin() + 1, words->end());
    return found;
}

}  // namespace lancer::app
