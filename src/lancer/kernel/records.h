// The tables that the kernel reads: plain structs of floats and ints, the same bytes in C++ and in GLSL (scalar block layout).
// world/ writes them, nobody changes them afterwards. Lengths in metres, world space unless a name says otherwise.
#ifndef LANCER_KERNEL_RECORDS_H
#define LANCER_KERNEL_RECORDS_H

#include "lancer/kernel/affine_record.h"
#include "lancer/kernel/language.h"

RECORDS_BEGIN

// ---- Objects. Each kind has its table; objects are numbered through all tables in the order of the kinds. ---------------------------

const int OBJECT_SPHERE = 0;         // spheres[i], in world space
const int OBJECT_BOX = 1;            // boxes[i], axis-aligned in world space
const int OBJECT_PLANE = 2;          // planes[i]
const int OBJECT_PLACED_SPHERE = 3;  // placed[i]: unit sphere at the origin
const int OBJECT_PLACED_BOX = 4;     // placed[i]: the cube from -1 to 1
const int OBJECT_PLACED_DISK = 5;    // placed[i]: unit disk in y = 0, facing +y
const int OBJECT_PLACED_CONE = 6;    // placed[i]: around the y axis from y = 0 (radius bottom) to y = 1 (radius top), maybe capped
const int OBJECT_TRIANGLE = 7;       // triangles[i], of small meshes, in world space
const int OBJECT_MESH = 8;           // instances[i]

struct SphereRecord {
    vec3 center;
    float radius;
};

struct BoxRecord {
    vec3 low;
    vec3 high;
};

// Points p with dot(p, normal) = offset; normals have length 1. Textures live in the author's space.
struct PlaneRecord {
    vec3 normal;
    float offset;
    vec3 author_normal;
    AffineRecord to_author;
};

// A canonical shape in its own space. The author wrote it in yet another one, where solid textures live.
struct PlacedRecord {
    AffineRecord to_object;
    AffineRecord to_world;
    AffineRecord to_author;
    float bottom_radius;
    float top_radius;
    int capped;
};

struct TriangleRecord {
    vec3 a;
    vec3 b;
    vec3 c;
};

// Vertices of all meshes stand one after another; `flags` says which of normals and uvs the mesh has.
struct MeshRecord {
    int first_vertex;
    int first_triangle;
    int triangle_count;
    int flags;
};
const int MESH_HAS_NORMALS = 1;
const int MESH_HAS_UVS = 2;
const int MESH_HAS_SECOND_UVS = 4;
const int MESH_HAS_TANGENTS = 8;
const int MESH_HAS_COLORS = 16;
const int MESH_HAS_FACE_COLORS = 32;

struct InstanceRecord {
    AffineRecord to_world;
    AffineRecord to_object;
    int mesh;
    int flips;  // 1 when the map turns the triangles' winding round
};

struct ObjectRecord {
    int kind;
    int index;  // into the table of its kind
    int material;
    int mesh;      // OBJECT_TRIANGLE: the mesh it comes from, and its number there in `sub`; else 0
    int instance;  // OBJECT_TRIANGLE: the instance it comes from
    int sub;
    int emitter;  // -1: gives no light; below -1: of a mesh whose first triangle is the emitter -2 - this, the second the one after it, ...
};

// ---- Materials ------------------------------------------------------------------------------------------------------------------

const int TEXTURE_NONE = 0;
const int TEXTURE_CHECKER_SOLID = 1;
const int TEXTURE_CHECKER_UV = 2;
const int TEXTURE_IMAGE = 3;
const int TEXTURE_VERTEX_COLOR = 4;  // of the mesh, between its corners
const int TEXTURE_FACE_COLOR = 5;    // of the mesh, one a triangle

const int TINT_NONE = 0;
const int TINT_FIRST = 1;          // times `first`
const int TINT_VERTEX_COLORS = 2;  // times the colours of the vertices, too

const int WRAP_REPEAT = 0;
const int WRAP_CLAMP = 1;
const int WRAP_MIRROR = 2;

const int LOOK_NEAREST = 0;   // the texel under the point
const int LOOK_BILINEAR = 1;  // between four texels
const int LOOK_MIPMAPS = 2;   // the mean over what a path's beam covers of the surface, from smaller copies of the picture

// How texels are stored, in `texels` (bytes, four to an int) or in `float_texels`.
const int TEXELS_GREY8 = 0;
const int TEXELS_RGBA8 = 1;
const int TEXELS_GREY_FLOAT = 2;
const int TEXELS_RGBA_FLOAT = 3;

const int REFRACTION_CAUCHY = 0;     // n = a[0] + a[1] / nm^2; a constant index has a[1] = 0
const int REFRACTION_SELLMEIER = 1;  // a = B1 B2 B3, b = C1 C2 C3 in square micrometres
const int REFRACTION_CURVE = 2;      // curves[curve]
const int REFRACTION_NONE = 3;       // that of whatever is around it

struct TextureRecord {
    int kind;
    vec3 first;  // of a checker; of pictures and colours of the mesh what they are multiplied with
    vec3 second;
    int tint;    // TINT_*
    float size;  // of a checker's cells
    vec3 row_u;  // where the picture is looked up: (row_u . (u, v, 1), row_v . (u, v, 1))
    vec3 row_v;
    int uv_set;  // 0 or 1
    int wrap_u;
    int wrap_v;
    int look;
    int storage;
    int encoded;      // 1: bytes of colours are decoded from sRGB
    int first_level;  // into levels, three ints each: first texel (rows from the top), width, height; each half of the one before
    int level_count;
};

struct WhittedRecord {
    vec3 color;
    int texture;  // -1: none
    float ambient;
    float diffuse;
    float highlight;
    float shininess;
    float reflectivity;
    float transparency;
};

// What fills a transparent body; media[i] belongs to materials[i].
struct MediumRecord {
    int refraction;
    int dispersive;
    vec3 refraction_a;
    vec3 refraction_b;
    vec3 absorption;  // linear RGB, per metre
    int curve;
    int volume;    // into volumes, -1: clear, or only absorbing, see MaterialRecord
    int priority;  // where bodies overlap
};

// ---- Lights, camera, surroundings -------------------------------------------------------------------------------------------------

const int LIGHT_POINT = 0;
const int LIGHT_SPOT = 1;
const int LIGHT_DIRECTIONAL = 2;

const int FADE_SMOOTH = 0;  // of a spot towards the end of its cone: by a smooth step of the cosine
const int FADE_EVEN = 1;    // evenly with the angle
const int FADE_SQUARE = 2;  // with the square of what the cosine has left

struct LightRecord {
    int kind;
    vec3 position;
    vec3 direction;  // the way the light travels, length 1
    vec3 radiance;   // colour times share
    float cos_outer;
    float cos_inner;
    int fade;
};

const int CAMERA_PERSPECTIVE = 0;   // a point of the film (x, y) in pixels maps to the direction corner + x * step_x + y * step_y
const int CAMERA_ORTHOGRAPHIC = 1;  // to the origin corner + x * step_x + y * step_y; all look along `forward`
const int CAMERA_PANORAMA = 2;      // to longitude and latitude: the picture's width spans 360 degrees, its height 180
const int CAMERA_KINDS = 3;

struct CameraRecord {
    vec3 position;
    vec3 corner;
    vec3 step_x;
    vec3 step_y;
    vec3 right;  // right, down and forward have length 1
    vec3 down;
    vec3 forward;
    int kind;
    float lens_radius;     // 0: a pinhole
    float focus_distance;  // of the plane that is sharp, along `forward`
    float width;           // of the film, in pixels
    float height;
};

const int MAX_BOUNCES = 24;

struct BandRecord {
    float nanometres;
    vec3 weight;
};

RECORDS_END

#include "lancer/kernel/physical_records.h"

RECORDS_BEGIN

TABLE(SphereRecord, SphereTable)
TABLE(BoxRecord, BoxTable)
TABLE(PlaneRecord, PlaneTable)
TABLE(PlacedRecord, PlacedTable)
TABLE(TriangleRecord, TriangleTable)
TABLE(MeshRecord, MeshTable)
TABLE(InstanceRecord, InstanceTable)
TABLE(ObjectRecord, ObjectTable)
TABLE(TextureRecord, TextureTable)
TABLE(WhittedRecord, WhittedTable)
TABLE(MediumRecord, MediumTable)
TABLE(MaterialRecord, MaterialTable)
TABLE(VolumeRecord, VolumeTable)
TABLE(GridRecord, GridTable)
TABLE(EmitterRecord, EmitterTable)
TABLE(LightRecord, LightTable)
TABLE(BandRecord, BandTable)
TABLE(vec3, Vec3Table)
TABLE(vec2, Vec2Table)
TABLE(vec4, Vec4Table)
TABLE(InputRecord, InputTable)
TABLE(int, IntTable)
TABLE(float, FloatTable)

// Everything there is, by address.
struct WorldRecord {
    SphereTable spheres;
    BoxTable boxes;
    PlaneTable planes;
    PlacedTable placed;
    TriangleTable triangles;
    MeshTable meshes;
    InstanceTable instances;
    ObjectTable objects;
    Vec3Table positions;
    Vec3Table normals;
    Vec2Table uvs;
    Vec2Table second_uvs;
    Vec4Table tangents;     // of length 1; w is the side on which v grows, 1 or -1
    Vec4Table colors;       // linear RGB and alpha
    Vec4Table face_colors;  // of each triangle
    IntTable indices;       // three a triangle, counted from the mesh's first vertex
    TextureTable textures;
    IntTable levels;
    IntTable texels;
    FloatTable float_texels;
    Vec3Table sky_texels;
    FloatTable decoding;  // from bytes to linear light, 256 values
    InputTable inputs;
    WhittedTable materials;
    MediumTable media;
    MaterialTable surfaces;  // surfaces[i] is materials[i] for light that follows physics
    VolumeTable volumes;
    GridTable grids;
    FloatTable voxels;
    EmitterTable emitters;
    FloatTable light_nodes;           // see NODE_MIDDLE
    IntTable light_ways;              // of each emitter: its way down the tree, a bit a node from the lowest; -1: it is not there
    FloatTable distributions;         // cumulative shares, see EmitterRecord
    FloatTable curves;                // WAVELENGTH_COUNT values each
    FloatTable upsampling;            // from RGB to smooth spectra, see upsample.h
    FloatTable albedo;                // what rough surfaces reflect, see bsdf/albedo.h
    FloatTable filter_places;         // see FilterRecord
    Vec3Table observer;               // linear RGB of one unit at each nanometre
    IntTable wavelength_slots;        // the nanometre in which each begins, see spectrum.h
    FloatTable wavelength_edges;      // of the random number, between the nanometres
    FloatTable wavelength_densities;  // with which each nanometre is drawn
    LightTable lights;
    BandTable bands;
    IntTable light_vertices;   // the device's own, opaque: see bidirectional/vertex.h
    FloatTable filter_values;  // of the pixel's filter, see filter_value
    IntTable tree;             // the device's own search tree, opaque; null where every object is tested against every ray
    FloatTable bound_x;        // a sphere around each object of a small world, coordinate by coordinate; planes have an infinite radius
    FloatTable bound_y;
    FloatTable bound_z;
    FloatTable bound_radius;
    int object_count;
    int sphere_count;
    int box_count;
    int plane_count;
    int placed_count;
    int triangle_count;
    int instance_count;
    int light_count;
    int emitter_count;
    int far_count;       // emitters of the tree come after those that are infinitely far
    int has_tree;        // 0: so few emitters that each is looked at
    int environment;     // the emitter that is the sky, -1: none
    int first_emission;  // into distributions: cumulative shares of the emitters' power
    vec3 scene_middle;   // of a sphere around all that is not infinite
    float scene_radius;
    int spectral;   // 0: linear RGB
    int watched;    // 1: a path's steps tell what they meet
    int max_depth;  // vertices of a path after the camera, at most
    PathLimits limits;
    int ways;    // WAYS_*
    int halves;  // HALF_* or HALVES_*: which ends paths are followed from
    FilterRecord filter_record;
    int seed;
    int band_count;
    int bounces;
    float min_weight;    // of a path worth following
    int has_choices;     // 1: some material is a mix or has another one behind
    int has_cuts;        // 1: some material is not there everywhere, or a pane
    int has_directions;  // 1: some surface has a direction, see MATERIAL_TURNED
    int has_own_coats;   // 1: see MATERIAL_OWN_COAT
    float beam;          // share of a pixel's width that each of its samples stands for; 0: no texture asks
    int has_transparency;
    int has_media;           // 1: there are volumes, null borders or priorities
    int has_priorities;      // 1: not all bodies have the same
    int surrounding_volume;  // into volumes, -1: nothing
    int camera_first;        // the bodies that the camera is in, as Media has them
    int camera_second;
    int camera_third;
    int camera_fourth;
    vec3 ambient;
    SkyRecord sky;
    CameraRecord camera;
};

RECORDS_END

#ifdef __cplusplus
namespace lancer::kernel {
static_assert(sizeof(vec3) == 12 && sizeof(vec2) == 8, "records have scalar layout");
static_assert(sizeof(SphereRecord) == 16 && sizeof(BoxRecord) == 24 && sizeof(PlaneRecord) == 76 && sizeof(AffineRecord) == 48 &&
              sizeof(PlacedRecord) == 156 && sizeof(TriangleRecord) == 36 && sizeof(InstanceRecord) == 104 && sizeof(ObjectRecord) == 28 &&
              sizeof(TextureRecord) == 92 && sizeof(WhittedRecord) == 40 && sizeof(MediumRecord) == 56 && sizeof(LightRecord) == 52 &&
              sizeof(CameraRecord) == 104);
}  // namespace lancer::kernel
#endif

#endif
