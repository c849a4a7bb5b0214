// What lamps and surroundings send to a point, straight or through transparent bodies.
#ifndef LANCER_KERNEL_LIGHTING_H
#define LANCER_KERNEL_LIGHTING_H

#include "lancer/kernel/emitter/sky.h"
#include "lancer/kernel/intersect.h"
#include "lancer/kernel/light.h"
#include "lancer/kernel/refraction.h"
#include "lancer/kernel/surface.h"
#include "lancer/kernel/tally.h"

NAMESPACE_BEGIN

const int SHADOW_SURFACES = 32;  // that light may pass through on its way

FN Vec3 background(IN(WorldRecord) world, Vec3 direction, Mask mask) {
    Spectrum sky = sky_radiance(world, direction, vec4_all(Float(D_LINE)), mask);
    return vec3_of(sky.x, sky.y, sky.z);
}

// How much of a lamp's light arrives through transparent bodies, which dim it and do not bend it on this way. `start`: what the ray's origin is
// inside of.
FN_LARGE Vec3 light_through(IN(WorldRecord) world, IN(Ray) ray, IN(Media) start, Mask alive, INOUT(RayTally) tally) {
    Vec3 passes = vec3_all(Float(1.0f));
    Ray rest = ray;
    Media media = start;
    Mask going = alive;
    for (int i = 0; i < SHADOW_SURFACES && some(going); ++i) {
        tally.shadow += lanes_in(going);
        Hit hit = closest_hit(world, rest, going);
        Mask arrives = without(going, is_above(hit.object, Int(-1)));
        passes = passes * transmittance(world, media.first, rest.reach, arrives);
        going = without(going, arrives);
        if (some(going)) {
            SurfacePoint point = no_surface();
            Finish finish = no_finish();
            find_surface(world, rest, hit, going, point, finish);
            Float through = finish.transparency * (Float(1.0f) - finish.reflectivity);
            Mask leaves = dot(point.normal, rest.direction) > Float(0.0f);
            Int medium = medium_before(media, finish.material, leaves);
            passes = select(going, passes * through * transmittance(world, medium, hit.t, going), passes);
            media = select_media(leaves, left(media, finish.material), entered(media, finish.material));
            going = both(going, through > Float(0.0f));
            Vec3 next = leave_surface(point.position, point.error, point.normal, rest.direction);
            rest.reach = select(rest.reach < Float(FAR), rest.reach - dot(next - rest.origin, rest.direction), rest.reach);
            rest.origin = select(going, next, rest.origin);
            going = both(going, rest.reach > Float(0.0f));
        }
    }
    return select(going, vec3_all(Float(0.0f)), passes);
}

// Ambient, diffuse and highlight of every lamp at the point; `normal` faces the viewer, who sees it through `media`.
FN Vec3 local_light(IN(WorldRecord) world, IN(SurfacePoint) point, Vec3 normal, Vec3 shading, IN(Finish) finish, IN(Media) media, Vec3 view,
                    Mask here, INOUT(RayTally) tally) {
    Float body = (Float(1.0f) - finish.reflectivity) * (Float(1.0f) - finish.transparency);
    Vec3 diffuse = finish.color * (finish.diffuse * body);
    Vec3 light_sum = broadcast(world.ambient) * finish.color * (finish.ambient * body);
    Vec3 mirrored = mirror(view, shading);
    for (int i = 0; i < world.light_count; ++i) {
        LightRecord light = AT(world.lights, i);
        LightSample s = sample_light(light, point.position);
        Float cosine = dot(shading, s.direction);
        Mask lit = both(here, both(cosine > Float(0.0f), both(dot(normal, s.direction) > Float(0.0f), s.share > Float(0.0f))));
        if (some(lit)) {
            Ray shadow;
            shadow.origin = leave_surface(point.position, point.error, normal, s.direction);
            shadow.direction = s.direction;
            shadow.reach = s.distance;
            Vec3 arrives = broadcast(light.radiance) * s.share;
            if (world.has_transparency != 0) {
                arrives = arrives * light_through(world, shadow, media, lit, tally);
            } else {
                tally.shadow += lanes_in(lit);
                lit = without(lit, occluded(world, shadow, lit));
            }
            if (some(lit)) {
                Float glance = dot(mirrored, s.direction);
                Vec3 brought = diffuse * cosine;
                if (some(both(lit, glance > Float(0.0f)))) {
                    brought = brought + vec3_all(finish.highlight * power(max(glance, Float(0.0f)), finish.shininess));
                }
                light_sum = select(lit, light_sum + arrives * brought, light_sum);
            }
        }
    }
    return light_sum;
}

NAMESPACE_END

#endif
