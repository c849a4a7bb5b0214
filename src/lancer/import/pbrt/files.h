// Where the files lie that a scene names.
#pragma once

#include <string>

#include "lancer/import/pbrt/source_text.h"
#include "lancer/import/reader.h"

namespace lancer::pbrt {

// Beside the scene file; what is not there is looked for beside the file that names it.
std::string find_file(const ImportContext& context, const std::string& name, const SourceText& named_in);

}  // namespace lancer::pbrt
