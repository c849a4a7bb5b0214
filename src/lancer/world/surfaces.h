// Materials that follow physics, as records; and colours as spectra.
#pragma once

#include "lancer/base/diagnostic.h"
#include "lancer/scene/scene.h"
#include "lancer/spectrum/curve.h"
#include "lancer/world/textures.h"
#include "lancer/world/world.h"

namespace lancer {

// Colours of a scene as records. Fills world.curves.
class Colors {
public:
    explicit Colors(World& world) : world_(world) {}

    kernel::ColorRecord constant(double value);
    kernel::ColorRecord reflectance(const scene::Color& color);
    kernel::ColorRecord reflectance(const CompiledTexture& texture);
    // A quantity of any size that is no light, such as an extinction in 1/m.
    kernel::ColorRecord quantity(const scene::Color& color, double scale = 1.0);
    kernel::ColorRecord light(const scene::Color& color, double strength = 1.0);
    kernel::ColorRecord light(const CompiledTexture& texture, double strength);
    // `rgb` stands for the curve where paths carry RGB.
    kernel::ColorRecord curve(const SpectralCurve& curve, const scene::Rgb& rgb);

    // At each nanometre of the visible; its number.
    int add_curve(const SpectralCurve& curve);

private:
    World& world_;
    int daylight_ = -1;  // D65, once it is needed
};

// What is left of light in a body that absorbs so much, in 1/m.
void set_clearness(const scene::Color& absorption, Colors& colors, kernel::MaterialRecord& record);

// Fills world.surfaces, one for each of scene.materials, which must all follow physics.
void compile_surfaces(const scene::Scene& scene, World& world, Textures& textures, Colors& colors, Diagnostics& diagnostics);

}  // namespace lancer
