// The report's integrator [Whitted 1980]: at each hit the light of every lamp that is not hidden, plus what the mirrored ray brings, plus what
// the refracted ray brings, down to a number of bounces. White light that meets a dispersive glass goes on as fixed wavelengths.
//
// The tree of rays is walked depth first: the reflected ray goes on at once, the refracted one waits on a stack. In lanes the same walk is made
// by all, each lane skipping what it has no part in, so that a lane adds up its light in the same order whoever goes beside it.
#ifndef LANCER_KERNEL_WHITTED_H
#define LANCER_KERNEL_WHITTED_H

#include "lancer/kernel/camera.h"
#include "lancer/kernel/lighting.h"
#include "lancer/kernel/spectral.h"

NAMESPACE_BEGIN

const int WHITTED_STACK = 2 * MAX_BOUNCES + 2;  // two may wait for each bounce

struct WhittedPath {
    Vec3 origin;
    Vec3 direction;
    Vec3 weight;  // of what it brings, linear RGB
    Media media;
    Int band;  // the wavelength that carries it, -1 = white
    Mask alive;
    Mask splits;  // it comes from the camera's side to a dispersive surface, to be refracted there at `band`
    int bounce;
};

// Paths that bring too little are not followed. A single wavelength has its share of white light's weight, and of the limit.
FN Mask is_worth_following(IN(WorldRecord) world, Vec3 weight, Int band) {
    Vec3 size = abs(weight);
    Float limit = Float(world.min_weight);
    if (world.band_count > 0) {
        limit = select(is_above(band, Int(-1)), limit * Float(1.0f / float(world.band_count)), limit);
    }
    return max(max(size.x, size.y), size.z) >= limit;
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
            tally.camera += lanes_in(without(path.alive, path.splits));
            tally.secondary += lanes_in(path.splits);
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
        radiance = select(missed, radiance + path.weight * background(world, ray.direction, missed), radiance);

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

            Mask shaded = without(here, path.splits);
            if (world.has_transparency != 0) {
                path.weight = path.weight * transmittance(world, medium_before(path.media, finish.material, inside), hit.t, shaded);
            }
            Vec3 local = local_light(world, point, normal, shading, finish, path.media, view, shaded, tally);
            radiance = select(shaded, radiance + path.weight * local, radiance);

            if (path.bounce < world.bounces) {
                Float cos_i = dot(shading, view);
                Float reflects = finish.reflectivity;
                Mask glass = both(here, finish.transparency > Float(0.0f));
                if (some(glass)) {
                    Float nanometres = select(path.splits, Float(D_LINE), band_wavelength(world, path.band, glass));
                    Border border = border_at(world, path.media, finish.material, inside, cos_i, nanometres, glass);
                    Float body = (Float(1.0f) - finish.reflectivity) * finish.transparency;
                    reflects = select(glass, finish.reflectivity + body * border.share, reflects);
                    Float refracts = select(glass, body * (Float(1.0f) - border.share), Float(0.0f));

                    // White light before a dispersive glass waits, to come back once for each wavelength.
                    Mask disperses = both(both(glass, finish.dispersive), both(is_equal(path.band, Int(-1)), refracts > Float(0.0f)));
                    if (some(disperses)) {
                        waiting[waiting_count] = path;
                        waiting[waiting_count].alive = disperses;
                        waiting[waiting_count].splits = disperses;
                        waiting[waiting_count].band = select(disperses, Int(0), path.band);
                        ++waiting_count;
                    }

                    // Here it is again: it brings its wavelength's share of what white light refracts. Where this wavelength alone is totally
                    // reflected that goes the mirrored way; what white light reflects was followed the first time.
                    if (some(path.splits)) {
                        Float own = band_wavelength(world, path.band, path.splits);
                        Border own_border = border_at(world, path.media, finish.material, inside, cos_i, own, path.splits);
                        border = select_border(path.splits, own_border, border);
                        Mask turned_back = both(path.splits, border.share >= Float(1.0f));
                        path.weight = select(path.splits, path.weight * band_weight(world, path.band, path.splits), path.weight);
                        reflects = select(path.splits, select(turned_back, refracts, Float(0.0f)), reflects);
                    }

                    Vec3 refracted_weight = path.weight * refracts;
                    Mask bends = both(without(glass, disperses), both(refracts > Float(0.0f), border.share < Float(1.0f)));
                    bends = both(bends, is_worth_following(world, refracted_weight, path.band));
                    if (some(bends)) {
                        waiting[waiting_count] = path;
                        waiting[waiting_count].direction = refracted_below(ray.direction, shading, normal, cos_i, border);
                        waiting[waiting_count].origin = leave_surface(point.position, point.error, normal, -normal);
                        waiting[waiting_count].weight = refracted_weight;
                        waiting[waiting_count].media = border.beyond;
                        waiting[waiting_count].alive = bends;
                        waiting[waiting_count].splits = nobody;
                        waiting[waiting_count].bounce = path.bounce + 1;
                        ++waiting_count;
                    }
                }
                Vec3 mirrored_weight = path.weight * reflects;
                Mask bounces = both(both(here, reflects > Float(0.0f)), is_worth_following(world, mirrored_weight, path.band));
                if (some(bounces)) {
                    Vec3 direction = normalize(mirror(view, shading));
                    // A smooth normal may send the mirrored ray under the surface: the true normal does not.
                    direction = select(dot(direction, normal) > Float(0.0f), direction, normalize(mirror(view, normal)));
                    path.origin = leave_surface(point.position, point.error, normal, direction);
                    path.direction = direction;
                    path.weight = mirrored_weight;
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
