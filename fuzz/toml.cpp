// Any bytes as a scene file: a scene or at least one error, and nothing else.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "lancer/import/import.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    lancer::Diagnostics diagnostics;
    const auto scene = lancer::import_toml({reinterpret_cast<const char*>(data), size}, "/nowhere/scene.toml", diagnostics);
    if (scene.has_value() == diagnostics.has_errors()) {
        std::abort();
    }
    if (scene && (scene->cameras.empty() || scene->hash.size() != 32)) {
        std::abort();
    }
    return 0;
}
