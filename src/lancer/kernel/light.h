// Lights without size, as seen from a point.
#ifndef LANCER_KERNEL_LIGHT_H
#define LANCER_KERNEL_LIGHT_H

#include "lancer/kernel/math.h"
#include "lancer/kernel/ray.h"
#include "lancer/kernel/records.h"

NAMESPACE_BEGIN

struct LightSample {
    Vec3 direction;  // towards the light, length 1
    Float distance;
    Float share;  // 0 outside a spot's cone, 1 in its middle; distance does not dim a light of the report
};

// An angle from 0 to pi by its cosine.
FN Float angle_of_cosine(Float cosine) {
    Float c = min(max(cosine, Float(-1.0f)), Float(1.0f));
    return angle_of(sqrt((Float(1.0f) - c) * (Float(1.0f) + c)), c);
}

// Of a spot's light at an angle of this cosine from its axis: 1 within the inner cone, 0 outside the outer one, between them as `fade` says.
FN Float spot_share(Float cosine, float cos_outer, float cos_inner, int fade) {
    Float x = clamp01((cosine - Float(cos_outer)) / Float(cos_inner - cos_outer));
    Float share = x * x * (Float(3.0f) - Float(2.0f) * x);
    if (fade == FADE_EVEN) {
        Float outer = angle_of_cosine(Float(cos_outer));
        share = clamp01((outer - angle_of_cosine(cosine)) / max(outer - angle_of_cosine(Float(cos_inner)), Float(1.0e-6f)));
    } else if (fade == FADE_SQUARE) {
        share = x * x;
    }
    return share;
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
        s.share = spot_share(cosine, light.cos_outer, light.cos_inner, light.fade);
    }
    return s;
}

NAMESPACE_END

#endif
