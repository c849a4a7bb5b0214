// How many rays were followed, and what for.
#ifndef LANCER_KERNEL_TALLY_H
#define LANCER_KERNEL_TALLY_H

#include "lancer/kernel/language.h"

NAMESPACE_BEGIN

struct RayTally {
    int camera;
    int secondary;
    int shadow;
};

NAMESPACE_END

#endif
