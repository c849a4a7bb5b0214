// How uv lies on surfaces: the directions in which u and v grow, and what part of a texture a path's beam covers.
//
// A beam is a cone around the path's ray: a width where the ray meets the surface, from which follow two diameters of the ellipse that it cuts out
// of the surface's plane [Akenine-Möller et al. 2021]. A cone has two numbers where ray differentials have twelve, and each kind of surface
// has to say no more than what normal maps and stretched facets need anyway.
#ifndef LANCER_KERNEL_MAPPING_H
#define LANCER_KERNEL_MAPPING_H

#include "lancer/kernel/frame.h"
#include "lancer/kernel/surface.h"

NAMESPACE_BEGIN

// ---- d position / du and / dv of each shape. -------------------------------------------------------------------------------------------

// Of a unit sphere, from sphere_uv.
FN UvAxes sphere_axes(Vec3 n) {
    Float ring = sqrt(max(n.x * n.x + n.z * n.z, Float(1.0e-12f)));
    UvAxes axes;
    axes.u = vec3_of(n.z, Float(0.0f), -n.x) * Float(2.0f * PI);
    // At the poles u goes nowhere; any direction will do.
    axes.u = select(dot(axes.u, axes.u) > Float(1.0e-10f), axes.u, vec3_of(Float(1.0e-5f), Float(0.0f), Float(0.0f)));
    axes.v = vec3_of(-n.y * n.x / ring, ring, -n.y * n.z / ring) * Float(PI);
    return axes;
}

// Of the cube from -1 to 1, from cube_uv.
FN UvAxes cube_axes(Vec3 n) {
    Float zero = Float(0.0f);
    Float two = Float(2.0f);
    Mask on_x = abs(n.x) > Float(0.5f);
    Mask on_y = abs(n.y) > Float(0.5f);
    UvAxes axes;
    axes.u = select(on_x, vec3_of(zero, zero, -n.x * two), select(on_y, vec3_of(two, zero, zero), vec3_of(n.z * two, zero, zero)));
    axes.v = select(on_y, vec3_of(zero, zero, -n.y * two), vec3_of(zero, two, zero));
    return axes;
}

// Of placed_surface's point `p` with the normal `n`, in the shape's own space.
FN UvAxes placed_axes(IN(PlacedRecord) shape, int kind, Vec3 p, Vec3 n) {
    UvAxes axes;
    Float zero = Float(0.0f);
    if (kind == OBJECT_PLACED_SPHERE) {
        axes = sphere_axes(n);
    } else if (kind == OBJECT_PLACED_BOX) {
        axes = cube_axes(n);
    } else if (kind == OBJECT_PLACED_DISK) {
        axes.u = vec3_of(Float(2.0f), zero, zero);
        axes.v = vec3_of(zero, zero, Float(-2.0f));
    } else {
        Float ring = max(sqrt(p.x * p.x + p.z * p.z), Float(1.0e-6f));
        Float k = Float(shape.top_radius) - Float(shape.bottom_radius);
        axes.u = vec3_of(p.z, zero, -p.x) * Float(2.0f * PI);
        axes.u = select(dot(axes.u, axes.u) > Float(1.0e-10f), axes.u, vec3_of(Float(1.0e-5f), zero, zero));
        // On the ends v is the same everywhere: what stands in for it points to the middle.
        Mask on_end = abs(n.y) * ring > (abs(k) + Float(1.0e-3f)) * sqrt(n.x * n.x + n.z * n.z) * Float(1.5f);
        Float inwards = with_sign_of(Float(-1.0f), n.y);
        axes.v =
            select(on_end, vec3_of(p.x * inwards / ring, zero, p.z * inwards / ring), vec3_of(k * p.x / ring, Float(1.0f), k * p.z / ring));
    }
    return axes;
}

// Of a triangle, from how its corners' uv differ from the first one's; where these say nothing, its edges.
FN UvAxes triangle_axes(Vec3 ab, Vec3 ac, Vec2 uv_ab, Vec2 uv_ac) {
    Float area = uv_ab.x * uv_ac.y - uv_ab.y * uv_ac.x;
    Mask good = abs(area) > Float(SMALLEST);
    Float scale = Float(1.0f) / select(good, area, Float(1.0f));
    UvAxes axes;
    axes.u = select(good, (ab * uv_ac.y - ac * uv_ab.y) * scale, ab);
    axes.v = select(good, (ac * uv_ab.x - ab * uv_ac.x) * scale, ac);
    return axes;
}

// ---- What the beam covers. -------------------------------------------------------------------------------------------------------------

// Two diameters of the patch, in metres, at right angles on the surface.
FN UvAxes beam_patch(Vec3 direction, Vec3 normal, Float width) {
    Float cosine = dot(direction, normal);
    Vec3 down = direction - normal * cosine;
    Float slant = dot(down, down);
    Frame any = frame_around(normal);
    down = select(slant > Float(1.0e-8f), down / sqrt(max(slant, Float(1.0e-8f))), any.x);
    UvAxes covered;
    covered.u = cross(normal, down) * width;
    // Nearly along the surface the patch has no end.
    covered.v = down * (width / max(abs(cosine), Float(1.0e-3f)));
    return covered;
}

FN Float limited(Float x) { return min(max(x, Float(-1.0e6f)), Float(1.0e6f)); }

// How far u and v go along a way on the surface: the axes' dual basis.
FN Vec2 uv_along(IN(UvAxes) axes, Vec3 way) {
    Vec3 n = cross(axes.u, axes.v);
    Float area_2 = max(dot(n, n), Float(SMALLEST));
    return vec2_of(limited(dot(cross(axes.v, n), way) / area_2), limited(dot(cross(n, axes.u), way) / area_2));
}

// ---- Meshes ----------------------------------------------------------------------------------------------------------------------------

struct MeshCorners {
    Int a;
    Int b;
    Int c;
    Int triangle;
};

FN MeshCorners mesh_corners(IN(WorldRecord) world, IN(MeshRecord) mesh, Int part, Mask mask) {
    MeshCorners m;
    m.triangle = part + Int(mesh.first_triangle);
    m.a = gather_int(world.indices, m.triangle * Int(3), mask) + Int(mesh.first_vertex);
    m.b = gather_int(world.indices, m.triangle * Int(3) + Int(1), mask) + Int(mesh.first_vertex);
    m.c = gather_int(world.indices, m.triangle * Int(3) + Int(2), mask) + Int(mesh.first_vertex);
    return m;
}

FN Vec2 vec2_between(Vec2 a, Vec2 b, Vec2 c, Float u, Float v) {
    Float w = Float(1.0f) - u - v;
    return vec2_of(a.x * w + b.x * u + c.x * v, a.y * w + b.y * u + c.y * v);
}

FN void map_mesh(IN(WorldRecord) world, int instance_index, IN(Hit) hit, IN(UvAxes) covered, Mask mask, INOUT(SurfacePoint) s) {
    InstanceRecord instance = AT(world.instances, instance_index);
    MeshRecord mesh = AT(world.meshes, instance.mesh);
    MeshCorners m = mesh_corners(world, mesh, hit.part, mask);
    Vec3 a = gather_vec3(world.positions, m.a, mask);
    Vec3 ab = apply_linear(instance.to_world, gather_vec3(world.positions, m.b, mask) - a);
    Vec3 ac = apply_linear(instance.to_world, gather_vec3(world.positions, m.c, mask) - a);
    UvAxes axes;
    axes.u = ab;
    axes.v = ac;
    if ((mesh.flags & MESH_HAS_UVS) != 0) {
        Vec2 uv_a = gather_vec2(world.uvs, m.a, mask);
        Vec2 uv_b = gather_vec2(world.uvs, m.b, mask);
        Vec2 uv_c = gather_vec2(world.uvs, m.c, mask);
        axes = triangle_axes(ab, ac, vec2_of(uv_b.x - uv_a.x, uv_b.y - uv_a.y), vec2_of(uv_c.x - uv_a.x, uv_c.y - uv_a.y));
    }
    s.across = uv_along(axes, covered.u);
    s.down = uv_along(axes, covered.v);
    s.second_uv = s.uv;
    s.second_across = s.across;
    s.second_down = s.down;
    if ((mesh.flags & MESH_HAS_SECOND_UVS) != 0) {
        Vec2 uv_a = gather_vec2(world.second_uvs, m.a, mask);
        Vec2 uv_b = gather_vec2(world.second_uvs, m.b, mask);
        Vec2 uv_c = gather_vec2(world.second_uvs, m.c, mask);
        UvAxes second = triangle_axes(ab, ac, vec2_of(uv_b.x - uv_a.x, uv_b.y - uv_a.y), vec2_of(uv_c.x - uv_a.x, uv_c.y - uv_a.y));
        s.second_uv = vec2_between(uv_a, uv_b, uv_c, hit.u, hit.v);
        s.second_across = uv_along(second, covered.u);
        s.second_down = uv_along(second, covered.v);
    }
    s.along_u = axes.u;
    s.along_v = axes.v;
    if ((mesh.flags & MESH_HAS_TANGENTS) != 0) {
        Vec4 one = gather_vec4(world.tangents, m.a, mask);
        Vec4 two = gather_vec4(world.tangents, m.b, mask);
        Vec4 three = gather_vec4(world.tangents, m.c, mask);
        Vec4 t = one * (Float(1.0f) - hit.u - hit.v) + two * hit.u + three * hit.v;
        // As long as the triangle's own, so that bumps keep their height.
        Vec3 tangent = apply_linear(instance.to_world, vec3_of(t.x, t.y, t.z));
        tangent = tangent * (length(axes.u) / max(length(tangent), Float(SMALLEST)));
        Float side = select(t.w < Float(0.0f), Float(-1.0f), Float(1.0f)) * Float(instance.flips != 0 ? -1.0f : 1.0f);
        Vec3 across = cross(s.shading, tangent);
        s.along_u = tangent;
        s.along_v = across * (side * length(axes.v) / max(length(across), Float(SMALLEST)));
    }
    s.local_across = apply_linear(instance.to_object, covered.u);
    s.local_down = apply_linear(instance.to_object, covered.v);
}

// Colours of vertices and faces; 1 where the mesh has none.
FN void find_mesh_colors(IN(WorldRecord) world, IN(ObjectRecord) object, IN(Hit) hit, Mask mask, INOUT(SurfacePoint) s) {
    if (object.kind == OBJECT_TRIANGLE || object.kind == OBJECT_MESH) {
        int number = object.kind == OBJECT_MESH ? object.index : object.instance;
        MeshRecord mesh = AT(world.meshes, AT(world.instances, number).mesh);
        MeshCorners m = mesh_corners(world, mesh, hit.part, mask);
        if ((mesh.flags & MESH_HAS_COLORS) != 0) {
            s.vertex_color = gather_vec4(world.colors, m.a, mask) * (Float(1.0f) - hit.u - hit.v) +
                             gather_vec4(world.colors, m.b, mask) * hit.u + gather_vec4(world.colors, m.c, mask) * hit.v;
        }
        if ((mesh.flags & MESH_HAS_FACE_COLORS) != 0) {
            s.face_color = gather_vec4(world.face_colors, m.triangle, mask);
        }
    }
}

// ---- Any shape -------------------------------------------------------------------------------------------------------------------------

// Fills the point's second uv, directions and patches; `width` is the beam's diameter there, in metres.
FN void find_mapping(IN(WorldRecord) world, IN(ObjectRecord) object, IN(Ray) ray, IN(Hit) hit, Float width, Mask mask,
                     INOUT(SurfacePoint) s) {
    UvAxes covered = beam_patch(ray.direction, s.normal, width);
    if (object.kind == OBJECT_TRIANGLE) {
        map_mesh(world, object.instance, hit, covered, mask, s);
    } else if (object.kind == OBJECT_MESH) {
        map_mesh(world, object.index, hit, covered, mask, s);
    } else {
        UvAxes axes;
        s.local_across = covered.u;
        s.local_down = covered.v;
        if (object.kind == OBJECT_SPHERE) {
            axes = sphere_axes(s.normal);
            axes.u = axes.u * Float(AT(world.spheres, object.index).radius);
            axes.v = axes.v * Float(AT(world.spheres, object.index).radius);
        } else if (object.kind == OBJECT_BOX) {
            axes = cube_axes(s.normal);
            Vec3 half_size = (broadcast(AT(world.boxes, object.index).high) - broadcast(AT(world.boxes, object.index).low)) * Float(0.5f);
            axes.u = axes.u * half_size;
            axes.v = axes.v * half_size;
        } else if (object.kind == OBJECT_PLANE) {
            PlaneRecord plane = AT(world.planes, object.index);
            UvAxes author = plane_axes(broadcast(plane.author_normal));
            // How u and v grow in the world, within the plane; and from that the ways along which one of them does.
            Vec3 u = apply_transposed(plane.to_author, author.u);
            Vec3 v = apply_transposed(plane.to_author, author.v);
            Vec3 u_way = cross(v, s.normal);
            Vec3 v_way = cross(s.normal, u);
            axes.u = u_way / dot(u, u_way);
            axes.v = v_way / dot(v, v_way);
            s.local_across = apply_linear(plane.to_author, covered.u);
            s.local_down = apply_linear(plane.to_author, covered.v);
        } else {
            PlacedRecord shape = AT(world.placed, object.index);
            Vec3 p = apply_affine(shape.to_object, s.position);
            Vec3 n = apply_transposed(shape.to_world, s.normal);
            axes = placed_axes(shape, object.kind, p, n / max(length(n), Float(SMALLEST)));
            axes.u = apply_linear(shape.to_world, axes.u);
            axes.v = apply_linear(shape.to_world, axes.v);
            s.local_across = apply_linear(shape.to_author, apply_linear(shape.to_object, covered.u));
            s.local_down = apply_linear(shape.to_author, apply_linear(shape.to_object, covered.v));
        }
        s.along_u = axes.u;
        s.along_v = axes.v;
        s.across = uv_along(axes, covered.u);
        s.down = uv_along(axes, covered.v);
        s.second_uv = s.uv;
        s.second_across = s.across;
        s.second_down = s.down;
    }
}

NAMESPACE_END

#endif
