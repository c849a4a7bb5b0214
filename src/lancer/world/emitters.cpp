#include "lancer/world/emitters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/kernel/emitter/emitter.h"
#include "lancer/kernel/sampler.h"
#include "lancer/world/light_tree.h"
#include "lancer/world/lights.h"
#include "lancer/world/sky.h"
#include "lancer/world/spectra.h"
#include "lancer/world/thrown.h"

namespace lancer {

namespace {

// With more emitters than this, going down a tree costs less than looking at each. See docs/performance.md.
constexpr std::size_t few_emitters = 32;

// Of lamps with a texture: points at which it is looked up to weigh the lamp, or one of its triangles; and what is left for what they miss.
constexpr int points_a_lamp = 256;
constexpr int points_a_triangle = 8;
constexpr double unseen_light = 0.02;

// Of meshes: how many triangles may be emitters of their own, all together; and of what share of a sphere around the mesh its area is so small that
// they are.
constexpr int most_parts = 1 << 18;
constexpr double spread_out = 0.15;

// Point i of n, spread over the unit square [Hammersley 1960].
kernel::Vec2 spread(int i, int n) {
    const double across = (static_cast<double>(i) + 0.5) / n;
    const double down = static_cast<double>(kernel::reverse_bits(static_cast<std::uint32_t>(i))) / 4294967296.0;
    return kernel::vec2_of(static_cast<float>(across), static_cast<float>(down + 0.5 / n));
}

glm::dvec3 apply(const kernel::AffineRecord& map, const glm::dvec3& p) {
    return glm::dvec3(glm::dot(glm::dvec3(map.row_x), p), glm::dot(glm::dvec3(map.row_y), p), glm::dot(glm::dvec3(map.row_z), p)) +
           glm::dvec3(map.shift);
}

class Emitters {
public:
    Emitters(const scene::Scene& scene, World& world, Textures& textures, Colors& colors, Diagnostics& diagnostics)
        : scene_(scene), world_(world), textures_(textures), colors_(colors), diagnostics_(diagnostics) {}

    void add_light(const scene::Light& light) {
        if (!light.power) {
            diagnostics_.error(light.position, "for the path integrator a light needs \"power\" instead of a share of the light");
            return;
        }
        kernel::EmitterRecord record = no_emitter();
        record.light = colors_.light(*light.power);
        record.strength = static_cast<float>(brightness(record.light.rgb));
        if (const auto* point = std::get_if<scene::PointLight>(&light.model)) {
            record.kind = kernel::EMITTER_POINT;
            record.position = kernel::vec3(point->position);
        } else if (const auto* spot = std::get_if<scene::SpotLight>(&light.model)) {
            record.kind = kernel::EMITTER_SPOT;
            record.position = kernel::vec3(spot->position);
            record.direction = kernel::vec3(glm::normalize(spot->direction));
            const SpotCone cone = spot_cone(*spot);
            record.cos_outer = cone.cos_outer;
            record.cos_inner = cone.cos_inner;
            record.fade = fade_of(*spot);
            if (spot->image) {
                compile_thrown(*spot, *light.power, world_, textures_, colors_, record);
            }
        } else if (const auto* sun = std::get_if<scene::DirectionalLight>(&light.model)) {
            record.kind = kernel::EMITTER_DIRECTIONAL;
            record.direction = kernel::vec3(glm::normalize(sun->direction));
        } else if (const auto* projector = std::get_if<scene::ProjectorLight>(&light.model)) {
            compile_thrown(*projector, *light.power, world_, textures_, colors_, record);
        } else if (const auto* lamp = std::get_if<scene::GoniometricLight>(&light.model)) {
            compile_thrown(*lamp, *light.power, world_, textures_, colors_, record);
        } else if (const auto* measured = std::get_if<scene::IesLight>(&light.model)) {
            compile_thrown(*measured, *light.power, world_, photometries_, colors_, record);
        }
        record.middle = record.position;
        world_.emitters.push_back(record);
    }

    void add_sky() {
        // Paths that start from lamps carry all of its light.
        const SkyLight sky = compile_sky_shares(world_, world_.ways == kernel::WAYS_BOTH && world_.halves == kernel::HALF_OF_CAMERA);
        if (sky.mean > 0.0) {
            kernel::EmitterRecord record = no_emitter();
            record.kind = kernel::EMITTER_ENVIRONMENT;
            record.strength = static_cast<float>(std::numbers::pi * sky.asked);
            world_.environment = static_cast<int>(world_.emitters.size());
            world_.emitters.push_back(record);
        }
    }

    // By chance, never asked: a lamp with holes, where points drawn on it may not be there, and one that shines in the colours of its mesh, which
    // a drawn point does not know.
    bool is_only_met(const kernel::MaterialRecord& material) const {
        const int texture = material.emission.texture;
        const int kind = texture < 0 ? kernel::TEXTURE_NONE : world_.textures[static_cast<std::size_t>(texture)].kind;
        return (material.flags & kernel::MATERIAL_CUT) != 0 || kind == kernel::TEXTURE_VERTEX_COLOR || kind == kernel::TEXTURE_FACE_COLOR;
    }

    void add_objects() {
        for (std::size_t i = 0; i < world_.objects.size(); ++i) {
            kernel::ObjectRecord& object = world_.objects[i];
            const kernel::MaterialRecord& material = world_.surfaces[static_cast<std::size_t>(object.material)];
            if ((material.flags & kernel::MATERIAL_EMITS) == 0 || is_only_met(material)) {
                continue;
            }
            kernel::EmitterRecord record = no_emitter();
            record.index = object.index;
            record.object = static_cast<int>(i);
            record.material = object.material;
            record.two_sided = (material.flags & kernel::MATERIAL_EMITS_BEHIND) != 0 ? 1 : 0;
            record.textured = material.emission.texture >= 0 ? 1 : 0;
            if (object.kind == kernel::OBJECT_MESH && add_parts(object, record)) {
                continue;
            }
            const double seen_area = place(object, record);
            if (!(seen_area > 0.0)) {
                continue;
            }
            const double radiance = record.textured != 0 ? mean_of_texture(record) : brightness(material.emission.rgb);
            if (radiance > 0.0) {
                record.strength = static_cast<float>(radiance * seen_area);
                object.emitter = static_cast<int>(world_.emitters.size());
                world_.emitters.push_back(record);
            }
        }
    }

    // `far_count`: of those that were added first.
    void finish(std::size_t far_count) {
        world_.far_count = static_cast<int>(far_count);
        if (world_.emitters.size() > few_emitters) {
            compile_light_tree(world_);
        }
    }

private:
    static kernel::EmitterRecord no_emitter() {
        kernel::EmitterRecord record{};
        record.object = -1;
        record.index = -1;
        record.material = -1;
        record.direction = kernel::vec3(0.0f, -1.0f, 0.0f);
        return record;
    }

    // Where the lamp is and how large; returns the area that one sees of it, roughly, in the world.
    double place(const kernel::ObjectRecord& object, kernel::EmitterRecord& record) {
        const std::size_t index = static_cast<std::size_t>(object.index);
        if (object.kind == kernel::OBJECT_SPHERE) {
            const kernel::SphereRecord& sphere = world_.spheres[index];
            record.kind = kernel::EMITTER_SPHERE;
            record.middle = sphere.center;
            record.radius = sphere.radius;
            record.area = static_cast<float>(4.0 * std::numbers::pi * std::pow(static_cast<double>(sphere.radius), 2.0));
            return static_cast<double>(record.area) / 4.0;
        }
        if (object.kind == kernel::OBJECT_TRIANGLE) {
            return place_triangle(object, world_.triangles[index], record);
        }
        if (object.kind == kernel::OBJECT_MESH) {
            return place_mesh(world_.instances[index], record);
        }
        if (object.kind == kernel::OBJECT_PLANE) {
            const scene::Material& material = scene_.materials[static_cast<std::size_t>(object.material)];
            diagnostics_.error(material.position, "an infinite plane can't be a lamp: its light would be infinite");
            return 0.0;
        }
        return place_canonical(object, world_.placed[index], record);
    }

    double place_triangle(const kernel::ObjectRecord& object, const kernel::TriangleRecord& t, kernel::EmitterRecord& record) {
        record.kind = kernel::EMITTER_TRIANGLE;
        const bool flips = world_.instances[static_cast<std::size_t>(object.instance)].flips != 0;
        return place_corners(glm::dvec3(t.a), glm::dvec3(t.b), glm::dvec3(t.c), flips, record);
    }

    static double place_corners(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, bool flips, kernel::EmitterRecord& record) {
        const glm::dvec3 across = glm::cross(b - a, c - a);
        const double area = 0.5 * glm::length(across);
        record.planar = 1;
        record.area = static_cast<float>(area);
        record.direction = area > 0.0 ? kernel::vec3(glm::normalize(flips ? -across : across)) : kernel::vec3(0.0f, 1.0f, 0.0f);
        const glm::dvec3 middle = (a + b + c) / 3.0;
        record.middle = kernel::vec3(middle);
        record.radius = static_cast<float>(std::max({glm::length(a - middle), glm::length(b - middle), glm::length(c - middle)}));
        return area;
    }

    struct MeshParts {
        std::vector<std::array<glm::dvec3, 3>> corners;  // of each triangle, in world space
        std::vector<double> areas;
        glm::dvec3 low{1e300}, high{-1e300};

        double radius() const { return 0.5 * glm::length(high - low); }
    };

    MeshParts parts_of(const kernel::InstanceRecord& instance) const {
        const kernel::MeshRecord& mesh = world_.meshes[static_cast<std::size_t>(instance.mesh)];
        MeshParts parts;
        for (int i = 0; i < mesh.triangle_count; ++i) {
            std::array<glm::dvec3, 3> corner;
            for (std::size_t j = 0; j < 3; ++j) {
                const int vertex = world_.indices[static_cast<std::size_t>(3 * (mesh.first_triangle + i)) + j] + mesh.first_vertex;
                corner[j] = apply(instance.to_world, glm::dvec3(world_.positions[static_cast<std::size_t>(vertex)]));
                parts.low = glm::min(parts.low, corner[j]);
                parts.high = glm::max(parts.high, corner[j]);
            }
            parts.corners.push_back(corner);
            parts.areas.push_back(0.5 * glm::length(glm::cross(corner[1] - corner[0], corner[2] - corner[0])));
        }
        return parts;
    }

    // Each triangle as an emitter of its own, where that pays: of a mesh that is spread out, so that from most places some of it is much nearer, or
    // turned otherwise, than the rest. A compact one is better drawn from as a whole.
    bool add_parts(kernel::ObjectRecord& object, const kernel::EmitterRecord& whole) {
        const kernel::InstanceRecord& instance = world_.instances[static_cast<std::size_t>(object.index)];
        const int count = world_.meshes[static_cast<std::size_t>(instance.mesh)].triangle_count;
        if (count > most_parts - parts_) {
            return false;
        }
        const MeshParts parts = parts_of(instance);
        const double area = std::accumulate(parts.areas.begin(), parts.areas.end(), 0.0);
        if (!(area > 0.0) || area > spread_out * 4.0 * std::numbers::pi * parts.radius() * parts.radius()) {
            return false;
        }
        parts_ += count;
        object.emitter = -2 - static_cast<int>(world_.emitters.size());
        const kernel::ColorRecord& emission = world_.surfaces[static_cast<std::size_t>(whole.material)].emission;
        for (std::size_t i = 0; i < parts.areas.size(); ++i) {
            kernel::EmitterRecord record = whole;
            const auto& [a, b, c] = parts.corners[i];
            record.kind = kernel::EMITTER_MESH_TRIANGLE;
            record.first_share = static_cast<int>(i);
            place_corners(a, b, c, instance.flips != 0, record);
            double radiance = brightness(emission.rgb);
            if (whole.textured != 0) {
                radiance = 0.0;
                for (int j = 0; j < points_a_triangle; ++j) {
                    const kernel::Vec2 on = kernel::on_triangle(spread(j, points_a_triangle));
                    const kernel::WorldRecord world = world_.record();
                    radiance += texture_at(kernel::mesh_surface(world, record.index, static_cast<int>(i), on.x, on.y, true), record) /
                                points_a_triangle;
                }
                radiance = std::max(radiance, unseen_light * static_cast<double>(emission.scale));
            }
            record.strength = static_cast<float>(radiance * parts.areas[i]);
            world_.emitters.push_back(record);
        }
        return true;
    }

    double place_mesh(const kernel::InstanceRecord& instance, kernel::EmitterRecord& record) {
        const MeshParts parts = parts_of(instance);
        const std::vector<double>& areas = parts.areas;
        record.kind = kernel::EMITTER_MESH;
        record.first_share = static_cast<int>(world_.distributions.size());
        record.share_count = static_cast<int>(areas.size());
        const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
        if (record.textured == 0) {
            add_shares(areas);
        } else {
            mesh_light_ = add_textured_shares(areas, record);
        }
        record.area = static_cast<float>(sum);
        record.middle = kernel::vec3((parts.low + parts.high) * 0.5);
        record.radius = static_cast<float>(parts.radius());
        return sum * 0.5;
    }

    // Cumulative shares of the sum.
    double add_shares(const std::vector<double>& parts) {
        const double sum = std::accumulate(parts.begin(), parts.end(), 0.0);
        double so_far = 0.0;
        for (const double part : parts) {
            so_far += part;
            world_.distributions.push_back(static_cast<float>(so_far / sum));
        }
        return sum;
    }

    // Triangles by their light, as far as a few points of each show it; what they may hide is worth `unseen_light` of the mean.
    // Returns the mean.
    double add_textured_shares(const std::vector<double>& areas, kernel::EmitterRecord& record) {
        const kernel::WorldRecord world = world_.record();
        std::vector<double> light;
        for (std::size_t i = 0; i < areas.size(); ++i) {
            double sum = 0.0;
            for (int j = 0; j < points_a_triangle; ++j) {
                const kernel::Vec2 on = kernel::on_triangle(spread(j, points_a_triangle));
                sum += texture_at(kernel::mesh_surface(world, record.index, static_cast<int>(i), on.x, on.y, true), record);
            }
            light.push_back(areas[i] * sum / points_a_triangle);
        }
        const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
        const double mean = std::max(std::accumulate(light.begin(), light.end(), 0.0) / area, 1e-30);
        for (std::size_t i = 0; i < areas.size(); ++i) {
            light[i] += unseen_light * mean * areas[i];
        }
        const double sum = add_shares(light);
        record.first_density = static_cast<int>(world_.distributions.size());
        for (std::size_t i = 0; i < areas.size(); ++i) {
            world_.distributions.push_back(static_cast<float>(areas[i] > 0.0 ? light[i] / (sum * areas[i]) : 0.0));
        }
        return mean;
    }

    // Luminance of the lamp's texture.
    double texture_at(const kernel::SurfacePoint& point, const kernel::EmitterRecord& record) const {
        const kernel::WorldRecord world = world_.record();
        const kernel::ColorRecord& emission = world_.surfaces[static_cast<std::size_t>(record.material)].emission;
        const kernel::TextureRecord& texture = world_.textures[static_cast<std::size_t>(emission.texture)];
        const kernel::Vec4 rgb = kernel::texture_color(world, texture, point, true);
        return static_cast<double>(emission.scale) * brightness({rgb.x, rgb.y, rgb.z});
    }

    // Over the whole lamp.
    double mean_of_texture(const kernel::EmitterRecord& record) const {
        const kernel::WorldRecord world = world_.record();
        double mean = mesh_light_;
        if (record.kind != kernel::EMITTER_MESH) {
            double sum = 0.0;
            for (int i = 0; i < points_a_lamp; ++i) {
                sum += texture_at(
                    kernel::emitter_sample(world, record, kernel::broadcast(record.middle), spread(i, points_a_lamp), true).point, record);
            }
            mean = sum / points_a_lamp;
        }
        const kernel::ColorRecord& emission = world_.surfaces[static_cast<std::size_t>(record.material)].emission;
        return std::max(mean, unseen_light * static_cast<double>(emission.scale));
    }

    double place_canonical(const kernel::ObjectRecord& object, const kernel::PlacedRecord& shape, kernel::EmitterRecord& record) {
        using std::numbers::pi;
        record.kind = kernel::EMITTER_PLACED;
        const double bottom = static_cast<double>(shape.bottom_radius), top = static_cast<double>(shape.top_radius);
        glm::dvec3 middle(0.0), half(1.0);
        const kernel::Vec3 grown = kernel::face_growths(shape);
        const glm::dvec3 growth(static_cast<double>(grown.x), static_cast<double>(grown.y), static_cast<double>(grown.z));
        double own = 4.0 * pi;
        double seen = own / 4.0 * std::cbrt(growth.x * growth.y * growth.z);
        if (object.kind == kernel::OBJECT_PLACED_BOX) {
            own = 24.0;
            seen = 2.0 * (growth.x + growth.y + growth.z);
        } else if (object.kind == kernel::OBJECT_PLACED_DISK) {
            own = pi;
            seen = own * growth.y;
            const kernel::Vec3 normal = kernel::normalize(kernel::apply_transposed(shape.to_object, kernel::vec3_of(0.0f, 1.0f, 0.0f)));
            record.direction = {normal.x, normal.y, normal.z};
            record.planar = 1;
            half.y = 0.0;
        } else if (object.kind == kernel::OBJECT_PLACED_CONE) {
            const double side = pi * (bottom + top) * std::sqrt(1.0 + (top - bottom) * (top - bottom));
            const double base = shape.capped != 0 ? pi * bottom * bottom : 0.0;
            const double cap = shape.capped != 0 ? pi * top * top : 0.0;
            own = side + base + cap;
            seen = own / 4.0 * std::cbrt(growth.x * growth.y * growth.z);
            record.side_share = static_cast<float>(side / own);
            record.base_share = static_cast<float>(base / own);
            middle.y = half.y = 0.5;
        }
        record.area = static_cast<float>(own);
        record.middle = kernel::vec3(apply(shape.to_world, middle));
        const kernel::Vec3 reach = kernel::reach_linear(
            shape.to_world, kernel::vec3_of(static_cast<float>(half.x), static_cast<float>(half.y), static_cast<float>(half.z)));
        record.radius = kernel::length(reach);
        return seen;
    }

    const scene::Scene& scene_;
    World& world_;
    Textures& textures_;
    Colors& colors_;
    Photometries photometries_;
    Diagnostics& diagnostics_;
    int parts_ = 0;            // triangles that are emitters of their own
    double mesh_light_ = 0.0;  // mean luminance of the texture of the mesh that was placed last
};

}  // namespace

void compile_emitters(const scene::Scene& scene, World& world, Textures& textures, Colors& colors, Diagnostics& diagnostics) {
    Emitters emitters(scene, world, textures, colors, diagnostics);
    const auto add_lights = [&](bool far) {
        for (const scene::Light& light : scene.lights) {
            if (std::holds_alternative<scene::DirectionalLight>(light.model) == far) {
                emitters.add_light(light);
            }
        }
    };
    add_lights(true);
    emitters.add_sky();
    const std::size_t far_count = world.emitters.size();
    add_lights(false);
    emitters.add_objects();
    emitters.finish(far_count);
}

}  // namespace lancer
