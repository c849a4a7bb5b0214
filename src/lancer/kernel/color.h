// Linear RGB and how bright it looks.
#ifndef LANCER_KERNEL_COLOR_H
#define LANCER_KERNEL_COLOR_H

#include "lancer/kernel/math.h"

NAMESPACE_BEGIN

// Relative luminance of linear sRGB [IEC 61966-2-1].
FN Float luminance(Vec3 rgb) { return rgb.x * Float(0.2126729f) + rgb.y * Float(0.7151522f) + rgb.z * Float(0.0721750f); }

// The sRGB transfer curve of a value clipped to [0, 1].
FN Float srgb_curve(Float linear) {
    Float x = clamp01(linear);
    return select(x <= Float(0.0031308f), x * Float(12.92f), Float(1.055f) * power(x, Float(1.0f / 2.4f)) - Float(0.055f));
}

NAMESPACE_END

#endif
