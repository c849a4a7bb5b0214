// The module with OpenImageIO in it, loaded when it is first needed.
#pragma once

#include <string>
#include <vector>

#include "lancer/image/module/interface.h"

namespace lancer {

// Looked for beside the program, in the library folder of the installation, in the folder where lancer was built, and where the system keeps
// libraries. Throws MachineFailure with what is missing and which package has it.
const LancerImages& images_module();

// The module of the first folder that has one of this version.
const LancerImages& load_images_module(const std::vector<std::string>& folders);

}  // namespace lancer
