// An affine map as a record.
#ifndef LANCER_KERNEL_AFFINE_RECORD_H
#define LANCER_KERNEL_AFFINE_RECORD_H

#include "lancer/kernel/language.h"

RECORDS_BEGIN

// By its rows: (x, y, z) -> row_i . (x, y, z) + shift_i.
struct AffineRecord {
    vec3 row_x;
    vec3 row_y;
    vec3 row_z;
    vec3 shift;
};

RECORDS_END

#endif
