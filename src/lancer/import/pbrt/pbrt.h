// Scenes of pbrt-v4, and of pbrt-v3 as far as their words can be taken over.
#pragma once

#include "lancer/import/reader.h"

namespace lancer {

// See SUPPORT.md for what is read. Memory stays within a small multiple of the files' sizes, whatever they hold.
void read_pbrt(ImportContext& context, scene::Scene& scene);

}  // namespace lancer
