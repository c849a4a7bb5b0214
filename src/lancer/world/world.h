// The immutable flat tables that the kernel reads. compile.h makes them from a scene.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "lancer/kernel/records.h"

namespace lancer {

// The most objects that are tested without a tree: one bit each in a mask of 64. See docs/performance.md.
constexpr std::size_t small_world_objects = 64;

// Owns the tables; `record()` points into them, so a World stays where it was made.
class World {
public:
    World() = default;
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    std::vector<kernel::SphereRecord> spheres;
    std::vector<kernel::BoxRecord> boxes;
    std::vector<kernel::PlaneRecord> planes;
    std::vector<kernel::PlacedRecord> placed;
    std::vector<kernel::TriangleRecord> triangles;
    std::vector<kernel::MeshRecord> meshes;
    std::vector<kernel::InstanceRecord> instances;
    std::vector<kernel::ObjectRecord> objects;
    std::vector<kernel::vec3> positions;  // and one more at the end, which no triangle uses
    std::vector<kernel::vec3> normals;    // as long as positions where any mesh has normals
    std::vector<kernel::vec2> uvs;        // as long as positions where any mesh has texture coordinates
    std::vector<kernel::vec2> second_uvs;
    std::vector<kernel::vec4> tangents;
    std::vector<kernel::vec4> colors;
    std::vector<kernel::vec4> face_colors;  // as long as the triangles where any mesh has colours of faces
    std::vector<int> indices;
    std::vector<kernel::TextureRecord> textures;
    std::vector<int> levels;  // of the textures' pictures, see TextureRecord
    std::vector<int> texels;  // bytes, four to an int
    std::vector<float> float_texels;
    std::vector<kernel::vec3> sky_texels;  // linear RGB, rows from the top
    std::vector<float> decoding;           // where bytes of some picture are sRGB
    std::vector<kernel::InputRecord> inputs;
    std::vector<kernel::WhittedRecord> materials;
    std::vector<kernel::MediumRecord> media;       // of materials[i]
    std::vector<kernel::MaterialRecord> surfaces;  // of materials[i]
    std::vector<kernel::VolumeRecord> volumes;
    std::vector<kernel::GridRecord> grids;
    std::vector<float> voxels;
    std::vector<kernel::EmitterRecord> emitters;
    std::vector<float> light_nodes;  // none where emitters are few
    std::vector<int> light_ways;
    std::vector<float> distributions;
    std::vector<float> curves;
    std::vector<float> filter_places;
    std::vector<float> filter_values;
    std::vector<kernel::vec3> observer;
    std::vector<int> wavelength_slots;
    std::vector<float> wavelength_edges;
    std::vector<float> wavelength_densities;
    std::vector<kernel::LightRecord> lights;
    std::vector<kernel::BandRecord> bands;

    // What the scene's author calls things: for each of objects, and for each of the scene's materials. Those without a name are called by their
    // kind and number: "sphere 3", "material 2".
    std::vector<std::string> names;
    std::vector<int> object_names;  // into names
    std::vector<std::string> material_names;
    const std::string& object_name(int object) const;
    const std::string& material_name(int material) const;
    const char* object_kind(int object) const;  // "sphere", "triangle", ...

    // A sphere around each object, for small worlds only; padded to a multiple of 16 by spheres that nothing meets.
    std::vector<float> bound_x;
    std::vector<float> bound_y;
    std::vector<float> bound_z;
    std::vector<float> bound_radius;

    kernel::CameraRecord camera{};
    kernel::vec3 ambient{0.0f};
    kernel::SkyRecord sky{};
    kernel::FilterRecord filter{};
    bool spectral = false;
    int far_count = 0;  // the first of emitters
    int environment = -1;
    int first_emission = 0;
    kernel::vec3 scene_middle{0.0f};
    float scene_radius = 0.0f;
    int max_depth = 0;
    kernel::PathLimits limits{};
    int ways = kernel::WAYS_BOTH;
    int halves = kernel::HALF_OF_CAMERA;
    int seed = 0;
    int bounces = 0;
    float min_weight = 0.0f;
    float beam = 0.0f;
    bool has_choices = false;
    bool has_cuts = false;
    bool has_own_coats = false;
    bool has_directions = false;
    bool has_transparency = false;
    bool has_media = false;
    bool has_priorities = false;
    int surrounding_volume = -1;
    std::array<int, 4> camera_bodies{-1, -1, -1, -1};  // materials of the bodies that the camera is in, as kernel::Media has them

    // All of it by address, as the kernel takes it.
    kernel::WorldRecord record() const;

    // Bytes held by the tables.
    std::size_t memory() const;

    // Few enough objects to do without a tree: no mesh is left as an instance, and there are no more than small_world_objects.
    bool is_small() const;
};

}  // namespace lancer
