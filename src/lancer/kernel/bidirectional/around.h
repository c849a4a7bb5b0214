// Which bodies a lamp stands in: the camera's are found when the world is made; lamps may reach through many.
#ifndef LANCER_KERNEL_BIDIRECTIONAL_AROUND_H
#define LANCER_KERNEL_BIDIRECTIONAL_AROUND_H

#include "lancer/kernel/volume/passage.h"

NAMESPACE_BEGIN

// Behind all that are there.
FN Media put_behind(IN(Media) media, Int material, Mask mask) {
    Mask at_first = both(mask, is_equal(media.first, Int(-1)));
    Mask at_second = both(without(mask, at_first), is_equal(media.second, Int(-1)));
    Mask at_third = both(without(without(mask, at_first), at_second), is_equal(media.third, Int(-1)));
    Mask at_fourth = both(without(without(without(mask, at_first), at_second), at_third), is_equal(media.fourth, Int(-1)));
    Media m;
    m.first = select(at_first, material, media.first);
    m.second = select(at_second, material, media.second);
    m.third = select(at_third, material, media.third);
    m.fourth = select(at_fourth, material, media.fourth);
    return m;
}

// A ray that leaves them all passes their borders: what it leaves without having entered it was around its start, the innermost first.
FN_LARGE Media media_around(IN(WorldRecord) world, Vec3 origin, Vec3 direction, Mask alive) {
    Media left_behind = no_media();
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
                left_behind = put_behind(left_behind, Int(object.material), without(inside, known));
                since = select_media(known, left(since, Int(object.material)), since);
                since = select_media(without(mine, inside), entered(since, Int(object.material)), since);
            }
            left_over = without(left_over, mine);
        }
        ray.origin = next;
    }
    // From the outermost on, each by its priority.
    Media m = no_media();
    Mask there = is_above(left_behind.fourth, Int(-1));
    m = select_media(there, entered_in_order(world, m, left_behind.fourth, there), m);
    there = is_above(left_behind.third, Int(-1));
    m = select_media(there, entered_in_order(world, m, left_behind.third, there), m);
    there = is_above(left_behind.second, Int(-1));
    m = select_media(there, entered_in_order(world, m, left_behind.second, there), m);
    there = is_above(left_behind.first, Int(-1));
    m = select_media(there, entered_in_order(world, m, left_behind.first, there), m);
    return m;
}

NAMESPACE_END

#endif
