#include "lancer/import/pbrt/pbrt.h"

#include "lancer/import/pbrt/interpreter.h"

namespace lancer {

void read_pbrt(ImportContext& context, scene::Scene& scene) { pbrt::Interpreter(context, scene).run(); }

}  // namespace lancer
