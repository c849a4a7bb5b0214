// The two questions that a path asks of the scene. Each device brings its own answers: the functions below, defined where the kernel is
// compiled. Both look at lanes of `alive` only.
#ifndef LANCER_KERNEL_INTERSECT_H
#define LANCER_KERNEL_INTERSECT_H

#include "lancer/kernel/ray.h"
#include "lancer/kernel/records.h"

NAMESPACE_BEGIN

// The first object along each ray, within its reach. Of two at the same distance the one with the smaller number.
FN Hit closest_hit(IN(WorldRecord) world, IN(Ray) ray, Mask alive);

// Which rays meet anything within their reach.
FN Mask occluded(IN(WorldRecord) world, IN(Ray) ray, Mask alive);

NAMESPACE_END

#endif
