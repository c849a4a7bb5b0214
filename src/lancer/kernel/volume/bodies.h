// Which bodies a ray is inside of, where they overlap and some have no border of their own.
#ifndef LANCER_KERNEL_VOLUME_BODIES_H
#define LANCER_KERNEL_VOLUME_BODIES_H

#include "lancer/kernel/refraction.h"
#include "lancer/kernel/tables.h"

NAMESPACE_BEGIN

FN Int priority_of(IN(WorldRecord) world, Int material, Mask mask) {
    Int priority = Int(-2147483647);  // of nothing
    Mask todo = both(mask, is_above(material, Int(-1)));
    while (some(todo)) {
        int number = first_of(material, todo);
        Mask mine = both(todo, is_equal(material, Int(number)));
        priority = select(mine, Int(AT(world.media, number).priority), priority);
        todo = without(todo, mine);
    }
    return priority;
}

// Which of the bodies stay in front of one that is put in, from the first on.
struct InFront {
    Mask first;
    Mask second;
    Mask third;
    Mask fourth;
};

// The last one makes room.
FN Media put_in(IN(Media) media, Int material, IN(InFront) front) {
    Media m;
    m.first = select(front.first, media.first, material);
    m.second = select(front.first, select(front.second, media.second, material), media.first);
    m.third = select(front.second, select(front.third, media.third, material), media.second);
    m.fourth = select(front.third, select(front.fourth, media.fourth, material), media.third);
    return m;
}

// In front of all whose priority is not higher [Schmidt and Budge 2002]; those that are not there have none.
FN Media entered_in_order(IN(WorldRecord) world, IN(Media) media, Int material, Mask mask) {
    Media m = entered(media, material);
    if (world.has_priorities != 0) {
        Int own = priority_of(world, material, mask);
        InFront front;
        front.first = is_above(priority_of(world, media.first, mask), own);
        front.second = both(front.first, is_above(priority_of(world, media.second, mask), own));
        front.third = both(front.second, is_above(priority_of(world, media.third, mask), own));
        front.fourth = both(front.third, is_above(priority_of(world, media.fourth, mask), own));
        m = put_in(media, material, front);
    }
    return m;
}

// Behind all whose priority is not lower: a body that was entered before them.
FN Media entered_before(IN(WorldRecord) world, IN(Media) media, Int material, Mask mask) {
    InFront front;
    front.first = is_above(media.first, Int(-1));
    front.second = is_above(media.second, Int(-1));
    front.third = is_above(media.third, Int(-1));
    front.fourth = is_above(media.fourth, Int(-1));
    if (world.has_priorities != 0) {
        Int own = priority_of(world, material, mask);
        front.first = without(front.first, is_above(own, priority_of(world, media.first, mask)));
        front.second = without(both(front.first, front.second), is_above(own, priority_of(world, media.second, mask)));
        front.third = without(both(front.second, front.third), is_above(own, priority_of(world, media.third, mask)));
        front.fourth = without(both(front.third, front.fourth), is_above(own, priority_of(world, media.fourth, mask)));
    }
    return select_media(mask, put_in(media, material, front), media);
}

FN Media crossed(IN(WorldRecord) world, IN(Media) media, Int material, Mask inside, Mask mask) {
    return select_media(inside, left(media, material), entered_in_order(world, media, material, without(mask, inside)));
}

FN Mask bends_nothing(IN(WorldRecord) world, Int material, Mask mask) {
    Mask null_body = without(mask, mask);
    Mask todo = both(mask, is_above(material, Int(-1)));
    while (some(todo)) {
        int number = first_of(material, todo);
        Mask mine = both(todo, is_equal(material, Int(number)));
        if (AT(world.media, number).refraction == REFRACTION_NONE || (AT(world.surfaces, number).flags & MATERIAL_BOUNDS) != 0) {
            null_body = either(null_body, mine);
        }
        todo = without(todo, mine);
    }
    return null_body;
}

// The body whose refractive index fills the place: the first that is not closed in by a null border or a pane.
FN Int bending_body(IN(WorldRecord) world, IN(Media) media, Mask mask) {
    Int body = media.first;
    Mask todo = bends_nothing(world, body, mask);
    if (some(todo)) {
        body = select(todo, media.second, body);
        todo = bends_nothing(world, body, todo);
        body = select(todo, media.third, body);
        todo = bends_nothing(world, body, todo);
        body = select(todo, media.fourth, body);
        todo = bends_nothing(world, body, todo);
        body = select(todo, Int(-1), body);
    }
    return body;
}

// What stands around the camera.
FN Media media_of_camera(IN(WorldRecord) world) {
    Media m;
    m.first = Int(world.camera_first);
    m.second = Int(world.camera_second);
    m.third = Int(world.camera_third);
    m.fourth = Int(world.camera_fourth);
    return m;
}

NAMESPACE_END

#endif
