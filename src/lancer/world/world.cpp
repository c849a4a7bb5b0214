#include "lancer/world/world.h"

#include "lancer/spectrum/upsample.h"
#include "lancer/world/albedo_table.h"

namespace lancer {

namespace {

template <class T>
std::size_t bytes(const std::vector<T>& table) {
    return table.size() * sizeof(T);
}

}  // namespace

kernel::WorldRecord World::record() const {
    kernel::WorldRecord r{};
    r.spheres = spheres.data();
    r.boxes = boxes.data();
    r.planes = planes.data();
    r.placed = placed.data();
    r.triangles = triangles.data();
    r.meshes = meshes.data();
    r.instances = instances.data();
    r.objects = objects.data();
    r.positions = positions.data();
    r.normals = normals.data();
    r.uvs = uvs.data();
    r.second_uvs = second_uvs.data();
    r.tangents = tangents.data();
    r.colors = colors.data();
    r.face_colors = face_colors.data();
    r.indices = indices.data();
    r.textures = textures.data();
    r.levels = levels.data();
    r.texels = texels.data();
    r.float_texels = float_texels.data();
    r.sky_texels = sky_texels.data();
    r.decoding = decoding.data();
    r.inputs = inputs.data();
    r.materials = materials.data();
    r.media = media.data();
    r.surfaces = surfaces.data();
    r.volumes = volumes.data();
    r.grids = grids.data();
    r.voxels = voxels.data();
    r.emitters = emitters.data();
    r.light_nodes = light_nodes.data();
    r.light_ways = light_ways.data();
    r.distributions = distributions.data();
    r.curves = curves.data();
    r.upsampling = upsampling_table().data();
    r.albedo = microfacet_albedo_table().data();
    r.filter_places = filter_places.data();
    r.observer = observer.data();
    r.wavelength_slots = wavelength_slots.data();
    r.wavelength_edges = wavelength_edges.data();
    r.wavelength_densities = wavelength_densities.data();
    r.lights = lights.data();
    r.bands = bands.data();
    r.filter_values = filter_values.data();
    r.light_vertices = nullptr;
    r.tree = nullptr;
    r.bound_x = bound_x.data();
    r.bound_y = bound_y.data();
    r.bound_z = bound_z.data();
    r.bound_radius = bound_radius.data();
    r.object_count = static_cast<int>(objects.size());
    r.sphere_count = static_cast<int>(spheres.size());
    r.box_count = static_cast<int>(boxes.size());
    r.plane_count = static_cast<int>(planes.size());
    r.placed_count = static_cast<int>(placed.size());
    r.triangle_count = static_cast<int>(triangles.size());
    r.instance_count = static_cast<int>(instances.size());
    r.light_count = static_cast<int>(lights.size());
    r.band_count = static_cast<int>(bands.size());
    r.emitter_count = static_cast<int>(emitters.size());
    r.far_count = far_count;
    r.has_tree = light_nodes.empty() ? 0 : 1;
    r.environment = environment;
    r.first_emission = first_emission;
    r.scene_middle = scene_middle;
    r.scene_radius = scene_radius;
    r.spectral = spectral ? 1 : 0;
    r.max_depth = max_depth;
    r.limits = limits;
    r.ways = ways;
    r.halves = halves;
    r.filter_record = filter;
    r.seed = seed;
    r.sky = sky;
    r.bounces = bounces;
    r.min_weight = min_weight;
    r.beam = beam;
    r.has_choices = has_choices ? 1 : 0;
    r.has_cuts = has_cuts ? 1 : 0;
    r.has_directions = has_directions ? 1 : 0;
    r.has_own_coats = has_own_coats ? 1 : 0;
    r.has_transparency = has_transparency ? 1 : 0;
    r.has_media = has_media ? 1 : 0;
    r.has_priorities = has_priorities ? 1 : 0;
    r.surrounding_volume = surrounding_volume;
    r.camera_first = camera_bodies[0];
    r.camera_second = camera_bodies[1];
    r.camera_third = camera_bodies[2];
    r.camera_fourth = camera_bodies[3];
    r.ambient = ambient;
    r.camera = camera;
    return r;
}

std::size_t World::memory() const {
    return bytes(spheres) + bytes(boxes) + bytes(planes) + bytes(placed) + bytes(triangles) + bytes(meshes) + bytes(instances) +
           bytes(objects) + bytes(positions) + bytes(normals) + bytes(uvs) + bytes(indices) + bytes(textures) + bytes(texels) +
           bytes(float_texels) + bytes(sky_texels) + bytes(second_uvs) + bytes(tangents) + bytes(colors) + bytes(face_colors) +
           bytes(levels) + bytes(inputs) + bytes(materials) + bytes(media) + bytes(surfaces) + bytes(emitters) + bytes(distributions) +
           bytes(light_nodes) + bytes(light_ways) + bytes(curves) + bytes(observer) + bytes(lights) + bytes(bands) + bytes(volumes) +
           bytes(grids) + bytes(voxels);
}

namespace {

const std::string& name_at(const std::vector<std::string>& names, int number) {
    static const std::string nameless = "nameless";
    return number >= 0 && static_cast<std::size_t>(number) < names.size() ? names[static_cast<std::size_t>(number)] : nameless;
}

}  // namespace

const std::string& World::object_name(int object) const {
    const bool known = object >= 0 && static_cast<std::size_t>(object) < object_names.size();
    return name_at(names, known ? object_names[static_cast<std::size_t>(object)] : -1);
}

const std::string& World::material_name(int material) const { return name_at(material_names, material); }

const char* World::object_kind(int object) const {
    switch (objects.at(static_cast<std::size_t>(object)).kind) {
        case kernel::OBJECT_SPHERE:
        case kernel::OBJECT_PLACED_SPHERE:
            return "sphere";
        case kernel::OBJECT_BOX:
        case kernel::OBJECT_PLACED_BOX:
            return "box";
        case kernel::OBJECT_PLANE:
            return "plane";
        case kernel::OBJECT_PLACED_DISK:
            return "disk";
        case kernel::OBJECT_PLACED_CONE:
            return "cone";
        default:
            return "mesh";
    }
}

bool World::is_small() const {
    return objects.size() <= small_world_objects && (objects.empty() || objects.back().kind != kernel::OBJECT_MESH);
}

}  // namespace lancer
