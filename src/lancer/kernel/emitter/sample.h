// A point of an emitter to ask for light, and the density with which it is drawn.
#ifndef LANCER_KERNEL_EMITTER_SAMPLE_H
#define LANCER_KERNEL_EMITTER_SAMPLE_H

#include "lancer/kernel/emitter/near_lamp.h"
#include "lancer/kernel/emitter/sky.h"
#include "lancer/kernel/frame.h"

NAMESPACE_BEGIN

// A point of an emitter as it is seen from another point.
struct EmitterSample {
    SurfacePoint point;  // on the emitter; of far emitters: from + direction. Its coordinates for textures only where it has one.
    Vec3 direction;      // towards it, length 1
    Float distance;      // FAR for far ones
    Float density;       // per solid angle at the point that looks; 1 for lights without size
    Float place;         // of the point, per square metre, where light itself begins; of near emitters with a size
    Mask discrete;       // a light without size
    Mask valid;
};

// A sphere seen from outside: directions uniform over what it covers of the sky. From inside: uniform over its surface.
FN EmitterSample sphere_light_sample(IN(SphereRecord) sphere, IN(EmitterRecord) emitter, Vec3 from, Vec2 u) {
    EmitterSample s;
    Vec3 center = broadcast(sphere.center);
    Float radius = Float(sphere.radius);
    Vec3 way = center - from;
    Float distance_2 = dot(way, way);
    Float radius_2 = radius * radius;
    Mask outside = distance_2 > radius_2 * Float(1.0001f);
    Float distance = sqrt(distance_2);
    Frame frame = frame_around(way / max(distance, Float(SMALLEST)));
    Float sin_2 = min(radius_2 / max(distance_2, Float(SMALLEST)), Float(1.0f));
    Float cos_most = sqrt(Float(1.0f) - sin_2);
    Float room = sin_2 / (Float(1.0f) + cos_most);  // 1 - cos_most
    Float off = room * u.x;                         // 1 - cosine
    Float sine_2 = max(off * (Float(2.0f) - off), Float(0.0f));
    Float sine = sqrt(sine_2);
    Vec2 around = on_circle(u.y);
    Vec3 towards = to_world(frame, vec3_of(sine * around.x, sine * around.y, Float(1.0f) - off));
    // The nearer of the two points of the sphere that lie there.
    Float half_chord = sqrt(max(radius_2 - distance_2 * sine_2, Float(0.0f)));
    Vec3 near = from + towards * (distance * (Float(1.0f) - off) - half_chord);
    Vec3 normal = select(outside, normalize(near - center), on_sphere(u));
    s.point = no_surface();
    s.point.normal = normal;
    s.point.position = center + normal * radius;
    s.point.error = (abs(center) + vec3_all(radius)) * Float(8.0f * ROUNDING);
    if (emitter.textured != 0) {
        s.point.uv = sphere_uv(normal);
        s.point.local = s.point.position;
        s.point.local_in = -normal;
    }
    Vec3 line = s.point.position - from;
    Float length_2 = dot(line, line);
    s.distance = sqrt(length_2);
    s.direction = line / max(s.distance, Float(SMALLEST));
    Float cosine = abs(dot(s.direction, normal));
    Float by_area = length_2 / max(cosine * Float(4.0f * PI) * radius_2, Float(SMALLEST));
    s.density = select(outside, Float(0.5f / PI) / max(room, Float(SMALLEST)), by_area);
    s.place = Float(1.0f / emitter.area);
    s.discrete = Float(1.0f) < Float(0.0f);
    s.valid = s.distance > Float(0.0f);
    return s;
}

// `solid_angle`: that it was drawn by; 0: by its area.
FN EmitterSample area_sample(IN(AreaPoint) point, Float solid_angle, Vec3 from) {
    EmitterSample s;
    s.point = point.at;
    Vec3 way = point.at.position - from;
    Float distance_2 = dot(way, way);
    s.distance = sqrt(distance_2);
    s.direction = way / max(s.distance, Float(SMALLEST));
    Float cosine = abs(dot(s.direction, point.at.normal));
    s.density = point.density * distance_2 / max(cosine, Float(SMALLEST));
    s.density = select(solid_angle > Float(0.0f), Float(1.0f) / max(solid_angle, Float(SMALLEST)), s.density);
    s.place = point.density;
    s.discrete = Float(1.0f) < Float(0.0f);
    s.valid = both(cosine > Float(0.0f), distance_2 > Float(0.0f));
    return s;
}

FN EmitterSample far_sample(Vec3 from, Vec3 direction, Float density, Mask discrete) {
    EmitterSample s;
    s.point = no_surface();
    s.point.position = from + direction;
    s.point.normal = -direction;
    s.direction = direction;
    s.distance = Float(FAR);
    s.density = density;
    s.place = Float(1.0f);
    s.discrete = discrete;
    s.valid = density > Float(0.0f);
    return s;
}

FN EmitterSample point_sample(IN(EmitterRecord) emitter, Vec3 from) {
    EmitterSample s;
    Vec3 way = broadcast(emitter.position) - from;
    s.point = no_surface();
    s.point.position = broadcast(emitter.position);
    s.distance = length(way);
    s.direction = way / max(s.distance, Float(SMALLEST));
    s.point.normal = -s.direction;
    s.density = Float(1.0f);
    s.place = Float(1.0f);
    s.discrete = s.density > Float(0.0f);
    s.valid = s.distance > Float(0.0f);
    return s;
}

FN EmitterSample emitter_sample(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec3 from, Vec2 u, Mask mask) {
    Mask yes = Float(1.0f) > Float(0.0f);
    Mask no = Float(1.0f) < Float(0.0f);
    EmitterSample s;
    Float solid_angle = Float(0.0f);
    if (emitter.kind == EMITTER_SPHERE) {
        s = sphere_light_sample(AT(world.spheres, emitter.index), emitter, from, u);
    } else if (emitter.kind == EMITTER_TRIANGLE || emitter.kind == EMITTER_MESH_TRIANGLE) {
        AreaPoint point = seen_triangle_point(world, emitter, from, u, mask, solid_angle);
        s = area_sample(point, solid_angle, from);
    } else if (emitter.kind == EMITTER_MESH) {
        AreaPoint point = seen_mesh_point(world, emitter, from, u, mask, solid_angle);
        s = area_sample(point, solid_angle, from);
    } else if (emitter.kind == EMITTER_PLACED) {
        s = area_sample(placed_point(AT(world.placed, emitter.index), AT(world.objects, emitter.object).kind, emitter, u), solid_angle,
                        from);
    } else if (emitter.kind == EMITTER_DIRECTIONAL) {
        s = far_sample(from, broadcast(-emitter.direction), Float(1.0f), yes);
    } else if (emitter.kind == EMITTER_ENVIRONMENT) {
        SkySample sky = sky_sample(world, u, mask);
        s = far_sample(from, sky.direction, sky.density, no);
    } else {
        s = point_sample(emitter, from);
    }
    return s;
}

// From just off a surface, at `start`, to just before the emitter.
FN Ray ray_to_emitter(IN(EmitterSample) s, Vec3 start) {
    Vec3 way = before_surface(s.point.position, s.point.error, s.point.normal, s.distance, -s.direction) - start;
    Float reach = length(way);
    Mask far = s.distance >= Float(FAR);
    Ray ray;
    ray.origin = start;
    ray.direction = select(far, s.direction, way / max(reach, Float(SMALLEST)));
    ray.reach = select(far, Float(FAR), reach);
    return ray;
}

// With which a point of an emitting object is drawn, per square metre, where light begins; `part`: of a mesh.
FN Float place_density(IN(WorldRecord) world, IN(EmitterRecord) emitter, IN(SurfacePoint) point, Int part, Mask mask) {
    Float density = Float(1.0f / emitter.area);
    if (emitter.kind == EMITTER_MESH) {
        density = mesh_density(world, emitter, part, mask);
    } else if (emitter.kind == EMITTER_PLACED) {
        PlacedRecord shape = AT(world.placed, emitter.index);
        Vec3 n = normalize(apply_transposed(shape.to_world, point.normal));  // back in the shape's own space
        if (AT(world.objects, emitter.object).kind == OBJECT_PLACED_BOX) {
            Vec3 grown = face_growths(shape);
            density = Float(1.0f) / ((grown.x + grown.y + grown.z) * Float(8.0f));
        } else {
            density = Float(1.0f) / (area_growth(shape, n) * Float(emitter.area));
        }
    }
    return density;
}

// The density, per solid angle at `from`, with which emitter_sample draws the point of an emitting object that a ray from there has met; `part`: of a mesh.
FN Float emitter_density(IN(WorldRecord) world, IN(EmitterRecord) emitter, Vec3 from, Vec3 direction, IN(SurfacePoint) point, Int part,
                         Mask mask) {
    Float density = Float(0.0f);
    if (emitter.kind == EMITTER_ENVIRONMENT) {
        density = sky_density(world, direction, mask);
    } else {
        Vec3 way = point.position - from;
        Float to_solid_angle = dot(way, way) / max(abs(dot(direction, point.normal)), Float(SMALLEST));
        density = to_solid_angle * place_density(world, emitter, point, part, mask);
        if (emitter.kind == EMITTER_SPHERE) {
            SphereRecord sphere = AT(world.spheres, emitter.index);
            Vec3 to_center = broadcast(sphere.center) - from;
            Float distance_2 = dot(to_center, to_center);
            Float radius_2 = Float(sphere.radius * sphere.radius);
            Float sin_2 = min(radius_2 / max(distance_2, Float(SMALLEST)), Float(1.0f));
            Float room = sin_2 / (Float(1.0f) + sqrt(Float(1.0f) - sin_2));
            density = select(distance_2 > radius_2 * Float(1.0001f), Float(0.5f / PI) / max(room, Float(SMALLEST)), density);
        } else {
            Float solid_angle = drawn_solid_angle(world, emitter, from, mask);
            density = select(solid_angle > Float(0.0f), Float(1.0f) / max(solid_angle, Float(SMALLEST)), density);
        }
    }
    return density;
}

NAMESPACE_END

#endif
