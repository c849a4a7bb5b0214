// Lights without size, as seen from a point.
#ifndef LANCER_KERNEL_LIGHT_H
#define LANCER_KERNEL_LIGHT_H

#include "lancer/kernel/ray.h"
#include "lancer/kernel/records.h"

NAMESPACE_BEGIN

struct LightSample {
    Vec3 direction;  // towards the light, length 1
    Float distance;
    Float share;  // 0 outside a spot's cone, 1 in its middle; distance does not dim a light of the report
};

// Of a spot's light at an angle of this cosine from its axis: 1 within the inner cone, 0 outside the outer one, smooth between them.
FN Float spot_share(Float cosine, float cos_outer, float cos_inner) {
    Float x = clamp01((cosine - Float(cos_outer)) / Float(cos_inner - cos_outer));
    return x * x * (Float(3.0f) - Float(2.0f) * x);
}

FN LightSample sample_light(IN(LightRecord) light, Vec3 from) {
    LightSample s;
    s.direction = broadcast(-light.direction);
    s.distance = Float(FAR);
    s.share = Float(1.0f);
    if (light.kind != LIGHT_DIRECTIONAL) {
        Vec3 way = broadcast(light.position) - from;
        s.distance = length(way);
        s.direction = way / max(s.distance, Float(SMALLEST));
    }
    if (light.kind == LIGHT_SPOT) {
        Float cosine = -dot(s.direction, broadcast(light.direction));
        s.share = spot_share(cosine, light.cos_outer, light.cos_inner);
    }
    return s;
}

NAMESPACE_END

#endif
