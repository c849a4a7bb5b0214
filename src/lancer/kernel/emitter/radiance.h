// How much light an emitter sends to a point.
#ifndef LANCER_KERNEL_EMITTER_RADIANCE_H
#define LANCER_KERNEL_EMITTER_RADIANCE_H

#include "lancer/kernel/emitter/sample.h"
#include "lancer/kernel/emitter/thrown.h"
#include "lancer/kernel/light.h"

NAMESPACE_BEGIN

// What arrives at the point if nothing is in the way: radiance, or irradiance at right angles of lights without size.
FN Spectrum emitted_light(IN(WorldRecord) world, IN(EmitterRecord) emitter, IN(EmitterSample) s, Vec4 nanometres, Mask mask) {
    Spectrum light = black();
    if (emitter.kind == EMITTER_ENVIRONMENT) {
        light = sky_radiance(world, s.direction, nanometres, mask);
    } else if (emitter.object >= 0) {
        MaterialRecord material = AT(world.surfaces, emitter.material);
        Mask front = dot(s.point.normal, s.direction) < Float(0.0f);
        Mask shines = mask;
        if (emitter.two_sided == 0) {
            shines = both(mask, front);
        }
        light = select(shines, color_value(world, material.emission, s.point, nanometres, shines), light);
    } else {
        SurfacePoint point = s.point;
        if (emitter.light.texture >= 0) {
            point.uv = thrown_place(emitter, -s.direction).uv;
        }
        light = color_value(world, emitter.light, point, nanometres, mask);
        if (emitter.kind != EMITTER_DIRECTIONAL) {
            light = light / max(s.distance * s.distance, Float(SMALLEST));
        }
        if (emitter.kind == EMITTER_SPOT) {
            Float cosine = -dot(s.direction, broadcast(emitter.direction));
            light = light * spot_share(cosine, emitter.cos_outer, emitter.cos_inner, emitter.fade);
        }
        if (is_thrown(emitter)) {
            light = light * thrown_share(world, emitter, -s.direction, mask);
        }
    }
    return light;
}

NAMESPACE_END

#endif
