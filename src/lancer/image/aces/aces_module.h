// The module with OpenColorIO in it, loaded when it is first needed.
#pragma once

#include <string>
#include <vector>

#include "lancer/image/aces/module/interface.h"

namespace lancer {

// Throws MachineFailure with what is missing and which package has it.
const LancerAces& aces_module();

// The module of the first folder that has one of this version.
const LancerAces& load_aces_module(const std::vector<std::string>& folders);

}  // namespace lancer
