#include "lancer/app/figures/table.h"

namespace lancer::app {

namespace {

const char* const figure_1 = "scenes/report/figure-1.toml";
const char* const lights = "scenes/report/lights.toml";

Figure bounces(const std::string& number, const std::string& caption) {
    return {"bounces-" + number, caption, figure_1, {"--bounces", number}};
}

const Enlargement part_of_figure_1 = {385, 470, 80, 45, 8};

Figure supersampling(const std::string& factor, const std::string& caption) {
    return {"ssaa-" + factor, caption, figure_1, {"--ssaa", factor}, part_of_figure_1};
}

Figure feature(const std::string& name, const std::string& caption) { return {name, caption, "scenes/features/" + name + ".toml", {}}; }

Figure gallery(const std::string& name, const std::string& caption) { return {name, caption, "scenes/gallery/" + name + ".toml", {}}; }

// Scenes that follow physics: smaller than the others, and with fewer samples than their authors ask for, so that all of them take minutes.
const std::vector<std::string> small_and_quick = {"--size", "640x360", "--spp", "64"};

const std::vector<std::string> square_and_quick = {"--size", "480x480", "--spp", "64"};

Figure physical(const std::string& name, const std::string& caption) {
    return {name, caption, "scenes/features/" + name + ".toml", small_and_quick};
}

Figure physical_gallery(const std::string& name, const std::string& caption, const std::vector<std::string>& options) {
    return {name, caption, "scenes/gallery/" + name + ".toml", options};
}

std::vector<FigureGroup> make_table() {
    return {
        {"Figure 1",
         "What lancer shows when it is started without arguments.",
         {{"figure-1", "Reflecting spheres and boxes on a floor, under two lights.", figure_1, {}}}},
        {"Figure 2: fields of view",
         "The same place and direction, another angle between the left and the right edge.",
         {{"fov-90", "90 degrees, about what a person sees.", figure_1, {"--camera", "fov-90"}},
          {"fov-130", "130 degrees, a wide-angle lens.", figure_1, {"--camera", "fov-130"}}}},
        {"Figure 3: directions of the camera",
         "The camera looks where it is told, in any format of picture.",
         {{"level", "A level axis.", figure_1, {"--camera", "level"}},
          {"low-angle", "From below, in the format 4:3.", figure_1, {"--size", "960x720", "--camera", "low-angle"}}}},
        {"Figure 4: bounces",
         "How often light is followed from mirror to mirror. Each bounce adds less than the one before.",
         {bounces("0", "None: no reflections."), bounces("1", "One."), bounces("2", "Two."), bounces("3", "Three."), bounces("4", "Four."),
          bounces("5", "Five: hardly to be told from four.")}},
        {"Figure 5: supersampling",
         "Each pixel is the mean of a grid of samples; beside it a part of the picture, eight times enlarged.",
         {supersampling("1", "1 x 1: steps along the edges."), supersampling("2", "2 x 2."), supersampling("4", "4 x 4."),
          supersampling("8", "8 x 8.")}},
        {"Figure 6: lights",
         "Each light has its share of the whole, and its own shadows.",
         {{"one-light", "One.", lights, {"--lights", "left"}},
          {"two-lights", "Two.", lights, {"--lights", "left,right"}},
          {"three-lights", "Three.", lights, {}}}},
        {"Adaptive anti-aliasing",
         "A pixel is subdivided where its corners differ, and its parts again, where they still do. The map shows the "
         "samples that each pixel took: the brighter, the more.",
         {{"figure-1-adaptive", "Figure 1 with the samples where they matter.", figure_1, {"--aa", "adaptive"}, part_of_figure_1, true},
          {"adaptive", "A mirror, a knot and a checkered floor.", "scenes/features/adaptive.toml", {}, std::nullopt, true}}},
        {"Shapes",
         "What scenes are made of.",
         {feature("sphere", "Spheres."), feature("box", "Boxes."), feature("plane", "Planes."), feature("disk", "Disks."),
          feature("cylinder", "Cylinders."), feature("cone", "Cones, whole and truncated."),
          feature("mesh-inline", "Meshes written in the scene."), feature("mesh-obj", "Meshes from OBJ files."),
          feature("mesh-ply", "Meshes from PLY files.")}},
        {"Transforms and groups",
         "Every shape can be scaled, rotated and moved; groups are placed as often as wanted.",
         {feature("transforms", "Scaled, rotated, moved, mirrored."), feature("groups", "A column made once, a temple made of it.")}},
        {"Materials and textures",
         "",
         {feature("materials", "From above: ambient, diffuse, highlight, shininess, reflectivity, growing from left to right."),
          feature("checker", "Checkers, in space and on the surface."), feature("image-texture", "A picture on each shape."),
          feature("texture-options", "Repeated, clamped, mirrored; smooth and not; moved.")}},
        {"Lights and background",
         "",
         {feature("light-point", "A point light."), feature("light-spot", "Spot lights."),
          feature("light-directional", "A directional light."),
          feature("background", "A gradient behind everything, seen in every mirror.")}},
        {"Refraction",
         "At each surface light is reflected and refracted, as Fresnel says; inside, colours fade with the depth.",
         {feature("transparency", "More and more transparent; behind: other refractive indices."),
          feature("glass-spheres", "A full ball of glass, a hollow one, one of water, and a box."),
          feature("nested-glass", "Glass in glass: water in a tumbler, bubbles of air."),
          feature("absorption", "Green glass, thin and thick.")}},
        {"Dispersion",
         "The refractive index depends on the wavelength: white light comes apart into its colours.",
         {feature("prism", "A bar of white light seen through a prism."), feature("glasses", "Four glasses, four spectra."),
          feature("dispersion", "The fire of cut stones.")}},
        {"Gallery",
         "All together.",
         {gallery("chess", "An endgame of glass and wood."), gallery("glassware", "Red wine, water, a marble and a paperweight."),
          gallery("city", "A city at dusk: 415 towers from six groups."), gallery("sphereflake", "7381 balls from five short groups.")}},
        {"Light that follows physics: materials",
         "Paths of light at the wavelengths of nature; as many samples as a minute allows.",
         {physical("metals", "Metals by their measured indices."), physical("clear-bodies", "Glass, rough glass, water, panes."),
          physical("metamers", "Two greys that are one under daylight, and two under other lamps."),
          physical("plastics", "A coloured body under a clear coat."),
          physical("mapping", "Pictures and checkers on surfaces, averaged over what a pixel sees."),
          physical("masks", "Cut-out surfaces."), physical("mixes", "Two materials in one."),
          physical("bumps", "Normals bent by pictures and heights."), physical("vertex-colors", "Colours that meshes bring along."),
          physical("principled", "One layered material: lacquer, brushed metal, velvet, tinted glass, a film of oxide.")}},
        {"Light that follows physics: lamps and lenses",
         "",
         {physical("lamps", "A ball, a box, a tube and a cone that shine."),
          physical("environment", "All light comes from a picture of the sky."), physical("projector", "A picture thrown on a wall."),
          physical("goniometric", "A picture thrown all around."), physical("light-ies", "Lamps with photometric files."),
          physical("many-lights", "Lamps of all kinds, of which each path asks one."),
          physical("sky", "A clear sky with the sun, computed for a place and a time."),
          physical("direct-light", "Lamps of four sizes over plates from smooth to rough."),
          physical("depth-of-field", "What lies before and behind the plane that is sharp.")}},
        {"Light that follows physics: media",
         "Fog, smoke, milk and fire: what fills space absorbs, scatters and shines.",
         {physical("fog-balls", "Smoke, fog, haze and air; milk and wine in glass."),
          physical("fog-cloud", "A cloud from a grid."),
          {"fog-flame", "Soot that shines as hot as a grid says.", "scenes/features/fog-flame.toml", square_and_quick},
          physical("fog-overlap", "Glass and ink that overlap: the higher priority has the place.")}},
        {"Light that follows physics: gallery",
         "",
         {physical_gallery("light-shafts", "The sun in a dusty hall.", small_and_quick),
          physical_gallery("cornell-box", "All light here has been scattered at least once.", square_and_quick),
          physical_gallery("metal-samples", "Gold, copper, aluminium and titanium from polished to matt.", small_and_quick),
          physical_gallery("goblets", "Crystal and wine at a window.", square_and_quick),
          physical_gallery("chess-focus", "Boxwood and ebony through a fast lens.", small_and_quick),
          physical_gallery("diamonds", "The fire of seven brilliants.", small_and_quick),
          physical_gallery("flacon", "Thick glass and gold under an afternoon sky.", square_and_quick),
          physical_gallery("daylight-room", "All light comes through one window.", small_and_quick),
          physical_gallery("night-city", "Thousands of windows and street lamps.", small_and_quick),
          physical_gallery("pavilion-morning", "Sun and sky in the morning.", small_and_quick),
          physical_gallery("pavilion-noon", "At noon.", small_and_quick), physical_gallery("pavilion-dusk", "At dusk.", small_and_quick),
          physical_gallery("still-life", "What lies on surfaces: wood, a globe, worn paint, studs, tiles, a leaf.", small_and_quick)}},
        {"Light from the lamps",
         "Paths from both ends, and photons: what glass and mirrors throw.",
         {Figure{"rainbow", "A white beam, a prism, a wall.", "scenes/gallery/prism.toml", small_and_quick},
          physical_gallery("ring", "Two curves of light that meet in a cusp.", small_and_quick),
          physical_gallery("diamond-fire", "Each way through a brilliant ends as a small spectrum.", small_and_quick),
          physical_gallery("pool", "The bottom of a pool in the sun.", {"--size", "480x270", "--spp", "16"}),
          physical_gallery("wine-glass", "What a glass of wine throws on the table.", {"--size", "360x360", "--spp", "16"}),
          physical("both-ends", "A lamp in a shade, and one whose light goes through a glass ball."),
          physical("fog-beam", "Light that a ball of glass gathers in haze."),
          physical("caustic-in-mirror", "Light that a ring and a ball gather, and a mirror that shows it.")}},
    };
}

}  // namespace

const std::vector<FigureGroup>& figure_table() {
    static const std::vector<FigureGroup> table = make_table();
    return table;
}

}  // namespace lancer::app
