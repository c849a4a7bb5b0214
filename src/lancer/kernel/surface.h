// From a hit to the point, its normals and what it is made of.
#ifndef LANCER_KERNEL_SURFACE_H
#define LANCER_KERNEL_SURFACE_H

#include "lancer/kernel/plane.h"
#include "lancer/kernel/texture.h"
#include "lancer/kernel/triangle.h"

NAMESPACE_BEGIN

// The material's values at the point.
struct Finish {
    Vec3 color;
    Float ambient;
    Float diffuse;
    Float highlight;
    Float shininess;
    Float reflectivity;
    Float transparency;
    Int material;
    Mask dispersive;
};

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

// A triangle of a placed mesh, with the mesh's own normals and texture coordinates where it has them.
FN SurfacePoint mesh_surface(IN(WorldRecord) world, int instance_index, Int part, Float u, Float v, Mask mask) {
    InstanceRecord instance = AT(world.instances, instance_index);
    MeshRecord mesh = AT(world.meshes, instance.mesh);
    Int first = (part + Int(mesh.first_triangle)) * Int(3);
    Int i = gather_int(world.indices, first, mask) + Int(mesh.first_vertex);
    Int j = gather_int(world.indices, first + Int(1), mask) + Int(mesh.first_vertex);
    Int k = gather_int(world.indices, first + Int(2), mask) + Int(mesh.first_vertex);
    Vec3 local_a = gather_vec3(world.positions, i, mask);
    Vec3 local_b = gather_vec3(world.positions, j, mask);
    Vec3 local_c = gather_vec3(world.positions, k, mask);
    SurfacePoint s = triangle_surface(apply_affine(instance.to_world, local_a), apply_affine(instance.to_world, local_b),
                                      apply_affine(instance.to_world, local_c), u, v);
    Float w = Float(1.0f) - u - v;
    s.normal = instance.flips != 0 ? -s.normal : s.normal;
    s.shading = s.normal;
    s.local = local_a * w + local_b * u + local_c * v;
    s.local_in = -normalize(cross(local_b - local_a, local_c - local_a));
    if ((mesh.flags & MESH_HAS_NORMALS) != 0) {
        Vec3 n =
            gather_vec3(world.normals, i, mask) * w + gather_vec3(world.normals, j, mask) * u + gather_vec3(world.normals, k, mask) * v;
        n = apply_transposed(instance.to_object, n);
        Float size = dot(n, n);
        n = n / sqrt(max(size, Float(SMALLEST)));
        n = select(dot(n, s.normal) < Float(0.0f), -n, n);
        s.shading = select(size > Float(0.0f), n, s.normal);
    }
    if ((mesh.flags & MESH_HAS_UVS) != 0) {
        Vec2 a = gather_vec2(world.uvs, i, mask);
        Vec2 b = gather_vec2(world.uvs, j, mask);
        Vec2 c = gather_vec2(world.uvs, k, mask);
        s.uv = vec2_of(a.x * w + b.x * u + c.x * v, a.y * w + b.y * u + c.y * v);
    }
    return s;
}

// A triangle of a small mesh. Where the mesh has nothing of its own at its corners, all lanes share what there is to read.
FN SurfacePoint loose_triangle_surface(IN(WorldRecord) world, IN(ObjectRecord) object, IN(Hit) hit, Mask mask) {
    SurfacePoint s = no_surface();
    if (AT(world.meshes, object.mesh).flags != 0) {
        s = mesh_surface(world, object.instance, hit.part, hit.u, hit.v, mask);
    } else {
        TriangleRecord triangle = AT(world.triangles, object.index);
        InstanceRecord instance = AT(world.instances, object.instance);
        s = triangle_surface(broadcast(triangle.a), broadcast(triangle.b), broadcast(triangle.c), hit.u, hit.v);
        s.normal = instance.flips != 0 ? -s.normal : s.normal;
        s.shading = s.normal;
        s.local = apply_affine(instance.to_object, s.position);
        s.local_in = -normalize(apply_transposed(instance.to_world, s.normal));
    }
    return s;
}

// The same for several triangles of one instance whose mesh has nothing of its own at its corners, a different one in each lane. `index`: into
// world.triangles.
FN SurfacePoint bare_triangle_surface(IN(WorldRecord) world, int instance_index, Int index, IN(Hit) hit, Mask mask) {
    Vec3 a = vec3_all(Float(0.0f));
    Vec3 b = a;
    Vec3 c = a;
    gather_triangle(world, index, mask, a, b, c);
    InstanceRecord instance = AT(world.instances, instance_index);
    SurfacePoint s = triangle_surface(a, b, c, hit.u, hit.v);
    s.normal = instance.flips != 0 ? -s.normal : s.normal;
    s.shading = s.normal;
    s.local = apply_affine(instance.to_object, s.position);
    s.local_in = -normalize(apply_transposed(instance.to_world, s.normal));
    return s;
}

FN SurfacePoint object_surface(IN(WorldRecord) world, IN(ObjectRecord) object, IN(Ray) ray, IN(Hit) hit, Mask mask) {
    SurfacePoint s = no_surface();
    if (object.kind == OBJECT_SPHERE) {
        s = sphere_surface(AT(world.spheres, object.index), ray, hit.t);
    } else if (object.kind == OBJECT_BOX) {
        s = box_surface(AT(world.boxes, object.index), ray, hit.t);
    } else if (object.kind == OBJECT_PLANE) {
        s = plane_surface(AT(world.planes, object.index), ray, hit.t);
    } else if (object.kind == OBJECT_TRIANGLE) {
        s = loose_triangle_surface(world, object, hit, mask);
    } else if (object.kind == OBJECT_MESH) {
        s = mesh_surface(world, object.index, hit.part, hit.u, hit.v, mask);
    } else {
        s = placed_surface(AT(world.placed, object.index), object.kind, ray, hit.t);
    }
    return s;
}

// Lanes that hit the same object are done together, so that its records are read once.
FN void find_surface(IN(WorldRecord) world, IN(Ray) ray, IN(Hit) hit, Mask here, INOUT(SurfacePoint) point, INOUT(Finish) finish) {
    Mask todo = here;
    while (some(todo)) {
        int number = first_of(hit.object, todo);
        Mask mine = both(todo, is_equal(hit.object, Int(number)));
        ObjectRecord object = AT(world.objects, number);
        WhittedRecord material = AT(world.materials, object.material);
        SurfacePoint s = object_surface(world, object, ray, hit, mine);
        Vec3 color = broadcast(material.color);
        if (material.texture >= 0) {
            TextureRecord texture = AT(world.textures, material.texture);
            if (object.kind == OBJECT_SPHERE) {
                s.uv = sphere_uv(s.normal);
            }
            Vec4 seen = texture_color(world, texture, s, mine);
            color = vec3_of(seen.x, seen.y, seen.z);
        }
        point.position = select(mine, s.position, point.position);
        point.error = select(mine, s.error, point.error);
        point.normal = select(mine, s.normal, point.normal);
        point.shading = select(mine, s.shading, point.shading);
        finish.color = select(mine, color, finish.color);
        finish.ambient = select(mine, Float(material.ambient), finish.ambient);
        finish.diffuse = select(mine, Float(material.diffuse), finish.diffuse);
        finish.highlight = select(mine, Float(material.highlight), finish.highlight);
        finish.shininess = select(mine, Float(material.shininess), finish.shininess);
        finish.reflectivity = select(mine, Float(material.reflectivity), finish.reflectivity);
        finish.transparency = select(mine, Float(material.transparency), finish.transparency);
        finish.material = select(mine, Int(object.material), finish.material);
        if (AT(world.media, object.material).dispersive != 0) {
            finish.dispersive = either(finish.dispersive, mine);
        }
        todo = without(todo, mine);
    }
}

NAMESPACE_END

#endif
