// Every key of the notation. Defaults are those of the structs in scene/; a test holds them together.
#include <glm/vec3.hpp>

#include "lancer/image/aov.h"
#include "lancer/import/toml/notation.h"

namespace lancer::notation {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Range any{};
constexpr Range positive{0.0, infinity, true, false};
constexpr Range not_negative{0.0, infinity};
constexpr Range share{0.0, 1.0};
constexpr Range corner{0.0, 4294967295.0};

const Default none{};
const glm::dvec3 origin{0.0};
const glm::dvec3 upwards{0.0, 1.0, 0.0};

Key name_key(std::string_view help, bool required = false) { return {"name", Kind::text, none, any, "", help, required}; }

// Every shape has these as well.
Table shape(std::string_view name, std::string_view what, std::string_view help, std::vector<Key> keys) {
    Table table{name, what, help, {name_key("A name, for messages.")}};
    table.keys.insert(table.keys.end(), keys.begin(), keys.end());
    table.keys.push_back({"material", Kind::material, none, any, "", "The name of a [material.NAME], or a material written in place."});
    const Table& transform = place();
    for (std::string_view key : {"scale", "rotate", "translate", "matrix"}) {
        table.keys.push_back(*transform.find(key));
    }
    return table;
}

// What every kind of light has; `intensity`: whether it can have a share of a Whitted scene's light.
Table light(std::string_view type, std::string_view what, std::string_view help, std::vector<Key> keys, Key power, bool shared = true) {
    Table table{type,
                what,
                help,
                {{"type", Kind::choice, none, any, "", "What kind of light it is.", true, {type}}, name_key("A name, for messages.")}};
    table.keys.insert(table.keys.end(), keys.begin(), keys.end());
    if (shared) {
        table.keys.push_back({"color", Kind::color, glm::dvec3(1.0), not_negative, "", "The colour of its light."});
    }
    table.keys.push_back(std::move(power));
    if (shared) {
        table.keys.push_back(
            {"intensity", Kind::number, none, Range{0.0, 1e6}, "",
             "Its share of the light. The shares of all lights sum to 1; when they do not, they are scaled. Lights without one "
             "have equal parts of what the others leave."});
    }
    return table;
}

Key light_power(std::string_view unit) {
    return {"power", Kind::color,
            none,    not_negative,
            unit,    "For physical scenes: what it gives, weighed by the eye; and its colour. There it stands for color and intensity."};
}

Key thrown_encoding() {
    return {"encoding", Kind::choice, "srgb", any, "", "How 8 and 16 bits store colours in the image.", false, {"srgb", "linear"}};
}

Key thrown_tint() { return {"tint", Kind::rgb, glm::dvec3(1.0), not_negative, "", "Multiplies the colours of the image."}; }

Key thrown_wrap() {
    return {"wrap",  Kind::choice,
            "clamp", any,
            "",      "What its edges blend into: themselves, the edges across, or their mirror image.",
            false,   {"repeat", "clamp", "mirror"}};
}

Key thrown_power(std::string_view help) { return {"power", Kind::color, none, not_negative, "W/sr", help, true}; }

}  // namespace

const Table& camera() {
    static const Table table{
        "camera",
        "a camera",
        "Where the picture is seen from. Cameras with names, [camera.NAME], may stand beside it.",
        {{"position", Kind::vector3, glm::dvec3(0.0, 0.0, 5.0), any, "m", "The eye."},
         {"look_at", Kind::vector3, none, any, "m", "The point in the middle of the picture; instead of direction."},
         {"direction", Kind::direction, glm::dvec3(0.0, 0.0, -1.0), any, "", "Where it looks; instead of look_at."},
         {"up", Kind::direction, upwards, any, "", "What is up in the picture."},
         {"fov", Kind::number, 60.0, Range{0.0, 180.0, true, true}, "degrees",
          "The field of view, between two opposite edges of the picture."},
         {"fov_axis", Kind::choice, "width", any, "", "Whether fov spans the picture's width or its height.", false, {"width", "height"}},
         {"projection",
          Kind::choice,
          "perspective",
          any,
          "",
          "How the picture shows space; a panorama shows all directions.",
          false,
          {"perspective", "orthographic", "panorama"}},
         {"extent", Kind::number, 2.0, positive, "m", "Orthographic: what the picture spans along fov_axis."},
         {"shift", Kind::vector2, glm::dvec2(0.0), Range{-1000.0, 1000.0}, "",
          "Moves the picture to the right and up over what the camera sees, in parts of its width and height: a lens that is shifted."},
         {"pixel_aspect", Kind::number, 1.0, Range{0.001, 1000.0}, "", "The width of a pixel over its height."},
         {"aperture", Kind::number, 0.0, not_negative, "m", "The diameter of the lens; 0 keeps everything sharp. Path integrator only."},
         {"focus_distance", Kind::number, none, positive, "m", "To the plane that is sharp; look_at's when not written."}}};
    return table;
}

const Table& point_light() {
    static const Table table = light("point", "a point light", "Light from a point, equal in all directions.",
                                     {{"position", Kind::vector3, none, any, "m", "Where it stands.", true}}, light_power("W/sr"));
    return table;
}

const Table& spot_light() {
    static const Table table = light(
        "spot", "a spot light", "A cone of light from a point.",
        {{"position", Kind::vector3, none, any, "m", "Where it stands.", true},
         {"direction", Kind::direction, none, any, "", "Where it shines; instead of look_at."},
         {"look_at", Kind::vector3, none, any, "m", "The point that it shines at; instead of direction."},
         {"angle", Kind::number, 30.0, Range{0.0, 180.0, true, true}, "degrees", "From the cone's axis to where the light ends."},
         {"falloff", Kind::number, 5.0, Range{0.0, 180.0}, "degrees", "Over how much of angle it fades, measured inwards; at most angle."},
         {"fade",
          Kind::choice,
          "smooth",
          any,
          "",
          "How it fades: by a smooth step of the angle's cosine, evenly with the angle, or with the square of its cosine's step.",
          false,
          {"smooth", "even", "square"}},
         {"image", Kind::file, none, any, "",
          "A picture that dims it, thrown over the square around the cone; seen from the scene file's folder (path)."},
         thrown_encoding(),
         thrown_tint(),
         thrown_wrap(),
         {"up", Kind::direction, upwards, any, "", "What is up in the picture."}},
        light_power("W/sr"));
    return table;
}

const Table& directional_light() {
    static const Table table =
        light("directional", "a directional light", "Light from infinitely far away, such as the sun's.",
              {{"direction", Kind::direction, none, any, "", "The way the light travels.", true}}, light_power("W/m^2"));
    return table;
}

const Table& projector_light() {
    static const Table table = light(
        "projector", "a projector", "A picture thrown from a point (path).",
        {{"position", Kind::vector3, none, any, "m", "Where it stands.", true},
         {"direction", Kind::direction, none, any, "", "Where it shines; instead of look_at."},
         {"look_at", Kind::vector3, none, any, "m", "The point in the middle of the picture; instead of direction."},
         {"up", Kind::direction, upwards, any, "", "What is up in the picture."},
         {"fov", Kind::number, 30.0, Range{0.0, 180.0, true, true}, "degrees", "Between two opposite edges of the picture."},
         {"fov_axis",
          Kind::choice,
          "width",
          any,
          "",
          "Whether fov spans the picture's width, its height, or the smaller of the two.",
          false,
          {"width", "height", "smaller"}},
         {"image", Kind::file, none, any, "", "The picture, seen from the scene file's folder; a white square when not written."},
         thrown_encoding(),
         thrown_tint(),
         thrown_wrap(),
         {"even", Kind::flag, true, any, "",
          "Whether a screen at right angles is as bright at its edges as in the middle; else the light is as intense in each direction."}},
        thrown_power("What it gives along its axis where the picture is white, weighed by the eye; and its colour."), false);
    return table;
}

const Table& goniometric_light() {
    static const Table table =
        light("goniometric", "a goniometric light", "Light from a point, in each direction as intense as a picture says (path).",
              {{"position", Kind::vector3, none, any, "m", "Where it stands.", true},
               {"direction", Kind::direction, glm::dvec3(0.0, 0.0, -1.0), any, "", "Where the picture's middle points."},
               {"up", Kind::direction, upwards, any, "", "Where the picture's top points."},
               {"image", Kind::file, none, any, "",
                "A latitude-longitude picture, twice as wide as high, of the directions as they are seen from the light.", true},
               thrown_encoding(),
               thrown_tint()},
              thrown_power("What it gives where the picture is white, weighed by the eye; and its colour."), false);
    return table;
}

const Table& ies_light() {
    static const Table table =
        light("ies", "a lamp with a photometric file", "Light from a point, as intense in each direction as was measured (path).",
              {{"position", Kind::vector3, none, any, "m", "Where it stands.", true},
               {"file", Kind::file, none, any, "", "An .ies file (ANSI/IES LM-63), seen from the scene file's folder.", true},
               {"direction", Kind::direction, glm::dvec3(0.0, -1.0, 0.0), any, "", "The lamp's axis: where its vertical angle 0 points."},
               {"forward", Kind::direction, glm::dvec3(1.0, 0.0, 0.0), any, "",
                "Where its horizontal angle 0 points, as far as it can at right angles to the axis."}},
              thrown_power("What each candela of the file is worth, weighed by the eye; and the colour of the light."), false);
    return table;
}

const Table& spectrum() {
    static const Table table{
        "spectrum",
        "a spectrum",
        "A curve over wavelength, instead of a color: exactly one of illuminant, blackbody, daylight, spectrum, wavelengths with values, "
        "metal or rgb.",
        {{"illuminant", Kind::text, none, any, "",
          "A light by name: A, C, D50, D65, E, FL1 to FL12, ...; of luminance 1. With rgb: what lights it."},
         {"blackbody", Kind::number, none, Range{500.0, 100000.0}, "K", "The light of a black body of this temperature; of luminance 1."},
         {"daylight", Kind::number, none, Range{4000.0, 25000.0}, "K", "Daylight of this colour temperature; of luminance 1."},
         {"spectrum", Kind::file, none, any, "",
          "A file (.csv, .spd, .txt) with a wavelength in nm and a value on each line, seen from the scene file's folder."},
         {"wavelengths", Kind::numbers, none, Range{1.0, 1e6}, "nm", "Rising; with values."},
         {"values", Kind::numbers, none, not_negative, "", "One for each wavelength; straight lines between them."},
         {"metal", Kind::text, none, any, "", "What this metal mirrors when looked at straight on, by its name or symbol."},
         {"rgb", Kind::rgb, none, not_negative, "", "A color: its smooth spectrum; as a light, times illuminant, D65 when not written."},
         {"scale", Kind::number, 1.0, not_negative, "", "Multiplies it: of a light of luminance 1, its power or radiance."},
         {"luminance", Kind::number, none, not_negative, "",
          "Lights: scales it to be as bright as a white of this value, whatever it was."},
         {"as_rgb", Kind::rgb, none, not_negative, "",
          "Lights: what it is, times scale, in pictures that are rendered in red, green and blue; its colour when not written."}}};
    return table;
}

const Table& curve() {
    static const Table table{"curve",
                             "a curve",
                             "Measured values over wavelength.",
                             {*spectrum().find("spectrum"), *spectrum().find("wavelengths"), *spectrum().find("values")}};
    return table;
}

const Table& checker() {
    static const Table table{
        "checker",
        "a checker",
        "Two colours alternating in cells.",
        {{"type", Kind::choice, none, any, "", "checker", true, {"checker"}},
         {"first", Kind::rgb, glm::dvec3(1.0), share, "", "The colour of the cell at the origin."},
         {"second", Kind::rgb, origin, share, "", "The other colour."},
         {"size", Kind::number, 1.0, Range{1e-6, 1e9}, "", "The edge of a cell: metres when solid, else units of the surface's uv."},
         {"solid", Kind::flag, true, any, "", "Cells are cubes in the shape's own space; else squares on the surface."}}};
    return table;
}

const Table& image() {
    static const Table table{
        "image",
        "an image",
        "A picture laid over the surface's uv coordinates; (0, 0) is its lower left corner.",
        {{"type", Kind::choice, none, any, "", "image", true, {"image"}},
         {"file", Kind::file, none, any, "", "The picture, seen from the scene file's folder.", true},
         {"wrap", Kind::choice, "repeat", any, "", "What lies outside of the picture.", false, {"repeat", "clamp", "mirror"}},
         {"wrap_v", Kind::choice, none, any, "", "The same above and below, where it differs.", false, {"repeat", "clamp", "mirror"}},
         {"filter",
          Kind::choice,
          "mipmaps",
          any,
          "",
          "How colours between pixels are found; mipmaps: over all that a pixel sees.",
          false,
          {"mipmaps", "bilinear", "nearest"}},
         {"encoding",
          Kind::choice,
          "srgb",
          any,
          "",
          "How 8 and 16 bits store colours in the file; where a number is read from it: linear if not written.",
          false,
          {"srgb", "linear"}},
         {"uv_set", Kind::integer, 0.0, Range{0.0, 1.0}, "", "Which of a mesh's two sets of uv is meant."},
         {"scale", Kind::vector2, glm::dvec2(1.0), Range{-1e6, 1e6}, "", "How often the picture fits into one unit of u and v."},
         {"rotation", Kind::number, 0.0, Range{-36000.0, 36000.0}, "degrees", "Turns u and v, anticlockwise, after scale."},
         {"offset", Kind::vector2, glm::dvec2(0.0), Range{-1e6, 1e6}, "", "Added to u and v at last."},
         {"tint", Kind::rgb, glm::dvec3(1.0), not_negative, "", "Multiplies its colours, not its alpha."},
         {"vertex_colors", Kind::flag, false, any, "", "And so do the colours and alphas of the mesh's vertices."}}};
    return table;
}

const Table& vertex_color() {
    static const Table table{"vertex_color",
                             "a vertex color",
                             "The colours that a mesh brings along for its vertices; white where it has none.",
                             {{"type", Kind::choice, none, any, "", "vertex_color", true, {"vertex_color"}},
                              {"tint", Kind::rgb, glm::dvec3(1.0), not_negative, "", "Multiplies them."}}};
    return table;
}

const Table& face_color() {
    static const Table table{"face_color",
                             "a face color",
                             "The colours that a mesh brings along for its faces; white where it has none.",
                             {{"type", Kind::choice, none, any, "", "face_color", true, {"face_color"}},
                              {"tint", Kind::rgb, glm::dvec3(1.0), not_negative, "", "Multiplies them."}}};
    return table;
}

const Table& texture_value() {
    static const Table table{
        "texture_value",
        "a number from a texture",
        "A number that a texture gives: offset + scale * channel.",
        {{"texture", Kind::texture, glm::dvec3(1.0), share, "", "An image, a checker or the colours of a mesh.", true},
         {"channel", Kind::choice, "red", any, "", "Which part of its colour is meant.", false, {"red", "green", "blue", "alpha"}},
         {"scale", Kind::number, 1.0, Range{-1e6, 1e6}, "", "Multiplies it."},
         {"offset", Kind::number, 0.0, Range{-1e6, 1e6}, "", "Added to it."}}};
    return table;
}

const Table& abbe_glass() {
    static const Table table{"refraction",
                             "a glass",
                             "A glass by its refractive index and Abbe number.",
                             {{"index", Kind::number, 1.5, Range{1.0, 10.0}, "", "The refractive index at 587.56 nm.", true},
                              {"abbe_number", Kind::number, 60.0, Range{1.0, 1000.0}, "", "Smaller spreads the colours more.", true}}};
    return table;
}

const Table& sellmeier_glass() {
    static const Table table{"refraction",
                             "a glass",
                             "A glass by its Sellmeier coefficients: n^2 = 1 + sum B L^2 / (L^2 - C), L in micrometres.",
                             {{"b", Kind::vector3, origin, Range{-1e6, 1e6}, "", "B1, B2, B3.", true},
                              {"c", Kind::vector3, origin, Range{-1e6, 1e6}, "square micrometres", "C1, C2, C3.", true}}};
    return table;
}

const Table& axis_rotation() {
    static const Table table{"rotate",
                             "a rotation",
                             "A rotation about an axis through the origin.",
                             {{"axis", Kind::direction, upwards, any, "", "Counter-clockwise when the axis points at the viewer.", true},
                              {"angle", Kind::number, 0.0, Range{-1e6, 1e6}, "degrees", "How far.", true}}};
    return table;
}

const Table& place() {
    static const Table table{
        "place",
        "a placement",
        "Places a group, as often as wanted.",
        {{"group", Kind::text, none, any, "", "The name of the group.", true},
         {"material", Kind::material, none, any, "", "Replaces the materials of everything in the group."},
         {"scale", Kind::scale, glm::dvec3(1.0), Range{-1e9, 1e9}, "", "Applied first: one number or one for each axis."},
         {"rotate", Kind::rotation, origin, Range{-1e6, 1e6}, "degrees",
          "Applied second: about x, then y, then z; or { axis = [x, y, z], angle = degrees }."},
         {"translate", Kind::vector3, origin, any, "m", "Applied last."},
         {"matrix", Kind::matrix, none, Range{-1e15, 1e15}, "",
          "Instead of these three: the upper three rows of a 4 x 4 matrix, one after the other; the fourth of each is in metres."}}};
    return table;
}

const Table& include() {
    static const Table table{
        "include",
        "an include",
        "Another scene file, of any format that can be read, as a part of this one. What this file gives a name that the other one uses, "
        "too, "
        "is meant in both: materials, lights, cameras.",
        {{"file", Kind::file, none, any, "", "The scene: .toml, .gltf, .glb, .pbrt, .xml, .obj or .ply, seen from the scene file's folder.",
          true},
         name_key("With a name it is a group: not seen until a [[place]] names it, and its lights and cameras are left out."),
         {"material", Kind::material, none, any, "", "Replaces the materials of everything in it."},
         {"lights", Kind::flag, true, any, "", "Whether its lights and surroundings shine here; shapes that are lamps always do."},
         {"cameras", Kind::flag, true, any, "", "Whether its cameras are here as well, behind those of this file."},
         {"settings", Kind::flag, true, any, "", "Whether what it says about rendering holds where this file's [render] says nothing."},
         {"frame", Kind::number, 0.0, any, "s", "The moment of its animations (glTF)."},
         {"scene", Kind::text, none, any, "", "Which of its scenes, by name or number from 0 (glTF)."},
         {"variant", Kind::text, none, any, "", "Which of its sets of materials (glTF)."},
         {"define", Kind::texts, none, any, "", "Values for its $parameters (Mitsuba)."},
         *place().find("scale"),
         *place().find("rotate"),
         *place().find("translate"),
         *place().find("matrix")}};
    return table;
}

const Table& group() {
    static const Table table{"group",
                             "a group",
                             "Shapes that are placed together; not seen until a [[place]] names it.",
                             {name_key("The name to place it by.", true)}};
    return table;
}

const Table& sphere() {
    static const Table table = shape("sphere", "a sphere", "A sphere.",
                                     {{"center", Kind::vector3, origin, any, "m", "Its middle."},
                                      {"radius", Kind::number, 1.0, positive, "m", "From the middle to the surface."}});
    return table;
}

const Table& box() {
    static const Table table = shape("box", "a box", "A box along the axes.",
                                     {{"min", Kind::vector3, glm::dvec3(-0.5), any, "m", "The corner with the smallest x, y and z."},
                                      {"max", Kind::vector3, glm::dvec3(0.5), any, "m", "The corner with the largest x, y and z."}});
    return table;
}

const Table& plane() {
    static const Table table = shape("plane", "a plane", "An infinite plane.",
                                     {{"point", Kind::vector3, origin, any, "m", "Any point of it."},
                                      {"normal", Kind::direction, upwards, any, "", "At right angles to it."}});
    return table;
}

const Table& disk() {
    static const Table table = shape("disk", "a disk", "A flat, round disk.",
                                     {{"center", Kind::vector3, origin, any, "m", "Its middle."},
                                      {"normal", Kind::direction, upwards, any, "", "At right angles to it."},
                                      {"radius", Kind::number, 1.0, positive, "m", "From the middle to the rim."}});
    return table;
}

const Table& cylinder() {
    static const Table table = shape("cylinder", "a cylinder", "A round cylinder.",
                                     {{"from", Kind::vector3, origin, any, "m", "The middle of one end."},
                                      {"to", Kind::vector3, upwards, any, "m", "The middle of the other end."},
                                      {"radius", Kind::number, 0.5, positive, "m", "From the axis to the surface."},
                                      {"capped", Kind::flag, true, any, "", "Whether disks close its ends."}});
    return table;
}

const Table& cone() {
    static const Table table = shape("cone", "a cone", "A round cone, or a truncated one when top_radius is not 0.",
                                     {{"from", Kind::vector3, origin, any, "m", "The middle of the base."},
                                      {"to", Kind::vector3, upwards, any, "m", "The tip, or the middle of the top."},
                                      {"radius", Kind::number, 0.5, not_negative, "m", "At from."},
                                      {"top_radius", Kind::number, 0.0, not_negative, "m", "At to."},
                                      {"capped", Kind::flag, true, any, "", "Whether disks close its ends."}});
    return table;
}

const Table& mesh() {
    static const Table table =
        shape("mesh", "a mesh", "Triangles, from a file or written here; counter-clockwise seen from outside.",
              {{"file", Kind::file, none, any, "",
                "An .obj, .ply or .meshes file, seen from the scene file's folder; instead of positions and triangles."},
               {"part", Kind::integer, 0.0, Range{0.0, 1e9}, "", "Which mesh of a .meshes file, counted from 0."},
               {"positions", Kind::vectors3, none, any, "m", "The corners, [x, y, z] each."},
               {"triangles", Kind::triangles, none, corner, "", "Three numbers of corners each, counted from 0."},
               {"normals", Kind::vectors3, none, Range{-1e6, 1e6}, "", "One for each corner."},
               {"uvs", Kind::vectors2, none, Range{-1e6, 1e6}, "", "Texture coordinates [u, v], one for each corner."},
               {"colors", Kind::vectors3, none, share, "", "Linear [r, g, b], one for each corner, for vertex_color textures."},
               {"face_colors", Kind::vectors3, none, share, "", "Linear [r, g, b], one for each triangle, for face_color textures."},
               {"smooth", Kind::flag, true, any, "", "Use the normals of the corners, where there are any."}});
    return table;
}

const Table& background() {
    static const Table table{
        "background",
        "a background",
        "What is seen where there is nothing: one color, a gradient from below to above, or an image all around.",
        {{"color", Kind::color, origin, not_negative, "", "The same in every direction; instead of the others."},
         {"zenith", Kind::color, none, not_negative, "", "Straight up; horizon's when not written."},
         {"horizon", Kind::color, none, not_negative, "", "At eye level; the mean of the others when not written."},
         {"nadir", Kind::color, none, not_negative, "", "Straight down; horizon's when not written."},
         {"image", Kind::file, none, any, "",
          "A latitude-longitude picture, twice as wide as high, best an .exr or .hdr; instead of colors. Its middle lies along "
          "-z, its right half towards +x."},
         {"encoding", Kind::choice, "srgb", any, "", "How 8 and 16 bits store colours in the image.", false, {"srgb", "linear"}},
         {"rotation", Kind::number, 0.0, Range{-36000.0, 36000.0}, "degrees",
          "Turns the image about the y axis, counter-clockwise as seen from above."},
         {"tint", Kind::rgb, glm::dvec3(1.0), not_negative, "", "Multiplies the colours of the image."},
         {"stretch", Kind::number, 1.0, Range{-1e6, 1e6}, "",
          "How much of the image's height reaches from nadir to zenith: less than 1 where the middles of its first and last rows lie "
          "there."},
         {"lift", Kind::number, 0.0, Range{-1e6, 1e6}, "", "Where in the image, from below in parts of its height, the nadir lies."},
         {"axes", Kind::vectors3, none, Range{-1.0, 1.0}, "",
          "Where x, y and z of the turned image lie: three directions of length 1, at right angles."},
         {"strength", Kind::number, 1.0, not_negative, "", "Times this."},
         {"visible", Kind::flag, true, any, "", "Whether the camera sees it, and not only what it lights (path)."}}};
    return table;
}

const Table& clear_sky() {
    static const Table table{
        "sky",
        "the sky",
        "A clear sky with the sun, computed from what the air is made of (path; in colors for whitted). Instead of a background. Its unit "
        "is "
        "W/(m^2 sr nm).",
        {{"latitude", Kind::number, none, Range{-90.0, 90.0}, "degrees", "The place, to the north; with longitude and time."},
         {"longitude", Kind::number, none, Range{-180.0, 180.0}, "degrees", "The place, to the east."},
         {"time", Kind::text, none, any, "",
          "Date and time, such as \"2026-06-21T14:00:00+02:00\", with the difference from Universal Time; 1950 to 2050."},
         {"elevation", Kind::number, none, Range{-18.0, 90.0}, "degrees",
          "Of the sun above the horizon; with azimuth, instead of place and time."},
         {"azimuth", Kind::number, none, Range{-360.0, 360.0}, "degrees", "Of the sun, from north over east."},
         {"toward_sun", Kind::direction, none, any, "",
          "The direction towards the sun; instead of place and time, or elevation and azimuth."},
         {"sun_distance", Kind::number, 1.0, Range{0.5, 2.0}, "au", "How far the sun is, in astronomical units; place and time know it."},
         {"heading", Kind::number, 0.0, Range{-360.0, 360.0}, "degrees", "Where -z looks, from north over east."},
         {"up", Kind::direction, upwards, any, "", "Where the zenith is; the compass is turned with it by the shortest way."},
         {"turbidity", Kind::number, 3.0, Range{1.0, 10.0}, "", "How hazy the air is: 1 pure, 2 to 3 clear, 10 thick haze."},
         {"ozone", Kind::number, 0.3, Range{0.0, 1.0}, "atm-cm", "The ozone overhead."},
         {"ground", Kind::number, 0.2, share, "",
          "The share of light that the ground scatters back into the air; what is seen below the horizon."},
         {"sun", Kind::flag, true, any, "", "Whether the sun itself is there, and not only its light in the air."},
         {"strength", Kind::number, 1.0, not_negative, "", "Times this."},
         {"visible", Kind::flag, true, any, "", "Whether the camera sees it, and not only what it lights (path)."}}};
    return table;
}

const Table& ambient() {
    static const Table table{"ambient",
                             "the ambient light",
                             "Light that reaches every point from everywhere, times each material's ambient.",
                             {{"color", Kind::color, glm::dvec3(1.0), not_negative, "", "Its colour.", true}}};
    return table;
}

namespace {

std::vector<std::string_view> aov_words() {
    std::vector<std::string_view> words;
    for (const AovKind& kind : aov_kinds()) {
        words.push_back(kind.name);
    }
    return words;
}

}  // namespace

const Table& render() {
    static const Table table{
        "render",
        "the rendering",
        "How the picture is made; the command line has the last word.",
        {{"size", Kind::size, glm::dvec2(1280.0, 720.0), Range{1.0, 65536.0}, "pixels", "Width and height of the picture."},
         {"integrator",
          Kind::choice,
          "auto",
          any,
          "",
          "How light is followed. auto: path where a material or a light follows physics, else whitted. direct: path with one bounce. "
          "light: from "
          "the lamps. bdpt: from both ends. vcm: and photons, for what is seen through glass and lit through glass.",
          false,
          {"auto", "whitted", "path", "direct", "light", "bdpt", "vcm"}},
         {"bounces", Kind::integer, none, Range{0.0, 1024.0}, "",
          "How often light goes on after the first hit; 5 for whitted (at most 24), 16 for path, 1 for direct (at most) when not written."},
         {"diffuse_bounces", Kind::integer, none, Range{0.0, 1024.0}, "",
          "How many of them off matt surfaces: diffuse, plastic, and principled ones that are more body than metal or glass (path); all "
          "when not "
          "written."},
         {"glossy_bounces", Kind::integer, none, Range{0.0, 1024.0}, "",
          "How many of them off other surfaces (path); all when not written."},
         {"transmission_bounces", Kind::integer, none, Range{0.0, 1024.0}, "",
          "How many of them through surfaces (path); all when not written."},
         {"direct_samples",
          Kind::choice,
          "mis",
          any,
          "",
          "How the direct integrator finds lamps: mis, both ways together; emitter, by asking them; bsdf, by scattered rays.",
          false,
          {"mis", "emitter", "bsdf"}},
         {"spp", Kind::integer, 64.0, Range{1.0, 1048576.0}, "", "Samples a pixel of the path integrator."},
         {"rgb", Kind::flag, false, any, "", "Paths carry linear RGB instead of wavelengths."},
         {"seed", Kind::integer, 0.0, Range{0.0, 2147483647.0}, "", "Another number, another noise."},
         {"filter",
          Kind::choice,
          "blackman_harris",
          any,
          "",
          "How a pixel weighs the light around its middle (path).",
          false,
          {"box", "tent", "gaussian", "mitchell", "blackman_harris"}},
         {"filter_radius", Kind::number, none, Range{0.1, 16.0}, "pixels", "How far the filter reaches; what suits it when not written."},
         {"ssaa", Kind::integer, 1.0, Range{1.0, 64.0}, "", "Supersampling: ssaa x ssaa samples a pixel."},
         {"aa",
          Kind::choice,
          "uniform",
          any,
          "",
          "The same samples for every pixel, or more where neighbours differ.",
          false,
          {"uniform", "adaptive"}},
         {"adaptive_threshold", Kind::number, 0.03, Range{0.0, 1.0}, "",
          "The difference of display values that makes a cell be cut in four."},
         {"adaptive_depth", Kind::integer, 3.0, Range{0.0, 8.0}, "", "How often a cell is cut at most."},
         {"min_weight", Kind::number, 0.0005, Range{0.0, 1.0}, "",
          "Reflected and refracted rays that can bring less than this share of their light to the pixel are not followed."},
         {"wavelengths", Kind::integer, 48.0, Range{1.0, 1024.0}, "", "How many carry a path through glass that spreads colours."},
         {"exposure", Kind::number, 0.0, Range{-100.0, 100.0}, "stops", "Brightens the picture by 2^exposure."},
         {"view",
          Kind::choice,
          "srgb",
          any,
          "",
          "How PNG, JPEG and the window show what is too bright for a display.",
          false,
          {"srgb", "pbr-neutral", "agx", "aces"}},
         {"aovs", Kind::choices, none, any, "", "What EXR files hold beside the picture (path).", false, aov_words()},
         {"spectral_bins", Kind::integer, 0.0, Range{0.0, 471.0}, "", "Channels of spectral radiance in EXR files (path)."},
         {"float", Kind::flag, false, any, "", "EXR files hold 32-bit floats instead of halves."}}};
    return table;
}

}  // namespace lancer::notation
