// A vertex of either half of a path, with all that is needed to join it to another one; and where those of light are kept.
#ifndef LANCER_KERNEL_BIDIRECTIONAL_VERTEX_H
#define LANCER_KERNEL_BIDIRECTIONAL_VERTEX_H

#include "lancer/kernel/path.h"

NAMESPACE_BEGIN

// Three sums over the other ways in which the same path could have been found: squares of the density of each over that of this way, but for the
// factors that only the next vertex knows [Georgiev 2012; differs: squares throughout, for the power heuristic]. `meet`: the way that joins right
// before the vertex; `join`: all earlier joints; `merge`: all earlier merged photons.
struct Ways {
    Float meet;
    Float join;
    Float merge;
};

struct BidirVertex {
    Vec3 position;
    Vec3 error;
    Vec3 normal;  // of the surface itself, on the side that the subpath came from
    Frame frame;  // of the shading normal, on that side
    Vec3 wo;      // where the subpath came from, in the frame
    Closure closure;
    Vec3 smooth_;  // as of PathVertex, and the next
    Float hills;
    Spectrum throughput;  // of the subpath up to here, but for what the vertex does
    Ways ways;
    Int front;       // the media on the subpath's side of the surface
    Int behind;      // and on the other
    Media around;    // all bodies on the subpath's side
    Media beyond;    // and where light goes that is let through
    Spectrum thick;  // of the medium that it floats in, its extinction per metre; of surfaces 1
    Mask floats;     // a point of a medium: there is no cosine
    Mask sheet;      // nothing is bent on its way through
    Mask pane;       // met only where it mirrors
    Mask disperses;
    Mask single;  // the subpath has given up all wavelengths but the first
    Mask valid;   // there is a vertex, and it can be joined to others
};

// The device keeps them, as many as paths have vertices, for each path that it follows: they are too large for a register file.
FN void keep_light_vertex(IN(WorldRecord) world, int number, IN(BidirVertex) vertex);
FN BidirVertex light_vertex(IN(WorldRecord) world, int number);

NAMESPACE_END

#endif
