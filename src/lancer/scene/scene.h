// What the author of a scene wrote, as plain structs: names, units, source positions. Nothing here knows a file format or a ray.
//
// Units: metres for lengths, degrees for angles as written. Colours are linear RGB with sRGB (Rec. 709) primaries and a D65 white.
// The space is right-handed; +y is up by default.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/base/diagnostic.h"
#include "lancer/scene/color.h"

namespace lancer::scene {

// ---- Textures -------------------------------------------------------------------------------------------------------------------

// Two colours alternating in cells of `size`: metres in object space when `solid`, units of uv otherwise.
struct Checker {
    Rgb first{1.0};
    Rgb second{0.0};
    double size = 1.0;
    bool solid = true;
};

enum class Wrap { repeat, clamp, mirror };
enum class Filter { nearest, bilinear, mipmaps };

// A picture laid over the surface's uv coordinates; (0, 0) is its lower left corner. It is looked up at rotation * (scale * uv) + offset.
struct ImageTexture {
    std::string
        file;  // resolved against the scene file's folder; where there are `bytes`, what to call them: another name for each picture
    std::shared_ptr<const std::string> bytes = nullptr;  // of a file that lies within another one
    Wrap wrap = Wrap::repeat;
    std::optional<Wrap> wrap_v = std::nullopt;  // where it differs from `wrap`
    Filter filter = Filter::mipmaps;
    bool linear = false;  // false: colours are decoded from sRGB where they are integers
    glm::dvec2 scale{1.0};
    double rotation = 0.0;  // degrees, anticlockwise
    glm::dvec2 offset{0.0};
    int uv_set = 0;                  // 0 or 1, of a mesh that has two
    Rgb tint{1.0};                   // times this; alpha stays
    bool times_mesh_colors = false;  // and times the colours and alphas of the mesh's vertices
    SourcePosition position;
};

// Colours that a mesh brings along, for each of its vertices or triangles; white where it has none.
struct MeshColors {
    bool of_faces = false;
    Rgb tint{1.0};  // times this
};

using Texture = std::variant<Color, Checker, ImageTexture, MeshColors>;

enum class Channel { red, green, blue, alpha };

// A number, the same everywhere; or where there is a texture, offset + scale * one of its channels.
struct Value {
    Value(double everywhere = 0.0) : number(everywhere) {}

    double number;
    std::optional<Texture> texture = std::nullopt;
    Channel channel = Channel::red;
    double scale = 1.0;
    double offset = 0.0;

    // What it is at most, of textures from 0 to 1.
    double most() const { return texture ? offset + (scale > 0.0 ? scale : 0.0) : number; }
};

// ---- Refraction -----------------------------------------------------------------------------------------------------------------

// n = refractive index at the d line (587.56 nm), V = Abbe number.
struct AbbeGlass {
    double index = 1.5;
    double abbe_number = 60.0;
};

// n^2 = 1 + sum B_i L^2 / (L^2 - C_i), L in micrometres, C_i in square micrometres [Sellmeier 1871].
struct SellmeierGlass {
    glm::dvec3 b{0.0};
    glm::dvec3 c{0.0};
};

struct NamedGlass {
    std::string name;  // a name that spectrum/glass.h knows
};

// A plain number is the same index at every wavelength.
using Refraction = std::variant<double, AbbeGlass, SellmeierGlass, NamedGlass, MeasuredSpectrum>;

// ---- Materials ------------------------------------------------------------------------------------------------------------------

// The report's material, with transparency added [Whitted 1980]. All weights are shares in [0, 1].
struct WhittedMaterial {
    Texture color = Color(Rgb(0.8));
    double ambient = 0.1;
    double diffuse = 0.9;
    double highlight = 0.3;
    double shininess = 50.0;  // exponent of the highlight
    double reflectivity = 0.0;
    double transparency = 0.0;
    Refraction refraction = 1.5;
    Color absorption = Color();  // inside a transparent body, per metre
};

// The rest follow physics: they are for the path integrator. Roughness runs from 0, smooth, to 1; its square is the width of the facets' slopes.

// The small mirrors that rough surfaces are made of. As other programs have them they may lose light.
struct Facets {
    enum class Distribution { ggx, beckmann };
    Distribution distribution = Distribution::ggx;
    bool separate = false;  // they hide one another towards either direction by itself, else by how high each lies
    bool once = false;      // light that meets several of them is lost, else it is given back

    bool operator==(const Facets&) const = default;
};

// Scatters to all sides alike [Lambert 1760], or as small facets of that kind do.
struct DiffuseMaterial {
    Texture color = Color(Rgb(0.8));
    Value roughness = 0.0;
};

// Part of a complex index of refraction: measured, or one number for each of red, green and blue.
using Index = std::variant<MeasuredSpectrum, Rgb>;

// A metal, by name, by its complex index n + i k, or by its colour when seen straight on.
struct ConductorMaterial {
    std::string metal;                // a name that spectrum/metal.h knows; empty: n and k, or `color` alone
    Texture color = Color(Rgb(1.0));  // of a metal with an index, a tint: white in nature
    Value roughness = 0.0;
    Value anisotropy = 0.0;                 // how much smoother along u than along v, 0 to 1
    std::optional<Index> n = std::nullopt;  // both or none
    std::optional<Index> k = std::nullopt;
    Facets facets = {};
};

// A clear body, such as glass or water; or a pane of it, so thin that nothing is seen to be shifted.
struct DielectricMaterial {
    Refraction refraction = 1.5;
    Texture color = Color(Rgb(1.0));  // a tint for whatever it reflects or lets through; white in nature
    Value roughness = 0.0;
    Value anisotropy = 0.0;
    Color absorption = Color();  // inside, per metre
    bool thin = false;
    Facets facets = {};
};

// A coloured body under a clear coat.
struct PlasticMaterial {
    Texture color = Color(Rgb(0.8));
    double refraction = 1.5;  // of the coat
    Value roughness = 0.0;
    bool saturates = true;  // light that the coat sends back takes the body's colour again
    Facets facets = {};
};

// Layers: sheen over a clear coat over a base of metal, coloured body or clear body. After glTF's metallic-roughness and its extensions.
struct PrincipledMaterial {
    Texture color = Color(Rgb(0.8));
    Value metalness = 0.0;
    Value roughness = 0.3;
    Value anisotropy = 0.0;
    double refraction = 1.5;
    Texture specular = Color(Rgb(1.0));  // tint of what the base reflects
    Value transmission = 0.0;
    bool thin = false;
    Color absorption = Color();
    Value coat = 0.0;
    Value coat_roughness = 0.0;
    Texture sheen = Color();
    Value sheen_roughness = 0.3;
    Value film = 0.0;  // thickness in nanometres of a thin film; 0: none
    double film_refraction = 1.3;
    double dispersion = 0.0;  // of the clear body: 20 / Abbe number, as glTF has it
};

// Burley's surface, after what was published of it: scenes of other programs are made for it. It is bright where PrincipledMaterial is true.
struct BurleyMaterial {
    Texture color = Color(Rgb(0.5));
    Value roughness = 0.5;
    Value anisotropy = 0.0;      // how much rougher along u than along v, 0 to 1
    double refraction = 1.5;     // of what is no metal
    double specular_tint = 0.0;  // how much of the colour it takes that the surface reflects, 0 to 1
    Value metalness = 0.0;
    Value transmission = 0.0;
    double flatness = 0.0;  // of the diffuse body, 0 to 1
    Value sheen = 0.0;
    double sheen_tint = 0.0;
    Value coat = 0.0;
    double coat_gloss = 0.0;  // from 0, blurred, to 1
    bool thin = false;        // a sheet: no metal, no coat
    Value passes = 0.0;       // of a sheet: the share of the diffuse light that goes through, 0 to 1
};

// A border with nothing to be seen of it, between one medium and another of the same refractive index, such as that of a cloud.
struct NullMaterial {};

// Light that a surface gives by itself.
struct Emission {
    Texture radiance = Color();  // W/(m^2 sr), weighed by the eye: 1 is as bright as a white surface under an irradiance of pi
    double strength = 1.0;       // times this
    bool both_sides = false;     // else outwards only
};

// Two materials, one here and the other there: indices into Scene::materials. They may be mixes themselves; no mix may contain itself.
struct MixMaterial {
    int first = 0;
    int second = 0;
    Value share = 0.5;  // of the second
};

// Where a surface's normals differ from those of its shape.
struct Relief {
    std::optional<Texture> normals = std::nullopt;  // red, green, blue from 0 to 1 are x, y, z from -1 to 1: along u, along v, outwards
    double scale = 1.0;                             // of x and y
    bool flips_green = false;                       // y grows downwards
    std::optional<Value> heights = std::nullopt;    // metres outwards, of which only the slopes are seen
    bool shadows = false;                           // light that comes slantwise is dimmed as if the relief hid it from itself
};

struct Material {
    std::string name;  // empty when written in place
    std::variant<WhittedMaterial, DiffuseMaterial, ConductorMaterial, DielectricMaterial, PlasticMaterial, PrincipledMaterial,
                 BurleyMaterial, MixMaterial, NullMaterial>
        model;
    SourcePosition position;
    std::optional<Emission> emission = std::nullopt;
    bool is_default = false;  // for shapes without one: as it is, or diffuse where light follows physics
    Relief relief = {};
    Value opacity = 1.0;               // how much of it is there; light passes by the rest as if there were nothing
    double opacity_cutoff = 0.0;       // above 0: it is there where the opacity is at least this, and nowhere else
    std::optional<int> behind = {};    // what is seen from within instead: index into Scene::materials
    bool one_sided = false;            // black when seen from within
    bool open_behind = false;          // not there when seen from within
    std::optional<int> interior = {};  // what fills a clear body or what a null border closes in: index into Scene::media
    int priority = 0;                  // of bodies that overlap the one of the highest fills the overlap; of equals the one entered last
};

inline bool is_physical(const Material& material) {
    return !std::holds_alternative<WhittedMaterial>(material.model) || material.emission.has_value();
}

// ---- Media ----------------------------------------------------------------------------------------------------------------------

// Numbers in a box: in cells of equal size, x running fastest, then y, then z. One channel, or three: linear RGB.
struct VoxelData {
    glm::ivec3 size{1};
    int channels = 1;
    std::vector<float> values;  // size.x * size.y * size.z * channels
};

// A quantity in space: what the cells hold in their middles, and straight between them. Outside the box it is 0.
struct Grid {
    std::shared_ptr<const VoxelData> data;
    glm::dmat4 to_world{1.0};  // from the unit cube, which the cells fill
    bool fades = false;        // towards 0 beyond the middles of the outermost cells; else it stays as it is there
};

// By how much it absorbs and scatters, each in 1/m.
struct AbsorbingScattering {
    Color absorption;
    Color scattering;
};

// The same by their sum in 1/m, and the share of it that is scattering.
struct ExtinctionAlbedo {
    Color extinction;
    Color albedo;
};

// Into which directions a medium scatters.
enum class Phase { henyey_greenstein, rayleigh };

// What fills space, evenly or as a grid has it: fog, smoke, milk, fire.
struct Medium {
    std::string name;
    std::variant<AbsorbingScattering, ExtinctionAlbedo> coefficients;
    double scale = 1.0;  // times these
    Phase phase = Phase::henyey_greenstein;
    double asymmetry =
        0.0;         // Henyey and Greenstein's g, the mean cosine of the angle by which light is turned: -1 to 1, 0 for all sides alike
    Color emission;  // radiance that so much of it would have that nothing shines through: it emits as much as it absorbs of this
    double emission_strength = 1.0;        // times this
    std::optional<Grid> density = {};      // times the coefficients; in colours where it has three channels
    std::optional<Grid> albedo = {};       // three channels: of extinction, instead of the albedo (ExtinctionAlbedo only)
    std::optional<Grid> temperature = {};  // kelvin, one channel: of a black body, whose light times `emission` it then emits
    SourcePosition position;
};

// ---- Shapes, each in its own object space -----------------------------------------------------------------------------------------

struct Sphere {
    glm::dvec3 center{0.0};
    double radius = 1.0;
};

struct Box {
    glm::dvec3 min{-0.5};
    glm::dvec3 max{0.5};
};

struct Plane {  // infinite
    glm::dvec3 point{0.0};
    glm::dvec3 normal{0.0, 1.0, 0.0};
};

struct Disk {
    glm::dvec3 center{0.0};
    glm::dvec3 normal{0.0, 1.0, 0.0};
    double radius = 1.0;
};

struct Cylinder {
    glm::dvec3 from{0.0};
    glm::dvec3 to{0.0, 1.0, 0.0};
    double radius = 0.5;
    bool capped = true;
};

struct Cone {  // a cone, or a truncated one when `top_radius` is not 0
    glm::dvec3 from{0.0};
    glm::dvec3 to{0.0, 1.0, 0.0};
    double radius = 0.5;      // at `from`
    double top_radius = 0.0;  // at `to`
    bool capped = true;
};

// Triangles, counter-clockwise seen from outside. What belongs to vertices is empty or as long as `positions`.
struct TriangleMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uvs;
    std::vector<glm::uvec3> triangles;
    std::vector<glm::vec2> second_uvs = {};
    std::vector<glm::vec4> tangents = {};     // where u grows, of length 1; w is 1 or -1: v grows along w * cross(normal, tangent)
    std::vector<glm::vec4> colors = {};       // linear RGB and alpha
    std::vector<glm::vec4> face_colors = {};  // of each triangle, or empty
};

// The data of a mesh is shared by all its placements.
struct Mesh {
    std::shared_ptr<const TriangleMesh> data;
    bool smooth = true;  // use the vertex normals where there are any
};

using Shape = std::variant<Sphere, Box, Plane, Disk, Cylinder, Cone, Mesh>;

struct Object {
    std::string name;
    Shape shape;
    int material = 0;  // index into Scene::materials
    glm::dmat4 to_parent{1.0};
    SourcePosition position;
};

// ---- Groups ---------------------------------------------------------------------------------------------------------------------

struct Placement {
    int group = 0;  // index into Scene::groups; smaller than the index of the group that contains this placement
    glm::dmat4 to_parent{1.0};
    std::optional<int> material;  // replaces the materials of everything placed
    SourcePosition position;
};

struct Group {
    std::string name;
    std::vector<Object> objects;
    std::vector<Placement> placements;
};

// ---- Lights ---------------------------------------------------------------------------------------------------------------------

struct PointLight {
    glm::dvec3 position{0.0};
};

struct SpotLight {
    glm::dvec3 position{0.0};
    glm::dvec3 direction{0.0, -1.0, 0.0};
    double angle = 30.0;   // degrees from the axis to where the light ends
    double falloff = 5.0;  // degrees over which it fades, measured inwards from `angle`
};

struct DirectionalLight {
    glm::dvec3 direction{0.0, -1.0, 0.0};  // the way the light travels
};

struct Light {
    std::string name;
    std::variant<PointLight, SpotLight, DirectionalLight> model;
    Color color = Rgb(1.0);
    double intensity = 1.0;  // in Whitted scenes its share of the light; the shares sum to 1
    SourcePosition position;

    // For light that follows physics: W/sr of point and spot lights, W/m^2 at right angles of directional ones, weighed by the eye.
    std::optional<Color> power = std::nullopt;
};

// What rays see that leave the scene: a vertical gradient, all equal for a plain colour; or a latitude-longitude image around it.
struct Background {
    Color zenith;
    Color horizon;
    Color nadir;
    std::optional<ImageTexture> image = std::nullopt;  // its middle lies along -z, its right half towards +x, its top along +y
    double rotation = 0.0;                             // of the image about +y: degrees, counter-clockwise as seen from above
    glm::dmat3 axes{1.0};   // where x, y and z of the turned image lie, column by column: length 1, at right angles; of either hand
    double strength = 1.0;  // times this
    bool visible = true;    // to the camera itself
};

// ---- Camera -----------------------------------------------------------------------------------------------------------------------

enum class FovAxis { width, height };
enum class Projection { perspective, orthographic, panorama };

struct Camera {
    std::string name;  // empty for the unnamed one, which comes first
    glm::dvec3 position{0.0, 0.0, 5.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};  // need not have length 1
    glm::dvec3 up{0.0, 1.0, 0.0};
    double fov = 60.0;  // degrees, between the two edges of the picture along `fov_axis`
    FovAxis fov_axis = FovAxis::width;
    Projection projection = Projection::perspective;
    double extent = 2.0;          // orthographic: metres across the picture along `fov_axis`
    double aperture = 0.0;        // diameter of the lens in metres; 0: a pinhole, all is sharp
    double focus_distance = 5.0;  // of the plane that is sharp, along the view
    SourcePosition source;
};

// ---- How to render it -------------------------------------------------------------------------------------------------------------

enum class Antialiasing { uniform, adaptive };
enum class DirectSamples { mis, emitter, bsdf };  // how lamps are found: both ways together, by asking them, by scattered rays
enum class PixelFilter { box, tent, gaussian, mitchell, blackman_harris };

struct RenderSettings {
    int width = 1280;
    int height = 720;
    std::string integrator = "auto";  // path where anything in the scene follows physics, else whitted
    std::optional<int> bounces;       // after the first hit; not written: 5 for whitted, 16 for path, 1 for direct
    // How many of them may be of a kind; not written: all.
    std::optional<int> diffuse_bounces;
    std::optional<int> glossy_bounces;
    std::optional<int> transmission_bounces;
    DirectSamples direct_samples = DirectSamples::mis;  // of the direct integrator
    int spp = 64;                                       // samples a pixel of the path integrator
    bool rgb = false;                                   // paths carry linear RGB instead of wavelengths
    int seed = 0;
    PixelFilter filter = PixelFilter::blackman_harris;
    std::optional<double> filter_radius;  // pixels; not written: what suits the filter
    int ssaa = 1;                         // k x k samples a pixel
    Antialiasing antialiasing = Antialiasing::uniform;
    double adaptive_threshold = 0.03;  // difference of display values in [0, 1] that makes a cell be cut in four
    int adaptive_depth = 3;            // how often at most
    double min_weight = 0.0005;        // paths that can bring less than this share of their light to the pixel are not followed
    int wavelengths = 48;              // that carry a path through dispersive glass
    double exposure = 0.0;             // stops
    std::string view = "srgb";         // how linear light is shown; a name that image/view.h knows
    std::vector<std::string> aovs;     // what EXR files hold beside the picture; names that image/aov.h knows
    int spectral_bins = 0;             // and how many channels of spectral radiance
    bool wide = false;                 // 32-bit floats in EXR files, not halves
};

// A file that the scene was read from.
struct InputFile {
    std::string path;  // as named, from where the program was started
    std::string hash;  // hexadecimal, of its bytes
};

struct Scene {
    std::string file;               // as named by the user
    std::string hash;               // hexadecimal, over the scene file and everything it reads
    std::vector<InputFile> inputs;  // the scene file and everything it reads, in the order of reading
    std::vector<Camera> cameras;    // at least one
    std::vector<Material> materials;
    std::vector<Medium> media;
    std::optional<int> medium;  // what is everywhere outside of bodies: index into `media`
    std::vector<Group> groups;  // a group comes after every group it places
    std::vector<Object> objects;
    std::vector<Placement> placements;
    std::vector<Light> lights;
    Background background;
    Color ambient = Rgb(1.0);  // light that reaches every point, times each material's `ambient`
    RenderSettings settings;
};

// The integrator that "auto" stands for.
std::string chosen_integrator(const Scene& scene);
int bounces_of(const Scene& scene);
// Whether light follows physics, along paths: any integrator but whitted.
bool follows_paths(const Scene& scene);

}  // namespace lancer::scene
