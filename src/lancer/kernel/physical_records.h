// Records of light that follows physics: spectra, materials, emitters. Included by records.h.
#ifndef LANCER_KERNEL_PHYSICAL_RECORDS_H
#define LANCER_KERNEL_PHYSICAL_RECORDS_H

#include "lancer/kernel/affine_record.h"
#include "lancer/kernel/language.h"

RECORDS_BEGIN

// A reflectance, an index or a light, at any point of a surface. Spectral: scale * (texture, curve or smooth spectrum of three coefficients) *
// illuminant; as RGB: `rgb`, or scale * texture.
struct ColorRecord {
    vec3 rgb;           // all of it, where there is no texture
    vec3 coefficients;  // see upsample.h
    float scale;
    int curve;       // into curves, -1: none
    int illuminant;  // into curves, -1: a constant 1
    int texture;     // into textures, -1: none
};

// How light scatters. Each kind has its file in bsdf/.
const int BSDF_NONE = 0;  // all light is swallowed
const int BSDF_DIFFUSE = 1;
const int BSDF_ROUGH_DIFFUSE = 2;
const int BSDF_CONDUCTOR = 3;
const int BSDF_DIELECTRIC = 4;
const int BSDF_THIN_DIELECTRIC = 5;
const int BSDF_PLASTIC = 6;
const int BSDF_PRINCIPLED = 7;
const int BSDF_BURLEY = 8;
const int BSDF_KINDS = 9;
const int BSDF_NULL = 15;  // the border of a medium: light passes as if there were nothing

// How media scatter, see volume/phase.h.
const int PHASE_HENYEY_GREENSTEIN = 16;
const int PHASE_RAYLEIGH = 17;

const int MATERIAL_EMITS = 1;
const int MATERIAL_EMITS_BEHIND = 2;     // on its inner side, too
const int MATERIAL_ONE_SIDED = 4;        // seen from within it is black
const int MATERIAL_BECKMANN = 8;         // its facets follow Beckmann's distribution, else GGX
const int MATERIAL_SATURATES = 16;       // plastic: light that the coat sends back to the body takes its colour once more
const int MATERIAL_THIN = 32;            // principled: a sheet without inside; what goes through is not bent
const int MATERIAL_MAPPED = 64;          // needs to know how uv lies on the surface
const int MATERIAL_TINTED = 128;         // needs the colours of vertices or faces
const int MATERIAL_TURNED = 256;         // has a direction on the surface: u
const int MATERIAL_RELIEF = 512;         // its normals are bent by a texture
const int MATERIAL_CHOOSES = 1024;       // is a mix, or has another material behind
const int MATERIAL_CUT = 2048;           // is not there everywhere, see `opacity`
const int MATERIAL_OPEN_BEHIND = 4096;   // nor where it is met from within; always cut, too
const int MATERIAL_BODY = 8192;          // a clear body, whose border bends all light that goes through
const int MATERIAL_SEPARATE = 32768;     // its facets hide one another towards either direction by itself
const int MATERIAL_BLENDS = 131072;      // a mix of two diffuse surfaces, looked at as one of the mixed colour
const int MATERIAL_HILLS = 262144;       // its bent normals hide from one another, see relief.h
const int MATERIAL_ONCE = 65536;         // light that meets several of its facets is lost
const int MATERIAL_PANE = 524288;        // a smooth sheet: paths pass it like a cut surface, and meet it only to be mirrored
const int MATERIAL_BOUNDS = 1048576;     // a pane with an interior, which begins behind it
const int MATERIAL_OWN_COAT = 4194304;   // principled: its coat does not follow the normals of what it covers
const int MATERIAL_CROSSWISE = 2097152;  // y of its normal map lies along the cross product of the normal and x, wherever v grows

// A number of a material that a texture gives: offset + scale * channel.
const int INPUT_ROUGHNESS = 0;  // its square is alpha; rough diffuse surfaces take it as it is
const int INPUT_ANISOTROPY = 1;
const int INPUT_METALNESS = 2;
const int INPUT_TRANSMISSION = 3;
const int INPUT_COAT = 4;
const int INPUT_COAT_ROUGHNESS = 5;
const int INPUT_SHEEN_ROUGHNESS = 6;
const int INPUT_FILM = 7;     // nanometres
const int INPUT_OPACITY = 8;  // this and the rest: referred to by the record itself
const int INPUT_SHARE = 9;
const int INPUT_HEIGHT = 10;  // metres
const int INPUT_PASSES = 11;  // Burley's sheets: the share of the diffuse light that goes through
const int INPUT_KINDS = 12;

struct InputRecord {
    int kind;
    int texture;
    int channel;  // 0 to 3: red, green, blue, alpha
    float scale;
    float offset;
};

struct MaterialRecord {
    int kind;
    int flags;
    ColorRecord color;       // what it reflects; principled: base colour
    ColorRecord index;       // conductors: n; principled: what its sheen reflects, colour times weight
    ColorRecord extinction;  // conductors: k; plastic and principled: tint of what its surface reflects, 1 in nature
    ColorRecord emission;    // radiance
    float roughness_x;       // of microfacets: alpha; of rough diffuse surfaces: 0 to 1
    float roughness_y;
    ColorRecord clearness;  // of a transparent body: what is left of light after `clear_distance` metres
    float clear_distance;   // 0: all is left, whatever the distance
    float eta;              // plastic and principled: index of refraction of the body
    float metalness;        // principled, from here on: 0 to 1
    float transmission;     // of what is no metal, the share that is clear and not diffuse: 0 to 1
    float coat;             // how much of it has a clear coat: 0 to 1
    float coat_roughness;   // of microfacets: alpha
    float coat_index;       // index of refraction, 1.5
    float sheen_roughness;  // 0 to 1; Burley's: how much sheen
    float film_thickness;   // nanometres of a film on it, 0: none
    float film_index;       // index of refraction of the film, 1.3; Burley's sheets: the share of the diffuse light that goes through
    int first_input;        // into inputs: what textures give instead, in the order of the kinds
    int input_count;
    int normal_map;       // 1 + texture; 0: none
    vec2 normal_scale;    // of its first two channels; a negative second one turns them over
    int height_input;     // 1 + input: bumps; 0: none
    int coat_normal_map;  // 1 + texture: of a coat with normals of its own; 0: those of the shape
    vec2 coat_normal_scale;
    int turn_map;          // 1 + texture: red and green are the way along u and v in which it is smooth; 0: along u
    vec2 turn;             // cosine and sine of an angle, anticlockwise, by which that is turned
    float opacity;         // the chance that a path meets it at all
    int opacity_input;     // 1 + input, instead; 0: none
    float opacity_cutoff;  // met always where the opacity is at least this, else never; 0: by chance
    int behind;            // 1 + the material that is seen from within; 0: itself
    int mix_first;         // 1 + a material; 0: no mix
    int mix_second;        // 1 + the other one,
    float mix_share;       // with this chance
    int mix_input;         // 1 + input, instead; 0: none
    float sheen_tint;      // Burley's: how much of the base's colour the sheen takes: 0 to 1
    float specular_tint;   // and what is reflected
    float flatness;        // how flat its body looks: 0 to 1
    float brightness;      // luminance of the base's colour
};

const int VOLUME_SCATTERS = 1;
const int VOLUME_EMITS = 2;
const int VOLUME_HAS_ALBEDO = 4;

const int HEAT_ENTRIES = 128;  // of a table of black bodies

// What fills space.
struct VolumeRecord {
    ColorRecord first;     // with VOLUME_HAS_ALBEDO extinction, else absorption; per metre
    ColorRecord second;    // the albedo, else scattering per metre
    ColorRecord emission;  // radiance where nothing shines through
    int flags;
    int phase;             // PHASE_*
    float asymmetry;       // of Henyey and Greenstein's, -0.999 to 0.999
    int grid;              // into grids: the density, which extinction is multiplied by; -1: 1 everywhere
    int albedo_grid;       // instead of the albedo; -1: none
    int temperature_grid;  // kelvin; -1: none
    int heat;              // the spectra of HEAT_ENTRIES black bodies from 0 K on: the first one's curve, or as RGB its place in voxels
    float heat_steps;      // entries a kelvin
};

// Numbers in the cells of a box, and for each block of cells the largest of any place in it.
struct GridRecord {
    AffineRecord to_grid;  // the box becomes the unit cube
    int columns;
    int rows;
    int layers;
    int channels;  // 1 or 3
    int first;     // into voxels: x runs fastest, then y, then z
    int block;     // cells along the side of a block
    int blocks_x;
    int blocks_y;
    int blocks_z;
    int first_block;  // into voxels
};

const int EMITTER_POINT = 0;
const int EMITTER_SPOT = 1;
const int EMITTER_DIRECTIONAL = 2;
const int EMITTER_ENVIRONMENT = 3;
const int EMITTER_SPHERE = 4;     // spheres[index]
const int EMITTER_TRIANGLE = 5;   // triangles[index]
const int EMITTER_MESH = 6;       // instances[index]
const int EMITTER_PLACED = 7;     // placed[index]
const int EMITTER_PROJECTOR = 8;  // these have no size and throw a picture, see emitter/thrown.h
const int EMITTER_GONIOMETRIC = 9;
const int EMITTER_IES = 10;
const int EMITTER_MESH_TRIANGLE = 11;  // triangle `first_share` of instances[index]
const int EMITTER_KINDS = 12;

struct EmitterRecord {
    int kind;
    int index;
    int object;    // -1: none, a light without size
    int material;  // of the object
    int two_sided;
    ColorRecord light;  // radiant intensity, irradiance or radiance of lights that are no objects
    vec3 position;
    vec3 direction;  // the way the light travels, length 1
    float cos_outer;
    float cos_inner;
    float strength;    // about the irradiance it makes: of the far ones as it is, of near ones at a distance of one metre
    vec3 middle;       // of a sphere around it
    float radius;      // of that sphere
    float area;        // in world space; of placed shapes in their own
    float side_share;  // of that area, the side of a cone
    float base_share;  // and its lower cap
    int first_share;   // meshes: into distributions, triangle_count cumulative shares of the area, or of the light where a texture makes it
    int share_count;
    int planar;  // all of it lies in one plane; `direction` is its normal
    int textured;
    int first_density;  // textured meshes: into distributions, density per square metre on each triangle
    vec3 across;        // of thrown pictures: to the right, up (length 1; of projectors over the tangent of half the field of view)
    vec3 upwards;
    int columns;  // of their cells to draw from; first_share, share_count: cumulative shares of rows from below, then of each row's cells
    int even;     // projectors: as bright everywhere on a screen
    int fade;     // spots: FADE_*
    int profile;  // IES: into distributions: how many vertical angles, how many horizontal ones, the angles in half and in full turns, the intensities
};

// A node of the tree of near emitters: a sphere around them, and the directions in which they send light [Conty Estevez and Kulla 2018]. Twelve numbers
// side by side in light_nodes; a node's two children stand one after the other.
const int NODE_MIDDLE = 0;    // three numbers; world space
const int NODE_RADIUS = 3;    // of the sphere, metres
const int NODE_AXIS = 4;      // three numbers, length 1
const int NODE_SPREAD = 7;    // cosine of the largest angle between the axis and an emitter's own axis
const int NODE_REACH = 8;     // cosine of how far beyond light goes
const int NODE_POWER = 9;     // sum of EmitterRecord::strength
const int NODE_CHILD = 10;    // the first child; of leaves -1 - emitter
const int NODE_TWOFOLD = 11;  // 1: the same to the axis's other side
const int NODE_HALF = 12;     // three numbers: half the sides of the box around them
const int NODE_SIZE = 15;

const int SKY_NONE = 0;
const int SKY_EVEN = 1;      // `horizon` everywhere
const int SKY_GRADIENT = 2;  // from below to above
const int SKY_IMAGE = 3;
const int SKY_MODEL = 4;  // computed spectra, and the sun; as RGB and to be drawn from it is an image, too
const int SKY_KINDS = 5;

// Of a computed sky: radiance at so many azimuths from the sun, of each at so many elevations, of each at so many wavelengths; see emitter/sky_model.h.
const int MODEL_AZIMUTHS = 33;
const int MODEL_ELEVATIONS = 49;
const int MODEL_WAVELENGTHS = 25;
const float MODEL_STEP = 20.0f;  // nanometres, from 360 on

// Where no object is. An image is `scale` times sky_texels, `height` rows of `width`, under the illuminant of `horizon`.
struct SkyRecord {
    int kind;
    int visible;  // to the camera itself
    ColorRecord zenith;
    ColorRecord horizon;
    ColorRecord nadir;
    int width;
    int height;
    float turn;  // about +y, in full turns
    int tilted;  // 1: what the turned image, or the computed sky, takes for x, y and z are these
    vec3 x_axis;
    vec3 y_axis;
    vec3 z_axis;
    float stretch;  // a height in the picture, from the top, is this times one in the sky
    float shift;    // and this
    float scale;
    int first_share;  // into distributions: `height` cumulative shares of rows; for each row, `width` of its texels
    int model;        // SKY_MODEL: into distributions, shares of the sun's light outside the air; `horizon` is that light times `scale`
    vec3 sun;         // the direction towards it, length 1, along these axes
    float sun_chord;  // the square of the distance between its middle and its border on the unit sphere; 0: no sun
    float sun_share;  // the chance that directions are drawn from it
    ColorRecord sun_light;  // its radiance
};

// How often a path is scattered at most, by what the surface does; `limited` 0: as often as it likes. Passing through a surface is transmission;
// what is sent back is diffuse or glossy as bsdf/bsdf.h has it.
struct PathLimits {
    int limited;
    int diffuse;
    int glossy;
    int transmission;
};

// Which ends of paths are followed.
const int HALF_OF_CAMERA = 0;
const int HALF_OF_LIGHT = 1;
const int HALVES_JOINED = 2;  // both, each vertex of one joined to each of the other
const int HALVES_MERGED = 3;  // and vertices of the camera's merged with photons

const int PHOTON_PATHS = 65536;  // of light, for each sample of all pixels, see bidirectional/merge.h

// Which of the two ways to a lamp's light are gone.
const int WAYS_BOTH = 0;
const int WAYS_EMITTER = 1;  // lamps are asked; what could have been asked and is met by itself does not count
const int WAYS_BSDF = 2;     // lamps are met

// One coordinate of a pixel's filter, to be drawn from: `filter_places` holds FILTER_STEPS + 1 places, in pixels from the pixel's middle, at even
// steps of to_even_ends(share of the filter's absolute value): the ends hardly count, and have a shape of their own.
const int FILTER_STEPS = 4096;
const int FILTER_VALUES = 1024;  // `filter_values` holds one more, from the middle to the radius; their integral over both sides is 1

struct FilterRecord {
    float negative_from;  // the filter is negative farther from the middle than this; FAR where it is not
    float weight;         // of a sample: the integral of the absolute value over that of the filter itself
    float radius;         // beyond it the filter is 0; pixels
};

RECORDS_END

#ifdef __cplusplus
namespace lancer::kernel {
static_assert(sizeof(ColorRecord) == 40 && sizeof(InputRecord) == 20 && sizeof(MaterialRecord) == 352 && sizeof(EmitterRecord) == 184 &&
              sizeof(SkyRecord) == 260 && sizeof(VolumeRecord) == 152 && sizeof(GridRecord) == 88);
}  // namespace lancer::kernel
#endif

#endif
