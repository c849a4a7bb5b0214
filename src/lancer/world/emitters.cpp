#include "lancer/world/emitters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/kernel/emitter.h"
#include "lancer/world/spectra.h"

namespace lancer {

namespace {

// With more emitters than this, looking at each for every choice costs more than choosing better gains.
constexpr std::size_t few_emitters = 32;

double brightness(const kernel::vec3& rgb) { return std::max(0.0, glm::dot(glm::dvec3(rgb), glm::dvec3(0.2126, 0.7152, 0.0722))); }

glm::dvec3 apply(const kernel::AffineRecord& map, const glm::dvec3& p) {
    return glm::dvec3(glm::dot(glm::dvec3(map.row_x), p), glm::dot(glm::dvec3(map.row_y), p), glm::dot(glm::dvec3(map.row_z), p)) +
           glm::dvec3(map.shift);
}

class Emitters {
public:
    Emitters(World& world, Colors& colors, Diagnostics& diagnostics) : world_(world), colors_(colors), diagnostics_(diagnostics) {}

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
            record.cos_outer = static_cast<float>(std::cos(glm::radians(spot->angle)));
            const auto inner = static_cast<float>(std::cos(glm::radians(std::max(0.0, spot->angle - spot->falloff))));
            record.cos_inner = std::max(inner, std::nextafter(record.cos_outer, 2.0f));
        } else if (const auto* sun = std::get_if<scene::DirectionalLight>(&light.model)) {
            record.kind = kernel::EMITTER_DIRECTIONAL;
            record.direction = kernel::vec3(glm::normalize(sun->direction));
        }
        record.middle = record.position;
        world_.emitters.push_back(record);
    }

    void add_surroundings(const scene::Background& background) {
        const scene::Rgb zenith = emitted(background.zenith), horizon = emitted(background.horizon), nadir = emitted(background.nadir);
        const scene::Rgb all = glm::max(glm::max(zenith, horizon), nadir);
        if (!(std::max({all.x, all.y, all.z}) > 0.0)) {
            return;
        }
        world_.sky_zenith = colors_.light(background.zenith);
        world_.sky_horizon = colors_.light(background.horizon);
        world_.sky_nadir = colors_.light(background.nadir);
        kernel::EmitterRecord record = no_emitter();
        record.kind = kernel::EMITTER_ENVIRONMENT;
        record.strength = static_cast<float>(std::numbers::pi * brightness(kernel::vec3((zenith + horizon * 2.0 + nadir) * 0.25)));
        world_.environment = static_cast<int>(world_.emitters.size());
        world_.emitters.push_back(record);
    }

    void add_objects() {
        for (std::size_t i = 0; i < world_.objects.size(); ++i) {
            kernel::ObjectRecord& object = world_.objects[i];
            const kernel::MaterialRecord& material = world_.surfaces[static_cast<std::size_t>(object.material)];
            if ((material.flags & kernel::MATERIAL_EMITS) == 0) {
                continue;
            }
            kernel::EmitterRecord record = no_emitter();
            record.index = object.index;
            record.object = static_cast<int>(i);
            record.material = object.material;
            record.two_sided = (material.flags & kernel::MATERIAL_EMITS_BEHIND) != 0 ? 1 : 0;
            const double seen_area = place(object, record);
            if (!(seen_area > 0.0)) {
                continue;
            }
            const double radiance =
                material.emission.texture >= 0 ? static_cast<double>(material.emission.scale) : brightness(material.emission.rgb);
            if (radiance > 0.0) {
                record.strength = static_cast<float>(radiance * seen_area);
                object.emitter = static_cast<int>(world_.emitters.size());
                world_.emitters.push_back(record);
            }
        }
    }

    // Cumulative shares by strength for the choice among many.
    void finish() {
        if (world_.emitters.size() <= few_emitters) {
            return;
        }
        world_.chosen_by_strength = true;
        double sum = 0.0;
        for (const kernel::EmitterRecord& emitter : world_.emitters) {
            sum += weight(emitter);
        }
        std::vector<float> shares;
        double so_far = 0.0;
        for (const kernel::EmitterRecord& emitter : world_.emitters) {
            so_far += weight(emitter);
            shares.push_back(static_cast<float>(so_far / sum));
        }
        shares.back() = 1.0f;
        for (kernel::EmitterRecord& emitter : world_.emitters) {
            emitter.first_share += static_cast<int>(shares.size());
        }
        world_.distributions.insert(world_.distributions.begin(), shares.begin(), shares.end());
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

    // Far lights make the same irradiance everywhere; near ones are compared at the distance of their own size, at least.
    static double weight(const kernel::EmitterRecord& emitter) {
        const double distance = std::max(1.0, static_cast<double>(emitter.radius));
        return std::max(static_cast<double>(emitter.strength) / (distance * distance), 1e-30);
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
            diagnostics_.error({}, "an infinite plane can't be a lamp: its light would be infinite");
            return 0.0;
        }
        return place_canonical(object, world_.placed[index], record);
    }

    double place_triangle(const kernel::ObjectRecord& object, const kernel::TriangleRecord& t, kernel::EmitterRecord& record) {
        const glm::dvec3 a(t.a), b(t.b), c(t.c);
        const glm::dvec3 across = glm::cross(b - a, c - a);
        const double area = 0.5 * glm::length(across);
        record.kind = kernel::EMITTER_TRIANGLE;
        record.area = static_cast<float>(area);
        const bool flips = world_.instances[static_cast<std::size_t>(object.instance)].flips != 0;
        record.direction = area > 0.0 ? kernel::vec3(glm::normalize(flips ? -across : across)) : kernel::vec3(0.0f);
        const glm::dvec3 middle = (a + b + c) / 3.0;
        record.middle = kernel::vec3(middle);
        record.radius = static_cast<float>(std::max({glm::length(a - middle), glm::length(b - middle), glm::length(c - middle)}));
        return area;
    }

    double place_mesh(const kernel::InstanceRecord& instance, kernel::EmitterRecord& record) {
        const kernel::MeshRecord& mesh = world_.meshes[static_cast<std::size_t>(instance.mesh)];
        record.kind = kernel::EMITTER_MESH;
        record.first_share = static_cast<int>(world_.distributions.size());
        record.share_count = mesh.triangle_count;
        std::vector<double> areas;
        glm::dvec3 low(1e300), high(-1e300);
        double sum = 0.0;
        for (int i = 0; i < mesh.triangle_count; ++i) {
            glm::dvec3 corner[3];
            for (int j = 0; j < 3; ++j) {
                const int vertex = world_.indices[static_cast<std::size_t>(3 * (mesh.first_triangle + i) + j)] + mesh.first_vertex;
                corner[j] = apply(instance.to_world, glm::dvec3(world_.positions[static_cast<std::size_t>(vertex)]));
                low = glm::min(low, corner[j]);
                high = glm::max(high, corner[j]);
            }
            sum += 0.5 * glm::length(glm::cross(corner[1] - corner[0], corner[2] - corner[0]));
            areas.push_back(sum);
        }
        for (const double area : areas) {
            world_.distributions.push_back(static_cast<float>(area / sum));
        }
        record.area = static_cast<float>(sum);
        record.middle = kernel::vec3((low + high) * 0.5);
        record.radius = static_cast<float>(0.5 * glm::length(high - low));
        return sum * 0.5;
    }

    double place_canonical(const kernel::ObjectRecord& object, const kernel::PlacedRecord& shape, kernel::EmitterRecord& record) {
        using std::numbers::pi;
        record.kind = kernel::EMITTER_PLACED;
        const double bottom = static_cast<double>(shape.bottom_radius), top = static_cast<double>(shape.top_radius);
        glm::dvec3 middle(0.0), half(1.0);
        const auto growth = [&](float x, float y, float z) {
            return static_cast<double>(kernel::area_growth(shape, kernel::vec3_of(x, y, z)));
        };
        double own = 4.0 * pi;
        double seen = own / 4.0 * std::cbrt(growth(1, 0, 0) * growth(0, 1, 0) * growth(0, 0, 1));
        if (object.kind == kernel::OBJECT_PLACED_BOX) {
            own = 24.0;
            seen = 2.0 * (growth(1, 0, 0) + growth(0, 1, 0) + growth(0, 0, 1));
        } else if (object.kind == kernel::OBJECT_PLACED_DISK) {
            own = pi;
            seen = own * growth(0, 1, 0);
            half.y = 0.0;
        } else if (object.kind == kernel::OBJECT_PLACED_CONE) {
            const double side = pi * (bottom + top) * std::sqrt(1.0 + (top - bottom) * (top - bottom));
            const double base = shape.capped != 0 ? pi * bottom * bottom : 0.0;
            const double cap = shape.capped != 0 ? pi * top * top : 0.0;
            own = side + base + cap;
            seen = own / 4.0 * std::cbrt(growth(1, 0, 0) * growth(0, 1, 0) * growth(0, 0, 1));
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

    World& world_;
    Colors& colors_;
    Diagnostics& diagnostics_;
};

}  // namespace

void compile_emitters(const scene::Scene& scene, World& world, Colors& colors, Diagnostics& diagnostics) {
    Emitters emitters(world, colors, diagnostics);
    for (const scene::Light& light : scene.lights) {
        emitters.add_light(light);
    }
    emitters.add_surroundings(scene.background);
    emitters.add_objects();
    emitters.finish();
}

}  // namespace lancer
