#include "lancer/image/aces/aces_module.h"

#include "lancer/image/modules.h"

namespace lancer {

const LancerAces& load_aces_module(const std::vector<std::string>& folders) {
    static constexpr ModuleWords words = {
        "lancer_aces.so",    "lancer_aces", "OpenColorIO", "libopencolorio2.1", "the part of lancer that has the view aces",
        "libopencolorio-dev"};
    return *static_cast<const LancerAces*>(find_module(words, lancer_aces_version, folders));
}

const LancerAces& aces_module() {
    static const LancerAces& module = load_aces_module(module_folders());
    return module;
}

}  // namespace lancer
