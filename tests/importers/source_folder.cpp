#include "importers/reading.h"

namespace lancer::testing {

std::filesystem::path source_folder() { return LANCER_SOURCE_FOLDER; }

}  // namespace lancer::testing
