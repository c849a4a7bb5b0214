// Lights that throw a picture, as records.
#pragma once

#include "lancer/scene/color.h"
#include "lancer/scene/lights.h"
#include "lancer/world/surfaces.h"
#include "lancer/world/textures.h"
#include "lancer/world/world.h"

namespace lancer {

// Fill the record, but for its index into the world's tables of emitters; and the tables of shares and intensities. `power`: see scene::Light.
void compile_thrown(const scene::ProjectorLight& light, const scene::Color& power, World& world, Textures& textures, Colors& colors,
                    kernel::EmitterRecord& record);
// A spot's picture; the rest of the record has been filled.
void compile_thrown(const scene::SpotLight& light, const scene::Color& power, World& world, Textures& textures, Colors& colors,
                    kernel::EmitterRecord& record);
void compile_thrown(const scene::GoniometricLight& light, const scene::Color& power, World& world, Textures& textures, Colors& colors,
                    kernel::EmitterRecord& record);
void compile_thrown(const scene::IesLight& light, const scene::Color& power, World& world, Colors& colors, kernel::EmitterRecord& record);

}  // namespace lancer
