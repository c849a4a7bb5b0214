// The report's integrator [Whitted 1980]: at each hit the light of every lamp that is not hidden, plus what the mirrored ray brings, plus what
// the refracted ray brings, down to a number of bounces. White light that meets a dispersive glass goes on as fixed wavelengths.
//
// The tree of rays is walked depth first: the reflected ray goes on at once, the refracted one waits on a stack. In lanes the same walk is made
// by all, each lane skipping what it has no part in, so that a lane adds up its light in the same order whoever goes beside it.
#ifndef LANCER_KERNEL_WHITTED_H
#define LANCER_KERNEL_WHITTED_H

#include "lancer/kernel/camera.h"
#include "lancer/kernel/intersect.h"
#include "lancer/kernel/light.h"
#include "lancer/kernel/refraction.h"
#include "lancer/kernel/surface.h"

NAMESPACE_BEGIN

const int WHITTED_STACK = 2 * MAX_BOUNCES + 2;  // two may wait for each bounce
const int SHADOW_SURFACES = 32;                 // that light may pass through on its way

struct WhittedPath {
    Vec3 origin;
    Vec3 direction;
    Vec3 weight;   // of what it brings, linear RGB
    Media media;
    Int band;      // the wavelength that carries it, -1 = white
    Mask alive;
    Mask splits;   // it comes from the camera's side to a dispersive surface, to be refracted there at `band`
    int bounce;
};

struct RayTally {
    int camera;
    int secondary;
    int shadow;
};

FN Vec3 background(IN(WorldRecord) world, Vec3 direction) {
    Float up = direction.y;
    Vec3 above = broadcast(world.horizon) + (broadcast(world.zenith) - broadcast(world.horizon)) * max(up, Float(0.0f));
    Vec3 below = broadcast(world.horizon) + (broadcast(world.nadir) - broadcast(world.horizon)) * max(-up, Float(0.0f));
    return select(up < Float(0.0f), below, above);
}

FN SurfacePoint no_surface() {
    SurfacePoint s;
    s.position = vec3_all(Float(0.0f));
    s.error = s.position;
    s.normal = s.position;
    s.shading = s.position;
    s.local = s.position;
    s.uv = vec2_of(Float(0.0f), Float(0.0f));
    return s;
}

FN Finish no_finish() {
    Finish f;
    f.color = vec3_all(Float(0.0f));
    f.ambient = Float(0.0f);
    f.diffuse = Float(0.0f);
    f.highlight = Float(0.0f);
    f.shininess = Float(0.0f);
    f.reflectivity = Float(0.0f);
    f.transparency = Float(0.0f);
    f.material = Int(-1);
    f.dispersive = Float(1.0f) < Float(0.0f);
    return f;
}

// How much of a lamp's light arrives through transparent bodies, which dim it and do not bend it on this way.
FN_LARGE Vec3 light_through(IN(WorldRecord) world, IN(Ray) ray, Mask alive, INOUT(RayTally) tally) {
    Vec3 passes = vec3_all(Float(1.0f));
    Ray rest = ray;
    Mask going = alive;
    for (int i = 0; i < SHADOW_SURFACES && some(going); ++i) {
        tally.shadow += lanes_in(going);
        Hit hit = closest_hit(world, rest, going);
        going = both(going, is_above(hit.object, Int(-1)));
        if (some(going)) {
            SurfacePoint point = no_surface();
            Finish finish = no_finish();
            find_surface(world, rest, hit, going, point, finish);
            Float through = finish.transparency * (Float(1.0f) - finish.reflectivity);
            Mask leaves = both(going, dot(point.normal, rest.direction) > Float(0.0f));
            Vec3 dimmed = passes * through * select(leaves, transmittance(world, finish.material, hit.t, leaves), vec3_all(Float(1.0f)));
            passes = select(going, dimmed, passes);
            going = both(going, through > Float(0.0f));
            Vec3 next = leave_surface(point.position, point.error, point.normal, rest.direction);
            rest.reach = select(rest.reach < Float(FAR), rest.reach - dot(next - rest.origin, rest.direction), rest.reach);
            rest.origin = select(going, next, rest.origin);
            going = both(going, rest.reach > Float(0.0f));
        }
    }
    return select(going, vec3_all(Float(0.0f)), passes);
}

// Ambient, diffuse and highlight of every lamp at the point; `normal` faces the viewer.
FN Vec3 local_light(IN(WorldRecord) world, IN(SurfacePoint) point, Vec3 normal, Vec3 shading, IN(Finish) finish, Vec3 view, Mask here,
                    INOUT(RayTally) tally) {
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
                arrives = arrives * light_through(world, shadow, lit, tally);
            } else {
                tally.shadow += lanes_in(lit);
                lit = without(lit, occluded(world, shadow, lit));
            }
            Float shine = finish.highlight * power(max(dot(mirrored, s.direction), Float(0.0f)), finish.shininess);
            light_sum = select(lit, light_sum + arrives * (diffuse * cosine + vec3_all(shine)), light_sum);
        }
    }
    return light_sum;
}

// The wavelength of each lane's band; the d line for white light.
FN Float band_wavelength(IN(WorldRecord) world, Int band, Mask alive) {
    Float nanometres = Float(D_LINE);
    Mask todo = both(alive, is_above(band, Int(-1)));
    while (some(todo)) {
        int number = first_of(band, todo);
        Mask mine = both(todo, is_equal(band, Int(number)));
        nanometres = select(mine, Float(AT(world.bands, number).nanometres), nanometres);
        todo = without(todo, mine);
    }
    return nanometres;
}

FN Vec3 band_weight(IN(WorldRecord) world, Int band, Mask alive) {
    Vec3 weight = vec3_all(Float(1.0f));
    Mask todo = both(alive, is_above(band, Int(-1)));
    while (some(todo)) {
        int number = first_of(band, todo);
        Mask mine = both(todo, is_equal(band, Int(number)));
        weight = select(mine, broadcast(AT(world.bands, number).weight), weight);
        todo = without(todo, mine);
    }
    return weight;
}

// Radiance (linear RGB) along each camera ray.
FN_LARGE Vec3 whitted_radiance(IN(WorldRecord) world, IN(Ray) camera, Mask alive, INOUT(RayTally) tally) {
    WhittedPath waiting[WHITTED_STACK];
    int waiting_count = 0;
    Mask nobody = without(alive, alive);
    WhittedPath path;
    path.origin = camera.origin;
    path.direction = camera.direction;
    path.weight = vec3_all(Float(1.0f));
    path.media = no_media();
    path.band = Int(-1);
    path.alive = alive;
    path.splits = nobody;
    path.bounce = 0;
    Vec3 radiance = vec3_all(Float(0.0f));
    bool going = some(alive);
    while (going) {
        if (path.bounce == 0) {
            tally.camera += lanes_in(path.alive);
        } else {
            tally.secondary += lanes_in(path.alive);
        }
        Ray ray;
        ray.origin = path.origin;
        ray.direction = path.direction;
        ray.reach = Float(FAR);
        Hit hit = closest_hit(world, ray, path.alive);
        Mask here = both(path.alive, is_above(hit.object, Int(-1)));
        Mask missed = without(path.alive, here);
        radiance = select(missed, radiance + path.weight * background(world, ray.direction), radiance);

        bool goes_on = false;
        if (some(here)) {
            SurfacePoint point = no_surface();
            Finish finish = no_finish();
            find_surface(world, ray, hit, here, point, finish);
            Vec3 view = -ray.direction;
            Mask inside = dot(point.normal, view) < Float(0.0f);
            Vec3 normal = select(inside, -point.normal, point.normal);
            Vec3 shading = select(inside, -point.shading, point.shading);
            shading = select(dot(shading, view) > Float(0.0f), shading, normal);

            if (world.has_transparency != 0) {
                path.weight = path.weight * transmittance(world, path.media.first, hit.t, here);
            }

            Mask shaded = without(here, path.splits);
            Vec3 local = local_light(world, point, normal, shading, finish, view, shaded, tally);
            radiance = select(shaded, radiance + path.weight * local, radiance);

            if (path.bounce < world.bounces) {
                Float cos_i = dot(shading, view);
                Float reflects = finish.reflectivity;
                Mask glass = both(here, finish.transparency > Float(0.0f));
                if (some(glass)) {
                    Media beyond = select_media(inside, left(path.media, finish.material), entered(path.media, finish.material));
                    // Leaving a body that was never entered: it must have been there all along.
                    Int behind = beyond.first;
                    Int front = select(inside, finish.material, path.media.first);
                    Mask white = is_equal(path.band, Int(-1));
                    Float d_line = Float(D_LINE);
                    Float nanometres = select(path.splits, d_line, band_wavelength(world, path.band, glass));
                    Float eta = refractive_index(world, behind, nanometres, glass) / refractive_index(world, front, nanometres, glass);
                    Float cos_t = Float(0.0f);
                    Float share = fresnel(cos_i, eta, cos_t);
                    Float body = (Float(1.0f) - finish.reflectivity) * finish.transparency;
                    reflects = select(glass, finish.reflectivity + body * share, reflects);
                    Float refracts = select(glass, body * (Float(1.0f) - share), Float(0.0f));

                    // White light before a dispersive glass waits to come back once for each wavelength.
                    Mask disperses = both(both(glass, finish.dispersive), both(white, refracts > Float(0.0f)));
                    if (world.band_count > 0 && some(disperses)) {
                        WhittedPath split = path;
                        split.alive = disperses;
                        split.splits = disperses;
                        split.band = Int(0);
                        waiting[waiting_count] = split;
                        ++waiting_count;
                    }

                    // The others are refracted now: white through plain glass, single wavelengths through any.
                    if (some(path.splits)) {
                        Float own = band_wavelength(world, path.band, path.splits);
                        Float own_eta = refractive_index(world, behind, own, glass) / refractive_index(world, front, own, glass);
                        Float own_cos_t = Float(0.0f);
                        Float own_share = fresnel(cos_i, own_eta, own_cos_t);
                        eta = select(path.splits, own_eta, eta);
                        cos_t = select(path.splits, own_cos_t, cos_t);
                        // Where this wavelength alone is totally reflected it takes the mirrored way below.
                        share = select(path.splits, own_share, share);
                    }
                    Mask bends = without(both(glass, refracts > Float(0.0f)), disperses);
                    bends = without(bends, share >= Float(1.0f));
                    if (some(bends)) {
                        WhittedPath child = path;
                        child.direction = refracted(ray.direction, shading, cos_i, cos_t, eta);
                        child.origin = leave_surface(point.position, point.error, normal, -normal);
                        child.weight = path.weight * refracts;
                        if (some(path.splits)) {
                            child.weight = select(path.splits, child.weight * band_weight(world, path.band, path.splits), child.weight);
                        }
                        child.media = beyond;
                        child.alive = bends;
                        child.splits = nobody;
                        child.bounce = path.bounce + 1;
                        waiting[waiting_count] = child;
                        ++waiting_count;
                    }
                    Mask turned_back = both(both(path.splits, glass), share >= Float(1.0f));
                    Vec3 turned_weight = path.weight * refracts * band_weight(world, path.band, turned_back);
                    path.weight = select(turned_back, turned_weight, path.weight);
                    reflects = select(path.splits, select(turned_back, Float(1.0f), Float(0.0f)), reflects);
                    path.splits = nobody;
                }
                Mask bounces = both(here, reflects > Float(0.0f));
                if (some(bounces)) {
                    Vec3 direction = normalize(mirror(view, shading));
                    // A smooth normal may send the mirrored ray under the surface: the true normal does not.
                    direction = select(dot(direction, normal) > Float(0.0f), direction, normalize(mirror(view, normal)));
                    path.origin = leave_surface(point.position, point.error, normal, direction);
                    path.direction = direction;
                    path.weight = path.weight * reflects;
                    path.alive = bounces;
                    path.splits = nobody;
                    ++path.bounce;
                    goes_on = true;
                }
            }
        }

        if (!goes_on) {
            going = waiting_count > 0;
            if (going) {
                --waiting_count;
                path = waiting[waiting_count];
                Mask again = both(path.splits, is_above(Int(world.band_count - 1), path.band));
                if (some(again)) {
                    waiting[waiting_count].alive = again;
                    waiting[waiting_count].splits = again;
                    waiting[waiting_count].band = path.band + Int(1);
                    ++waiting_count;
                }
            }
        }
    }
    return radiance;
}

NAMESPACE_END

#endif
