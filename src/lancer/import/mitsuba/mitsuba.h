// Mitsuba's XML scenes: see SUPPORT.md.
#pragma once

#include "lancer/import/reader.h"

namespace lancer {

void read_mitsuba(ImportContext& context, scene::Scene& scene);

}  // namespace lancer
