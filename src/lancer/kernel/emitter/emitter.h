// Everything that gives light, seen from a point: which emitter is asked, where on it, with what density, and what it sends.
#ifndef LANCER_KERNEL_EMITTER_EMITTER_H
#define LANCER_KERNEL_EMITTER_EMITTER_H

#include "lancer/kernel/emitter/choice.h"
#include "lancer/kernel/emitter/radiance.h"
#include "lancer/kernel/emitter/sample.h"

#endif
