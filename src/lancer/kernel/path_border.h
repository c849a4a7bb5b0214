// What a path needs to know of the surface that it has met: the border of a body, a coat with a normal of its own, how wide the beam becomes.
#ifndef LANCER_KERNEL_PATH_BORDER_H
#define LANCER_KERNEL_PATH_BORDER_H

#include "lancer/kernel/frame.h"
#include "lancer/kernel/path_state.h"
#include "lancer/kernel/relief.h"
#include "lancer/kernel/surface.h"

NAMESPACE_BEGIN

// ---- The coat. ----------------------------------------------------------------------------------------------------------------------------

// The coat's normal, in the frame of what it covers, as it is seen from `view`.
FN Vec3 seen_coat(IN(PathVertex) vertex, IN(Frame) frame, Vec3 normal, Vec3 view) {
    Vec3 own = select(vertex.inside, -vertex.coat_normal, vertex.coat_normal);
    Mask has_own = dot(own, own) > Float(0.5f);
    return select(has_own, to_local(frame, seen_normal(normal, own, view)), vertex.closure.coat_normal);
}

// ---- Borders of bodies. ------------------------------------------------------------------------------------------------------------------

// The relative index of a clear border, at each wavelength, and the media beyond.
FN void find_border(IN(WorldRecord) world, IN(PathState) path, Mask clear, Mask thin, INOUT(PathVertex) vertex, INOUT(Media) beyond) {
    beyond = select_media(vertex.inside, left(path.media, vertex.material), entered(path.media, vertex.material));
    Int front = medium_before(path.media, vertex.material, vertex.inside);
    Int behind = beyond.first;
    if (world.has_media != 0) {
        beyond = crossed(world, path.media, vertex.material, vertex.inside, clear);
        Mask found = without(vertex.inside, is_inside(path.media, vertex.material));
        front = select(found, vertex.material, bending_body(world, path.media, clear));
        behind = bending_body(world, beyond, clear);
    }
    // A pane has air on both sides; what bends is its own material.
    front = select(thin, Int(-1), front);
    behind = select(thin, vertex.material, behind);
    Spectrum eta = refractive_indices(world, behind, path.nanometres, clear) / refractive_indices(world, front, path.nanometres, clear);
    if (world.spectral != 0) {
        Mask disperses = either(is_dispersive(world, front, clear), is_dispersive(world, behind, clear));
        if (some(disperses)) {
            // A path that has given up its other wavelengths has none to give up again.
            Mask several = max(max(path.throughput.y, path.throughput.z), path.throughput.w) > Float(0.0f);
            vertex.closure.disperses = both(without(disperses, thin), several);
        }
    }
    vertex.closure.index = select(clear, eta, vertex.closure.index);
}

// A direction drawn with that density stands for its share of all directions: a cone of the solid angle 1 / density. The beam takes part of its
// width, so that distant textures are looked up in small copies, and what is lost of them is finer than the light that they scatter can show.
const float SCATTERED_SHARE = 0.125f;

FN Float scattered_spread(Float density) {
    return select(density > Float(0.0f), Float(2.0f * SCATTERED_SHARE) / sqrt(max(density, Float(1.0e-3f)) * Float(PI)), Float(0.0f));
}

NAMESPACE_END

#endif
