// Which bodies a lamp stands in: the camera's are found when the world is made; lamps may reach through many.
#ifndef LANCER_KERNEL_BIDIRECTIONAL_AROUND_H
#define LANCER_KERNEL_BIDIRECTIONAL_AROUND_H

#include "lancer/kernel/volume/passage.h"

NAMESPACE_BEGIN

// A ray that leaves them all passes their borders: what it leaves without having entered it was around its start, the innermost first. Of more than four
// those stay that count: of the highest priorities, and of equals the innermost.
FN_LARGE Media media_around(IN(WorldRecord) world, Vec3 origin, Vec3 direction, Mask alive) {
    Media around = no_media();
    Media since = no_media();
    Ray ray;
    ray.origin = origin;
    ray.direction = direction;
    ray.reach = Float(FAR);
    Mask todo = alive;
    for (int i = 0; i < MOST_BORDERS && some(todo); ++i) {
        Hit hit = closest_hit(world, ray, todo);
        todo = both(todo, is_above(hit.object, Int(-1)));
        Vec3 next = ray.origin;
        Mask left_over = todo;
        while (some(left_over)) {
            int number = first_of(hit.object, left_over);
            Mask mine = both(left_over, is_equal(hit.object, Int(number)));
            ObjectRecord object = AT(world.objects, number);
            SurfacePoint s = object_surface(world, object, ray, hit, mine);
            next = select(mine, leave_surface(s.position, s.error, s.normal, direction), next);
            MaterialRecord material = AT(world.surfaces, object.material);
            if (material.kind == BSDF_NULL || (material.flags & MATERIAL_BODY) != 0) {
                Mask inside = both(mine, dot(s.normal, direction) > Float(0.0f));
                Mask known = both(inside, is_inside(since, Int(object.material)));
                // Each is around those that were left before.
                around = entered_before(world, around, Int(object.material), without(inside, known));
                since = select_media(known, left(since, Int(object.material)), since);
                since = select_media(without(mine, inside), entered(since, Int(object.material)), since);
            }
            left_over = without(left_over, mine);
        }
        ray.origin = next;
    }
    return around;
}

NAMESPACE_END

#endif
