// Signs of pbrt-v3, whose files differ in a few words.
#pragma once

#include <optional>

#include "lancer/base/diagnostic.h"
#include "lancer/import/pbrt/syntax.h"

namespace lancer::pbrt {

// Where the first word stands that only version 3 knows.
std::optional<SourcePosition> sign_of_version3(const Syntax& syntax);

}  // namespace lancer::pbrt
