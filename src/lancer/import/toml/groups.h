// Groups of shapes, which may place other groups.
#pragma once

#include "lancer/import/toml/contents.h"
#include "lancer/import/toml/includes.h"

namespace lancer::notation {

// Reads all [[group]] of the file and what stands outside of groups into Scene::groups, objects and placements; a group comes after those that
// it places. Errors: unknown groups, groups inside themselves, nested more than 64 deep, more than 10 million objects in all.
void read_groups_and_contents(Context& context, Materials& materials, const std::vector<Included>& included, const toml::table& root);

}  // namespace lancer::notation
