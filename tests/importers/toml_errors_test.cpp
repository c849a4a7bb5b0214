// What the TOML reader says about mistakes: file, line, column and words.
#include "reading.h"

namespace lancer {
namespace {

using namespace lancer::testing;

struct Mistake {
    const char* name;
    std::string text;
    std::vector<std::string> messages;  // after "scene.toml:"
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

const std::string rest = "[camera]\n[[sphere]]\n[[light]]\ntype='point'\nposition=[0,9,0]\n";

std::string repeat(std::string text, int times, const std::string& part) {
    for (int i = 0; i < times; ++i) {
        text += part;
    }
    return text;
}

class TomlMistake : public ::testing::TestWithParam<Mistake> {};

TEST_P(TomlMistake, IsExplained) {
    const Reading reading = read_text(GetParam().text);
    std::vector<std::string> expected;
    for (const std::string& message : GetParam().messages) {
        expected.push_back("scene.toml" + message);
    }
    EXPECT_EQ(reading.messages, expected);
    const bool has_errors = reading.all().find(": error: ") != std::string::npos;
    EXPECT_EQ(reading.scene.has_value(), !has_errors);
}

const Mistake syntax[] = {
    {"Syntax", "[camera]\nfov = \n", {":2:7: error: expected value, saw '\\n'"}},
    {"SeveralLines",
     "[camera]\nfov = sixty\nposition = [0, 0, 0]\nup = up\n",
     {":2:7: error: this is no value: expected a number, true, false, a list, or text in quotes",
      ":4:6: error: this is no value: expected a number, true, false, a list, or text in quotes"}},
    {"ColorWithoutQuotes", "ambient = #fff\n", {":1:11: error: a value is missing here; a color stands in quotes: \"#rrggbb\""}},
    {"OpenList",
     "[camera]\nposition = [0, 1,\n[[sphere]]\n",
     {":3:3: error: this is no value: expected a number, true, false, a list, or text in quotes"}},
    {"Twice", "[camera]\nfov = 1\nfov = 2\n", {":3:7: error: cannot redefine existing integer 'fov'"}},
    {"Utf8", "# \xff\n", {":1:2: error: Encountered invalid utf-8 sequence"}},
    {"DeepValue", repeat("a = ", 100'000, "["), {":1:37: error: values are nested too deep: at most 32 lists or tables inside each other"}},
    {"DeepTable",
     repeat("é = ", 100'000, "{a="),
     {":1:101: error: values are nested too deep: at most 32 lists or tables inside each other"}},
    {"DeepHeader", repeat("# [[\n[[group", 100'000, ".group"), {":2:194: error: this name has too many parts: at most 32 between dots"}},
};

const Mistake whole_files[] = {
    {"Empty", "", {": error: there is nothing to see: the scene needs a shape, such as [[sphere]], or a [[place]] of a group with shapes"}},
    {"NoShape",
     "[camera]\n[[group]]\nname='g'\n[[group.sphere]]\n[[light]]\ntype='point'\nposition=[0,9,0]\n",
     {":2:1: warning: group \"g\" is never placed",
      ": error: there is nothing to see: the scene needs a shape, such as [[sphere]], or a [[place]] of a group with shapes"}},
    {"NoLight",
     "[camera]\n[[sphere]]\n",
     {": error: the scene is dark: it needs a [[light]], a material or medium with `emission`, a [background] or `ambient` light"}},
    {"UnknownTable", "[[spere]]\n" + rest, {":1:3: error: a scene has no \"spere\"; did you mean \"sphere\"?"}},
    {"UnknownOther",
     "[weather]\n" + rest,
     {":1:2: error: a scene has no \"weather\"; there may be camera, light, material, medium, group, place, include, background, sky, "
      "ambient, render, "
      "sphere, box, "
      "plane, disk, cylinder, cone, mesh"}},
    {"KeyOutsideOfItsTable", "size = [3, 4]\n" + rest, {":1:1: error: a scene has no \"size\"; it belongs below [render]"}},
    {"OneInsteadOfMany", "[sphere]\n[camera]\n", {":1:1: error: there may be several, so write [[sphere]] instead of [sphere]"}},
    {"NoTable", "sphere = [3]\n[camera]\n", {":1:11: error: \"sphere\" must hold tables, not a number"}},
    {"UnusedMaterial", "[material.m]\n" + rest, {":1:1: warning: material \"m\" is not used"}},
    {"DarkLights", rest + "intensity = 0\n", {":3:1: warning: the intensities of all lights are 0"}},
    {"ManyMistakes",
     "[camera]\nfov = 0\nfovv = 1\n[[sphere]]\nradius = 'big'\n[[box]]\nmin = [0, 0]\n",
     {":2:7: error: \"fov\" must be more than 0 and less than 180 degrees, not 0",
      ":3:1: error: a camera has no \"fovv\"; did you mean \"fov\"?", ":5:10: error: \"radius\" must be a number (m), not a string",
      ":7:7: error: \"min\" must be three numbers [x, y, z]: 3 numbers, not 2"}},
};

const Mistake shapes[] = {
    {"UnknownKey", "[[sphere]]\nradus = 1\n", {":2:1: error: a sphere has no \"radus\"; did you mean \"radius\"?"}},
    {"KeyOfTheFile",
     "[camera]\n[[sphere]]\nambient = 'red'\n",
     {":3:1: error: a sphere has no \"ambient\"; it belongs to the whole file: write it above the first [table]"}},
    {"NegativeRadius", "[[sphere]]\nradius = -1\n", {":2:10: error: \"radius\" must be more than 0 m, not -1"}},
    {"ZeroRadius", "[[disk]]\nradius = 0\n", {":2:10: error: \"radius\" must be more than 0 m, not 0"}},
    {"TinyRadius", "[[sphere]]\nradius = 1e-30\n", {":2:10: error: \"radius\" is too small: lengths must be at least 1e-09 m, not 1e-30"}},
    {"HugeRadius", "[[sphere]]\nradius = 1e30\n", {":2:10: error: \"radius\" is too large: lengths may be up to 1e+15 m, not 1e+30"}},
    {"NotANumber", "[[sphere]]\ncenter = [0, nan, 0]\n", {":2:14: error: \"center\" must be finite, not nan"}},
    {"Infinite", "[[sphere]]\ncenter = [0, 0, -inf]\n", {":2:17: error: \"center\" must be finite, not -inf"}},
    {"WrongType", "[[sphere]]\ncenter = 3\n", {":2:10: error: \"center\" must be three numbers [x, y, z], not a number"}},
    {"WrongElement",
     "[[sphere]]\ncenter = [0, 'a', true]\n",
     {":2:14: error: \"center\" must be a number (m), not a string", ":2:19: error: \"center\" must be a number (m), not true or false"}},
    {"NameNoText", "[[sphere]]\nname = 3\n", {":2:8: error: \"name\" must be text in quotes, not a number"}},
    {"MinAboveMax",
     "[[box]]\nmin = [0, 3, 0]\nmax = [1, 2, 1]\n",
     {":2:7: error: \"min\" must be less than \"max\": along y they are 3 and 2"}},
    {"FlatBox",
     "[[box]]\nmin = [0, 0, 1]\nmax = [1, 1, 1]\n",
     {":2:7: error: \"min\" must be less than \"max\": along z they are 1 and 1"}},
    {"ThinBoxFarAway",
     "[[box]]\nmin = [1e9, 0, 0]\nmax = [1000000000.5, 1, 1]\n",
     {":2:7: error: this box is too thin for where it stands: along x from 1000000000 to 1000000000.5"}},
    {"NoNormal", "[[plane]]\nnormal = [0, 0, 0]\n", {":2:10: error: \"normal\" must have a length: [0, 0, 0] points nowhere"}},
    {"NoAxis", "[[cylinder]]\nfrom = [1, 1, 1]\nto = [1, 1, 1]\n", {":3:6: error: \"from\" and \"to\" must be different points"}},
    {"NoCone", "[[cone]]\nradius = 0\n", {":2:10: error: \"radius\" and \"top_radius\" must not both be 0"}},
    {"NotAFlag", "[[cone]]\ncapped = 1\n", {":2:10: error: \"capped\" must be true or false, not a number"}},
    {"ZeroScale", "[[sphere]]\nscale = 0\n", {":2:9: error: \"scale\" must not be 0: nothing would be left"}},
    {"ZeroScaleOfOneAxis", "[[sphere]]\nscale = [1, 0, 1]\n", {":2:9: error: \"scale\" must not be 0: nothing would be left"}},
    {"ScaleNoNumber", "[[sphere]]\nscale = 'x'\n", {":2:9: error: \"scale\" must be a number or three numbers [x, y, z], not a string"}},
    {"Rotation",
     "[[sphere]]\nrotate = 90\n",
     {":2:10: error: \"rotate\" must be three angles [x, y, z] or { axis = [x, y, z], angle = degrees }, not a number"}},
    {"RotationWithoutAngle", "[[sphere]]\nrotate = { axis = [0, 1, 0] }\n", {":2:10: error: a rotation needs \"angle\""}},
    {"RotationAboutNothing",
     "[[sphere]]\nrotate = { axis = [0, 0, 0], angle = 1 }\n",
     {":2:19: error: \"axis\" must have a length: [0, 0, 0] points nowhere"}},
    {"TooFar", "[[sphere]]\nradius = 1e14\nscale = 1e9\n" + rest, {":1:1: error: this reaches further than 1e+15 m from the origin"}},
};

const Mistake meshes[] = {
    {"Nothing", "[[mesh]]\n", {":1:1: error: a mesh needs \"file\", or \"positions\" and \"triangles\""}},
    {"Both",
     "[[mesh]]\nfile = 'no.obj'\npositions = []\n",
     {":2:8: error: cannot read \"no.obj\": there is no such file", ":3:13: error: a mesh has either \"file\" or \"positions\""}},
    {"NoFile", "[[mesh]]\nfile = 'no.ply'\n", {":2:8: error: cannot read \"no.ply\": there is no such file"}},
    {"OtherFile", "[[mesh]]\nfile = 'a.stl'\n", {":2:8: error: \"a.stl\": meshes are read from .obj, .ply and .meshes files"}},
    {"NoCorner",
     "[[mesh]]\npositions = [[0,0,0],[1,0,0],[0,1,0]]\ntriangles = [[0,1,3]]\n",
     {":3:19: error: there is no corner 3: \"positions\" has 3, counted from 0"}},
    {"NegativeCorner",
     "[[mesh]]\npositions = [[0,0,0],[1,0,0],[0,1,0]]\ntriangles = [[0,1,-1]]\n",
     {":3:19: error: \"triangles\" must be from 0 to 4294967295, not -1"}},
    {"FractionalCorner",
     "[[mesh]]\npositions = [[0,0,0],[1,0,0],[0,1,0]]\ntriangles = [[0,1,0.5]]\n",
     {":3:19: error: \"triangles\" must be three corners [a, b, c] in whole numbers, not a fraction"}},
    {"NormalsOfOtherLength",
     "[[mesh]]\npositions = [[0,0,0],[1,0,0],[0,1,0]]\ntriangles = [[0,1,2]]\nnormals = [[0,0,1]]\n",
     {":4:11: error: \"normals\" must have one entry for each of the 3 positions, not 1"}},
    {"WithoutTriangles", "[[mesh]]\npositions = [[0,0,0],[1,0,0],[0,1,0]]\ntriangles = []\n", {":1:1: error: this mesh has no triangles"}},
    {"WithoutArea",
     "[[mesh]]\npositions = [[0,0,0],[1,0,0],[2,0,0]]\ntriangles = [[0,1,2]]\n",
     {":1:1: warning: 1 of 1 triangles have no area and are left out", ":1:1: error: this mesh has no triangle with an area"}},
};

const Mistake materials[] = {
    {"Unknown",
     "[material.mirror]\n[[sphere]]\nmaterial = 'miror'\n",
     {":3:12: error: there is no material \"miror\"; did you mean \"mirror\"?"}},
    {"UnknownAmongOthers",
     "[material.gold]\n[material.tin]\n[[sphere]]\nmaterial = 'velvet'\n",
     {":4:12: error: there is no material \"velvet\"; there are gold, tin"}},
    {"UnknownAtAll", "[[sphere]]\nmaterial = 'velvet'\n", {":2:12: error: there is no material \"velvet\"; add [material.velvet]"}},
    {"WrongType", "[[sphere]]\nmaterial = 3\n", {":2:12: error: \"material\" must be the name of a material or a table, not a number"}},
    {"WithoutName", "[material]\ncolor = 'red'\n", {":2:1: error: a material needs a name: [material.NAME]; \"color\" stands in none"}},
    {"List", "[[material]]\n", {":1:1: error: materials are written as [material.NAME], not as [[material]]"}},
    {"Model",
     "[material.m]\ntype = 'phong'\n",
     {":2:8: error: there is no material of type \"phong\"; known are whitted, diffuse, conductor, dielectric, plastic, principled, "
      "burley, mix, null"}},
    {"Key", "[material.m]\nrefectivity = 1\n", {":2:1: error: a material has no \"refectivity\"; did you mean \"reflectivity\"?"}},
    {"NegativeShare", "[material.m]\ndiffuse = -0.1\n", {":2:11: error: \"diffuse\" must be from 0 to 1, not -0.1"}},
    {"LargeShare", "[material.m]\nreflectivity = 1.5\n", {":2:16: error: \"reflectivity\" must be from 0 to 1, not 1.5"}},
    {"SharesTogether",
     "[material.m]\nreflectivity = 0.75\ntransparency = 0.5\n",
     {":3:16: error: \"reflectivity\" and \"transparency\" share the light that arrives: together at most 1, not 1.25"}},
    {"ColorName",
     "[material.m]\ncolor = 'rad'\n",
     {":2:9: error: \"color\" must be a color: \"#rrggbb\", a name such as \"red\", or [r, g, b], not \"rad\"; did you mean \"red\"?"}},
    {"ColorDigits",
     "[material.m]\ncolor = '#12345'\n",
     {":2:9: error: \"color\" must be a color: \"#rrggbb\", a name such as \"red\", or [r, g, b], not \"#12345\": a # needs three or six "
      "hexadecimal digits"}},
    {"ColorType",
     "[material.m]\ncolor = true\n",
     {":2:9: error: \"color\" must be a color: \"#rrggbb\", a name such as \"red\", or [r, g, b], not true or false"}},
    {"ColorTooBright", "[material.m]\ncolor = [0, 2, 0]\n", {":2:13: error: \"color\" must be from 0 to 1, not 2"}},
    {"Texture",
     "[material.m]\ncolor = { type = 'marble' }\n",
     {":2:18: error: a texture needs \"type\": \"checker\", \"image\", \"vertex_color\" or \"face_color\", not \"marble\""}},
    {"TextureWithoutType",
     "[material.m]\ncolor = { first = 'red' }\n",
     {":2:9: error: a texture needs \"type\": \"checker\", \"image\", \"vertex_color\" or \"face_color\""}},
    {"CheckerSize",
     "[material.m]\ncolor = { type = 'checker', size = 0 }\n",
     {":2:36: error: \"size\" must be from 1e-06 to 1000000000, not 0"}},
    {"Value",
     "[material.m]\ntype = 'plastic'\nroughness = 'high'\n",
     {":3:13: error: \"roughness\" must be a number or { texture, channel, scale, offset }, not a string"}},
    {"ValueWithoutTexture",
     "[material.m]\ntype = 'plastic'\nroughness = { channel = 'green' }\n",
     {":3:13: error: a number from a texture needs \"texture\""}},
    {"ValueChannel",
     "[material.m]\ntype = 'plastic'\nroughness = { texture = { type = 'checker' }, channel = 'grey' }\n",
     {":3:57: error: \"channel\" must be \"red\", \"green\", \"blue\" or \"alpha\", not \"grey\""}},
    {"ValueTooLarge", "[material.m]\ntype = 'plastic'\nroughness = 2\n", {":3:13: error: \"roughness\" must be from 0 to 1, not 2"}},
    {"CutoffAlone",
     "[material.m]\ntype = 'diffuse'\nopacity_cutoff = 0.5\n",
     {":3:18: error: \"opacity_cutoff\" needs \"opacity\" beside it"}},
    {"BehindAndOneSided",
     "[material.m]\ntype = 'diffuse'\nbehind = { type = 'diffuse' }\none_sided = true\n",
     {":4:13: error: a material has either \"behind\" or one_sided = true"}},
    {"NormalScaleAlone",
     "[material.m]\ntype = 'diffuse'\nnormal_scale = 2\n",
     {":3:16: error: \"normal_scale\" needs \"normal_map\" beside it"}},
    {"NormalColor",
     "[material.m]\ntype = 'diffuse'\nnormal_map = 'red'\n",
     {":3:14: error: \"normal_map\" must be a texture: a color bends all normals alike"}},
    {"MixWithoutSecond", "[material.m]\ntype = 'mix'\nfirst = { type = 'diffuse' }\n", {":1:1: error: a material needs \"second\""}},
    {"MixOfNothing", "[material.m]\ntype = 'mix'\nfirst = 'm'\nsecond = 'n'\n", {":4:10: error: there is no material \"n\"; there are m"}},
    {"ImageMissing",
     "[material.m]\ncolor = { type = 'image', file = 'no.png' }\n",
     {":2:34: error: cannot read \"no.png\": there is no such file"}},
    {"ImageWithoutFile", "[material.m]\ncolor = { type = 'image' }\n", {":2:9: error: an image needs \"file\""}},
    {"ImageWrap",
     "[material.m]\ncolor = { type = 'image', file = 'no.png', wrap = 'tile' }\n",
     {":2:34: error: cannot read \"no.png\": there is no such file",
      ":2:51: error: \"wrap\" must be \"repeat\", \"clamp\" or \"mirror\", not \"tile\""}},
    {"Glass", "[material.m]\nrefraction = 'N-BK6'\n", {":2:14: error: there is no glass \"N-BK6\"; did you mean \"N-BK7\"?"}},
    {"Index", "[material.m]\nrefraction = 0\n", {":2:14: error: \"refraction\" must be from 0.1 to 10, not 0"}},
    {"GlassType",
     "[material.m]\nrefraction = true\n",
     {":2:14: error: \"refraction\" must be a refractive index, the name of a glass, { index, abbe_number }, { b, c } or a curve, not true "
      "or "
      "false"}},
    {"AbbeNumber",
     "[material.m]\nrefraction = { index = 1.5, abbe_number = 0 }\n",
     {":2:43: error: \"abbe_number\" must be from 1 to 1000, not 0"}},
    {"HalfAGlass", "[material.m]\nrefraction = { b = [1, 0, 0] }\n", {":2:14: error: a glass needs \"c\""}},
    {"Pole",
     "[material.m]\nrefraction = { b = [1, 0, 0], c = [0.3, 0, 0] }\n",
     {":2:20: error: these coefficients give no refractive index between 0.1 and 10 at 390 nm: n^2 = -0.0284"}},
    {"Absorption", "[material.m]\nabsorption = [-1, 0, 0]\n", {":2:15: error: \"absorption\" must be at least 0 1/m, not -1"}},
};

const Mistake lights[] = {
    {"NoType",
     "[[light]]\nposition = [0, 0, 0]\n",
     {":1:1: error: a light needs \"type\": \"point\", \"spot\", \"directional\", \"projector\", \"goniometric\" or \"ies\""}},
    {"Type",
     "[[light]]\ntype = 'pont'\n",
     {":2:8: error: a light needs \"type\": \"point\", \"spot\", \"directional\", \"projector\", \"goniometric\" or \"ies\", not \"pont\"; "
      "did you mean \"point\"?"}},
    {"TypeNoText",
     "[[light]]\ntype = 1\n",
     {":2:8: error: a light needs \"type\": \"point\", \"spot\", \"directional\", \"projector\", \"goniometric\" or \"ies\", not a "
      "number"}},
    {"Position", "[[light]]\ntype = 'point'\n", {":1:1: error: a point light needs \"position\""}},
    {"KeyOfAnotherType",
     "[[light]]\ntype = 'point'\nposition = [0, 0, 0]\nangle = 3\n",
     {":4:1: error: a point light has no \"angle\"; it may have type, name, position, color, power, intensity"}},
    {"NoDirection",
     "[[light]]\ntype = 'directional'\ndirection = [0, 0, 0]\n",
     {":3:13: error: \"direction\" must have a length: [0, 0, 0] points nowhere"}},
    {"SpotWithoutDirection",
     "[[light]]\ntype = 'spot'\nposition = [0, 0, 0]\n",
     {":1:1: error: a spot light needs \"direction\" or \"look_at\""}},
    {"SpotWithTwo",
     "[[light]]\ntype = 'spot'\nposition = [0, 0, 0]\ndirection = [0, 1, 0]\nlook_at = [1, 1, 1]\n",
     {":1:1: error: a spot light has either \"direction\" or \"look_at\""}},
    {"SpotAtItself",
     "[[light]]\ntype = 'spot'\nposition = [1, 1, 1]\nlook_at = [1, 1, 1]\n",
     {":4:11: error: \"look_at\" must differ from \"position\""}},
    {"SpotFalloff",
     "[[light]]\ntype = 'spot'\nposition = [1, 1, 1]\nlook_at = [0, 0, 0]\nangle = 10\nfalloff = 11\n",
     {":6:11: error: \"falloff\" must be at most \"angle\", 10 degrees, not 11"}},
    {"SpotAngle",
     "[[light]]\ntype = 'spot'\nposition = [1, 1, 1]\nlook_at = [0, 0, 0]\nangle = 180\n",
     {":5:9: error: \"angle\" must be more than 0 and less than 180 degrees, not 180"}},
    {"Intensity",
     "[[light]]\ntype = 'point'\nposition = [0, 0, 0]\nintensity = -0.5\n",
     {":4:13: error: \"intensity\" must be from 0 to 1000000, not -0.5"}},
};

const Mistake cameras[] = {
    {"Fov", "[camera]\nfov = 180\n", {":2:7: error: \"fov\" must be more than 0 and less than 180 degrees, not 180"}},
    {"FovAxis", "[camera]\nfov_axis = 'diagonal'\n", {":2:12: error: \"fov_axis\" must be \"width\" or \"height\", not \"diagonal\""}},
    {"LooksNowhere", "[camera]\nposition = [1, 2, 3]\nlook_at = [1, 2, 3]\n", {":3:11: error: \"look_at\" must differ from \"position\""}},
    {"Direction", "[camera]\ndirection = [0, 0, 0]\n", {":2:13: error: \"direction\" must have a length: [0, 0, 0] points nowhere"}},
    {"Both", "[camera]\ndirection = [0, 0, 1]\nlook_at = [0, 0, 0]\n", {":2:13: error: a camera has either \"look_at\" or \"direction\""}},
    {"UpAlongTheView",
     "[camera]\ndirection = [0, 0, 1]\nup = [0, 0, -2]\n",
     {":3:6: error: \"up\" must not point along the view: which way the picture is turned would be open"}},
    {"List", "[[camera]]\n", {":1:1: error: write [camera], or [camera.NAME] for several, instead of [[camera]]"}},
    {"KeyOfNamed", "[camera.front]\nfoov = 3\n", {":2:1: error: a camera has no \"foov\"; did you mean \"fov\"?"}},
    {"TableForKey", "[camera.position]\nx = 3\n", {":1:1: error: \"position\" must be three numbers [x, y, z], not a table"}},
};

const Mistake settings[] = {
    {"ZeroSize", "[render]\nsize = [0, 100]\n", {":2:9: error: \"size\" must be from 1 to 65536 pixels, not 0"}},
    {"LargeSize", "[render]\nsize = [100, 65537]\n", {":2:14: error: \"size\" must be from 1 to 65536 pixels, not 65537"}},
    {"FractionalSize",
     "[render]\nsize = [100.5, 10]\n",
     {":2:9: error: \"size\" must be [width, height] in whole numbers, not a fraction"}},
    {"Bounces", "[render]\nbounces = -1\n", {":2:11: error: \"bounces\" must be from 0 to 1024, not -1"}},
    {"FractionalBounces", "[render]\nbounces = 1.5\n", {":2:11: error: \"bounces\" must be a whole number, not a fraction"}},
    {"Ssaa", "[render]\nssaa = 0\n", {":2:8: error: \"ssaa\" must be from 1 to 64, not 0"}},
    {"Integrator",
     "[render]\nintegrator = 'pats'\n",
     {":2:14: error: \"integrator\" must be \"auto\", \"whitted\", \"path\", \"direct\", \"light\", \"bdpt\" or \"vcm\", not \"pats\""}},
    {"Aa", "[render]\naa = 4\n", {":2:6: error: \"aa\" must be \"uniform\" or \"adaptive\", not a number"}},
    {"HugeNumber",
     "[render]\nbounces = 9223372036854775807\n",
     {":2:11: error: \"bounces\" must be from 0 to 1024, not 9.223372036854776e+18"}},
    {"RenderNoTable", "render = 3\n", {":1:10: error: write [render] instead of a number"}},
    {"BackgroundTwice",
     "[background]\ncolor = 'red'\nzenith = 'blue'\n",
     {":3:10: error: a background has either \"color\" or \"zenith\""}},
    {"SkyAndColor",
     "[background]\nimage = 'sky.hdr'\nhorizon = 'blue'\n",
     {":2:9: error: cannot read \"sky.hdr\": there is no such file", ":3:11: error: a background has either \"image\" or \"horizon\""}},
    {"NoSky", "[background]\nimage = 'nothing.hdr'\n", {":2:9: error: cannot read \"nothing.hdr\": there is no such file"}},
    {"TurnedColor",
     "[background]\ncolor = 'red'\nrotation = 30\n",
     {":3:12: error: \"rotation\" turns an \"image\"; this background has none"}},
    {"NegativeStrength", "[background]\ncolor = 'red'\nstrength = -1\n", {":3:12: error: \"strength\" must be at least 0, not -1"}},
    {"DiffuseBounces", "[render]\ndiffuse_bounces = -1\n", {":2:19: error: \"diffuse_bounces\" must be from 0 to 1024, not -1"}},
    {"DirectSamples",
     "[render]\ndirect_samples = 'all'\n",
     {":2:18: error: \"direct_samples\" must be \"mis\", \"emitter\" or \"bsdf\", not \"all\""}},
    {"NegativeBackground", "background = [0, 0, -1]\n", {":1:21: error: \"background\" must be at least 0, not -1"}},
    {"Ambient",
     "ambient = 'rde'\n",
     {":1:11: error: \"ambient\" must be a color: \"#rrggbb\", a name such as \"red\", or [r, g, b], not \"rde\"; did you mean \"red\"?"}},
};

const Mistake groups[] = {
    {"Unknown",
     "[[group]]\nname = 'tree'\n[[place]]\ngroup = 'treee'\n",
     {":4:9: error: there is no group \"treee\"; did you mean \"tree\"?"}},
    {"UnknownAtAll", "[[place]]\ngroup = 'tree'\n", {":2:9: error: there is no group \"tree\"; there are no groups"}},
    {"WithoutName", "[[group]]\n", {":1:1: error: a group needs \"name\""}},
    {"PlaceWithoutGroup", "[[place]]\n", {":1:1: error: a placement needs \"group\""}},
    {"Twice", "[[group]]\nname = 'a'\n[[group]]\nname = 'a'\n", {":4:8: error: a group \"a\" was defined in line 1 already"}},
    {"UnknownInside", "[[group]]\nname = 'a'\n[[group.spher]]\n", {":3:9: error: a group has no \"spher\"; did you mean \"sphere\"?"}},
    {"NestedDefinition",
     "[[group]]\nname = 'a'\n[[group.group]]\nname = 'b'\n",
     {":3:9: error: a group has no \"group\"; it belongs to the whole file"}},
    {"InsideItself",
     "[[group]]\nname = 'a'\n[[group.place]]\ngroup = 'a'\n",
     {":4:9: error: a group can't be inside itself: \"a\" places \"a\""}},
    {"Circle",
     "[[group]]\nname = 'a'\n[[group.place]]\ngroup = 'b'\n[[group]]\nname = 'b'\n[[group.place]]\ngroup = 'c'\n"
     "[[group]]\nname = 'c'\n[[group.place]]\ngroup = 'b'\n[[place]]\ngroup = 'a'\n",
     {":12:9: error: a group can't be inside itself: \"b\" places \"c\" places \"b\""}},
    {"Vanishing",
     "[[group]]\nname = 'a'\n[[group.sphere]]\nscale = 1e-5\n[[group]]\nname = 'b'\n[[group.place]]\ngroup = 'a'\nscale = 1e-5\n"
     "[[place]]\ngroup = 'b'\nscale = 1e-5\n",
     {":10:1: error: what this places is scaled by 1e-15 in all: nothing would be left"}},
};

auto name_of = [](const ::testing::TestParamInfo<Mistake>& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Syntax, TomlMistake, ::testing::ValuesIn(syntax), name_of);
INSTANTIATE_TEST_SUITE_P(File, TomlMistake, ::testing::ValuesIn(whole_files), name_of);
INSTANTIATE_TEST_SUITE_P(Shape, TomlMistake, ::testing::ValuesIn(shapes), name_of);
INSTANTIATE_TEST_SUITE_P(Mesh, TomlMistake, ::testing::ValuesIn(meshes), name_of);
INSTANTIATE_TEST_SUITE_P(Material, TomlMistake, ::testing::ValuesIn(materials), name_of);
INSTANTIATE_TEST_SUITE_P(Light, TomlMistake, ::testing::ValuesIn(lights), name_of);
INSTANTIATE_TEST_SUITE_P(Camera, TomlMistake, ::testing::ValuesIn(cameras), name_of);
INSTANTIATE_TEST_SUITE_P(Setting, TomlMistake, ::testing::ValuesIn(settings), name_of);
INSTANTIATE_TEST_SUITE_P(Group, TomlMistake, ::testing::ValuesIn(groups), name_of);

// Group 0 holds a sphere; each further one places the one before, `times` times.
std::string chain(int length, int times) {
    std::string text = rest;
    for (int i = 0; i < length; ++i) {
        text += "[[group]]\nname = 'g" + std::to_string(i) + "'\n";
        text += i == 0 ? "[[group.sphere]]\n" : "";
        for (int k = 0; i > 0 && k < times; ++k) {
            text += "[[group.place]]\ngroup = 'g" + std::to_string(i - 1) + "'\n";
        }
    }
    return text + "[[place]]\ngroup = 'g" + std::to_string(length - 1) + "'\n";
}

TEST(TomlGroups, MayBeNestedSixtyFourDeep) {
    EXPECT_TRUE(read_text(chain(64, 1)).scene);
    EXPECT_EQ(read_text(chain(65, 1)).messages,
              std::vector<std::string>{"scene.toml:264:9: error: groups are nested too deep: at most 64 inside each other"});
}

TEST(TomlGroups, AHundredThousandDeepAreRefused) {
    const Reading reading = read_text(chain(100'000, 1));
    EXPECT_FALSE(reading.scene);
    EXPECT_EQ(reading.messages,
              std::vector<std::string>{"scene.toml:264:9: error: groups are nested too deep: at most 64 inside each other"});
}

TEST(TomlGroups, TooManyPlacementsAreRefused) {
    EXPECT_TRUE(read_text(chain(20, 2)).scene);
    const Reading reading = read_text(chain(60, 2));
    EXPECT_FALSE(reading.scene);
    ASSERT_EQ(reading.messages.size(), 1u) << reading.all();
    EXPECT_NE(reading.messages[0].find(": error: the placements make more than 10000000 objects"), std::string::npos) << reading.all();
}

TEST(TomlGroups, ACircleOfAHundredThousandIsRefused) {
    std::string text = chain(100'000, 1);
    text += "[[group]]\nname = 'h'\n";
    text.replace(text.find("[[group.sphere]]"), 16, "[[group.place]]\ngroup = 'g99999'\n");
    const Reading reading = read_text(text);
    EXPECT_FALSE(reading.scene);
    ASSERT_FALSE(reading.messages.empty());
    EXPECT_NE(reading.messages[0].find("a group can't be inside itself"), std::string::npos) << reading.messages[0];
    EXPECT_LT(reading.messages[0].size(), 300u);
}

TEST(TomlMistakes, StopsListingAfterAHundred) {
    std::string text;
    for (int i = 0; i < 10'000; ++i) {
        text += "[[sphere]]\nradius = -1\n";
    }
    const Reading reading = read_text(text);
    EXPECT_EQ(reading.messages.size(), 101u);
    EXPECT_EQ(reading.messages.back(), "scene.toml: error: too many errors; the rest is not listed");
}

TEST(ImportScene, ExplainsWhatCannotBeRead) {
    const TemporaryFolder folder;
    EXPECT_EQ(read_path(folder / "no.toml").all(), "error: cannot read \"" + (folder / "no.toml") + "\": there is no such file\n");
    EXPECT_EQ(read_path("x.blend").all(),
              "error: cannot tell what \"x.blend\" is: scenes end with one of .toml, .gltf, .glb, .obj, .ply, .pbrt, .xml\n");
    EXPECT_EQ(read_path("x").all(),
              "error: cannot tell what \"x\" is: scenes end with one of .toml, .gltf, .glb, .obj, .ply, .pbrt, .xml\n");
    std::filesystem::create_directory(folder / "folder.toml");
    EXPECT_EQ(read_path(folder / "folder.toml").all(), "error: cannot read \"" + (folder / "folder.toml") + "\": it is a folder\n");
    const std::string large = folder.write("large.toml", "");
    std::filesystem::resize_file(large, 33u << 20);
    EXPECT_EQ(read_path(large).all(), "error: cannot read \"" + large + "\": it has 34603008 bytes, and at most 33554432 are accepted\n");
    const std::string pipe = folder / "pipe.ply";
    ASSERT_EQ(std::system(("mkfifo '" + pipe + "'").c_str()), 0);
    EXPECT_EQ(read_path(pipe).all(), "error: cannot read \"" + pipe + "\": it is not a regular file\n");
}

}  // namespace
}  // namespace lancer
