// glTF, seen: a small picture for each feature, compared with what the specification says must be there. Surfaces without light of their own are
// unlit where that says enough, so that colours are exact.
#include <numbers>

#include "gltf_file.h"
#include "lancer/image/image.h"
#include "rendered.h"

namespace lancer {
namespace {

using namespace lancer::testing;
using nlohmann::json;
using Json = nlohmann::json;  // within a class that has a member `json`
using Pixel = glm::dvec3;

constexpr double near_enough = 2e-3;  // single precision, and pictures in bytes of 1/255 that are exact where they are used

const json unlit = {{"KHR_materials_unlit", json::object()}};

std::string picture_of(const std::string& header, const std::string& bytes) {
    return "data:image/png;base64," + GltfFile::base64(header + "\n" + bytes);
}

std::string png(const ByteImage& image) {
    const TemporaryFolder folder;
    write_image(folder / "a.png", image, {});
    std::ifstream file(folder / "a.png", std::ios::binary);
    return "data:image/png;base64," + GltfFile::base64({std::istreambuf_iterator<char>(file), {}});
}

// From x = -1 to 1 and y = -1 to 1 in the plane z = 0, facing +z, texture coordinates from `low` to `high`, v downwards; a camera that sees
// just that.
class Stage : public GltfFile {
public:
    explicit Stage(float low = 0.0f, float high = 1.0f) {
        Json& quad = mesh({{"POSITION", accessor<float>("VEC3", {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0})}});
        quad["attributes"]["NORMAL"] = accessor<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
        quad["attributes"]["TEXCOORD_0"] = accessor<float>("VEC2", {low, high, high, high, high, low, low, low});
        quad["indices"] = accessor<std::uint16_t>("SCALAR", {0, 1, 2, 0, 2, 3});
        quad["material"] = 0;
        json["materials"] = {{{"doubleSided", false}, {"extensions", unlit}}};
        json["cameras"] = {{{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 10}}}}};
        json["nodes"].push_back({{"camera", 0}, {"translation", {0, 0, 5}}});
    }

    Json& primitive() { return json["meshes"][0]["primitives"][0]; }
    Json& material() { return json["materials"][0]; }
    Json& node() { return json["nodes"][0]; }

    // A picture as the base colour.
    void paint(const std::string& uri, const Json& sampler = {{"magFilter", 9728}, {"minFilter", 9728}},
               const Json& info = {{"index", 0}}) {
        json["images"] = {{{"uri", uri}}};
        json["samplers"] = Json::array({sampler});
        json["textures"] = {{{"source", 0}, {"sampler", 0}}};
        material()["pbrMetallicRoughness"]["baseColorTexture"] = info;
    }

    // The surroundings are `sky` on all sides.
    std::vector<Pixel> render(int width, int height, const Pixel& sky = Pixel(0.0), const ImportOptions& options = {}, int spp = 4) {
        const GltfReading reading = read_gltf_file(*this, options);
        EXPECT_TRUE(reading.scene) << reading.all();
        if (!reading.scene) {
            return std::vector<Pixel>(static_cast<std::size_t>(width * height));
        }
        scene::Scene scene = *reading.scene;
        if (width > height) {
            scene.cameras.front().fov_axis = scene::FovAxis::width;  // a strip across the middle
        }
        scene.background = {sky, sky, sky};
        scene.settings.rgb = true;
        scene.settings.filter = scene::PixelFilter::box;
        scene.settings.filter_radius = 0.5;
        const Film film = film_of(scene, width, height, spp);
        std::vector<Pixel> pixels;
        for (const glm::vec3& pixel : film.radiance) {
            pixels.emplace_back(pixel);
        }
        return pixels;
    }
};

// One letter for each pixel: black, red, green, blue, yellow, white; ? for anything else.
std::string letters(const std::vector<Pixel>& pixels) {
    std::string text;
    for (const Pixel& p : pixels) {
        const auto is = [&](double r, double g, double b) {
            return glm::all(glm::lessThan(glm::abs(p - Pixel(r, g, b)), Pixel(near_enough)));
        };
        text += is(0, 0, 0) ? 'k' : is(1, 0, 0) ? 'r' : is(0, 1, 0) ? 'g' : is(0, 0, 1) ? 'b' : is(1, 1, 0) ? 'y' : is(1, 1, 1) ? 'w' : '?';
    }
    return text;
}

void expect_near(const Pixel& pixel, const Pixel& expected, double tolerance = near_enough) {
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(pixel[i], expected[i], tolerance) << "channel " << i;
    }
}

// Red, green above; blue, yellow below.
std::string four_colors() { return picture_of("P6 2 2 255", std::string("\xff\0\0\0\xff\0\0\0\xff\xff\xff\0", 12)); }

TEST(GltfPictures, TexturesStandUpright) {
    Stage stage;
    stage.paint(four_colors());
    EXPECT_EQ(letters(stage.render(2, 2)), "rgby");
}

TEST(GltfPictures, WrapModes) {
    const auto row = [](int mode) {
        Stage stage(-1.0f, 2.0f);
        stage.paint(picture_of("P6 2 1 255", std::string("\xff\0\0\0\xff\0", 6)),
                    {{"magFilter", 9728}, {"minFilter", 9728}, {"wrapS", mode}});
        return letters(stage.render(6, 1));
    };
    EXPECT_EQ(row(10497), "rgrgrg");
    EXPECT_EQ(row(33071), "rrrggg");
    EXPECT_EQ(row(33648), "grrggr");
}

TEST(GltfPictures, LinearFilter) {
    Stage stage;
    stage.paint(picture_of("P6 2 1 255", std::string("\xff\xff\xff\0\0\0", 6)),
                {{"magFilter", 9729}, {"minFilter", 9729}, {"wrapS", 33071}});
    const std::vector<Pixel> pixels = stage.render(4, 1, Pixel(0.0), {}, 64);
    expect_near(pixels[0], Pixel(1.0));
    // A quarter of the way from one middle to the other, on the mean.
    expect_near(pixels[1], Pixel(0.75), 0.02);
    expect_near(pixels[2], Pixel(0.25), 0.02);
    expect_near(pixels[3], Pixel(0.0));
}

TEST(GltfPictures, TextureTransform) {
    Stage stage;
    const json quarter = {{"rotation", std::numbers::pi / 2}, {"offset", {0, 1}}, {"scale", {1, 1}}};
    stage.paint(four_colors(), {{"magFilter", 9728}, {"minFilter", 9728}},
                {{"index", 0}, {"extensions", {{"KHR_texture_transform", quarter}}}});
    // u = cos u + sin v + offset, v = -sin u + cos v + offset, v downwards.
    EXPECT_EQ(letters(stage.render(2, 2)), "bryg");
}

TEST(GltfPictures, SecondTextureCoordinates) {
    Stage stage;
    stage.primitive()["attributes"]["TEXCOORD_1"] = stage.accessor<float>("VEC2", {1, 1, 0, 1, 0, 0, 1, 0});
    stage.paint(four_colors(), {{"magFilter", 9728}, {"minFilter", 9728}}, {{"index", 0}, {"texCoord", 1}});
    EXPECT_EQ(letters(stage.render(2, 2)), "gryb");
}

TEST(GltfPictures, VertexColorsAreLinearAndMultiply) {
    Stage stage;
    stage.primitive()["attributes"]["COLOR_0"] =
        stage.accessor<std::uint8_t>("VEC4", {255, 0, 0, 255, 255, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 255}, true);
    stage.material()["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 1, 0.25, 1};
    const std::vector<Pixel> pixels = stage.render(1, 4, Pixel(0.0), {}, 256);
    expect_near(pixels[0], Pixel(0.5, 0.875, 0.21875), 0.02);
    expect_near(pixels[3], Pixel(0.5, 0.125, 0.03125), 0.02);
}

TEST(GltfPictures, AlphaModes) {
    const auto seen = [](const json& material) {
        Stage stage;
        stage.material().update(material);
        return stage.render(1, 1, Pixel(0.0, 1.0, 0.0), {}, 1024)[0];
    };
    const json red = {{"baseColorFactor", {1, 0, 0, 0.25}}};
    expect_near(seen({{"pbrMetallicRoughness", red}}), Pixel(1, 0, 0));
    expect_near(seen({{"pbrMetallicRoughness", red}, {"alphaMode", "MASK"}}), Pixel(0, 1, 0));
    expect_near(seen({{"pbrMetallicRoughness", red}, {"alphaMode", "MASK"}, {"alphaCutoff", 0.2}}), Pixel(1, 0, 0));
    // 1024 samples of a share of 1/4: a standard deviation of 0.014, stratified or not.
    expect_near(seen({{"pbrMetallicRoughness", red}, {"alphaMode", "BLEND"}}), Pixel(0.25, 0.75, 0), 0.07);
}

TEST(GltfPictures, SidesAndMirroring) {
    const auto seen = [](const json& node, bool double_sided) {
        Stage stage;
        stage.paint(four_colors());
        stage.material()["doubleSided"] = double_sided;
        stage.node().update(node);
        return letters(stage.render(2, 2));
    };
    EXPECT_EQ(seen({{"rotation", {0, 1, 0, 0}}}, false), "kkkk");
    EXPECT_EQ(seen({{"rotation", {0, 1, 0, 0}}}, true), "gryb");
    EXPECT_EQ(seen({{"scale", {-1, 1, 1}}}, false), "gryb");
    EXPECT_EQ(seen({{"matrix", {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}, false), "byrg");
}

TEST(GltfPictures, StripsAndFans) {
    for (const auto& [mode, order] : std::vector<std::pair<int, std::vector<std::uint8_t>>>{{5, {0, 1, 3, 2}}, {6, {0, 1, 2, 3}}}) {
        Stage stage;
        stage.primitive()["mode"] = mode;
        stage.primitive()["indices"] = stage.accessor<std::uint8_t>("SCALAR", order);
        EXPECT_EQ(letters(stage.render(2, 2)), "wwww") << mode;
    }
}

TEST(GltfPictures, Animation) {
    // Two steps to the right at 1 s, in the way of each interpolation; with the slopes of this spline the half is at 1/2 as well.
    const auto seen = [](const std::string& interpolation, double frame) {
        Stage stage;
        const bool spline = interpolation == "CUBICSPLINE";
        const int times = stage.accessor<float>("SCALAR", {0, 1});
        const int moves = spline ? stage.accessor<float>("VEC3", {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0})
                                 : stage.accessor<float>("VEC3", {0, 0, 0, 2, 0, 0});
        stage.json["animations"] = {{{"samplers", {{{"input", times}, {"output", moves}, {"interpolation", interpolation}}}},
                                     {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
        ImportOptions options;
        options.frame = frame;
        return letters(stage.render(8, 1, Pixel(0.0), options));
    };
    EXPECT_EQ(seen("STEP", 0.9), "wwwwwwww");
    EXPECT_EQ(seen("LINEAR", 0.25), "kkwwwwww");
    EXPECT_EQ(seen("LINEAR", 0.5), "kkkkwwww");
    EXPECT_EQ(seen("CUBICSPLINE", 0.5), "kkkkwwww");
    EXPECT_EQ(seen("CUBICSPLINE", 1.0), "kkkkkkkk");
}

TEST(GltfPictures, MorphTargets) {
    Stage stage;
    stage.primitive()["targets"] = {{{"POSITION", stage.accessor<float>("VEC3", {2, 0, 0, 2, 0, 0, 2, 0, 0, 2, 0, 0})}}};
    stage.json["meshes"][0]["weights"] = {0.25};
    EXPECT_EQ(letters(stage.render(4, 1)), "kwww");
    stage.node()["weights"] = {0.5};
    EXPECT_EQ(letters(stage.render(4, 1)), "kkww");
}

TEST(GltfPictures, Skins) {
    Stage stage;
    // The two corners on the left follow one joint, those on the right the other.
    stage.primitive()["attributes"]["JOINTS_0"] = stage.accessor<std::uint8_t>("VEC4", {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0});
    stage.primitive()["attributes"]["WEIGHTS_0"] = stage.accessor<float>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    stage.json["skins"] = {{{"joints", {2, 3}}}};
    stage.node()["skin"] = 0;
    stage.json["nodes"].push_back({{"translation", {0.5, 0, 0}}});
    stage.json["nodes"].push_back({{"translation", {-0.5, 0, 0}}});
    EXPECT_EQ(letters(stage.render(4, 1)), "kwwk");
}

TEST(GltfPictures, Instances) {
    Stage stage;
    stage.node()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", stage.accessor<float>("VEC3", {-0.75, 0, 0, 0.75, 0, 0})},
        {"SCALE", stage.accessor<float>("VEC3", {0.25, 1, 1, 0.25, 1, 1})}};
    stage.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
    EXPECT_EQ(letters(stage.render(4, 1)), "wkkw");
}

TEST(GltfPictures, ScenesAndVariants) {
    Stage stage;
    stage.json["scenes"] = {{{"nodes", {1}}, {"name", "empty"}}, {{"nodes", {0, 1}}, {"name", "full"}}};
    stage.json["scene"] = 0;
    stage.json["materials"].push_back({{"extensions", unlit}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}}}});
    stage.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "red"}}};
    stage.primitive()["extensions"]["KHR_materials_variants"]["mappings"] = {{{"material", 1}, {"variants", {0}}}};
    ImportOptions options;
    options.scene = "full";
    EXPECT_EQ(letters(stage.render(1, 1, Pixel(0.0), options)), "w");
    options.variant = "red";
    EXPECT_EQ(letters(stage.render(1, 1, Pixel(0.0), options)), "r");
    options = {};
    EXPECT_EQ(letters(stage.render(1, 1, Pixel(0.0), options)), "k");
}

TEST(GltfPictures, EmissiveStrength) {
    Stage stage;
    stage.material() = {{"emissiveFactor", {1, 0.5, 0}},
                        {"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 1}}, {"metallicFactor", 1}}},
                        {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}};
    expect_near(stage.render(1, 1)[0], Pixel(4, 2, 0));
}

// Lit by one lamp; twice as far away and four times as strong is the same, and so is a sun of that strength where it arrives straight.
TEST(GltfPictures, PunctualLights) {
    const auto seen = [](const json& lamp, const json& node) {
        Stage stage;
        stage.material() = {{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}}};
        stage.node()["scale"] = {0.001, 0.001, 1};  // so small that the lamp is as far from all of it
        stage.json["cameras"][0]["orthographic"] = {{"xmag", 0.0005}, {"ymag", 0.0005}, {"znear", 0.1}, {"zfar", 10}};
        stage.json["extensions"]["KHR_lights_punctual"]["lights"] = json::array({lamp});
        stage.json["nodes"].push_back(node);
        stage.json["nodes"].back()["extensions"]["KHR_lights_punctual"]["light"] = 0;
        return stage.render(1, 1, Pixel(0.0), {}, 16)[0];
    };
    const Pixel near = seen({{"type", "point"}, {"intensity", 1}}, {{"translation", {0, 0, 1}}});
    EXPECT_GT(near.y, 0.2);
    expect_near(seen({{"type", "point"}, {"intensity", 4}}, {{"translation", {0, 0, 2}}}), near);
    expect_near(seen({{"type", "directional"}, {"intensity", 1}}, json::object()), near);
    expect_near(seen({{"type", "spot"}, {"intensity", 1}, {"spot", json::object()}}, {{"translation", {0, 0, 1}}}), near);
    expect_near(seen({{"type", "spot"}, {"spot", json::object()}}, {{"translation", {0, 0, 1}}, {"rotation", {0, 1, 0, 0}}}), Pixel(0.0));
    expect_near(seen({{"type", "point"}, {"color", {1, 0, 0}}}, {{"translation", {0, 0, 1}}}), Pixel(near.x, 0, 0));
}

// Bent to one side by its map, the surface is darker in light from the other side.
TEST(GltfPictures, NormalMaps) {
    const auto seen = [](const char* normal) {
        Stage stage;
        stage.paint(picture_of("P6 1 1 255", normal));
        stage.material() = {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}, {"normalTexture", {{"index", 0}}}};
        stage.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "directional"}}};
        stage.json["nodes"].push_back(
            {{"rotation", {0, 0.3826834, 0, 0.9238795}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
        return stage.render(1, 1, Pixel(0.0), {}, 16)[0].y;
    };
    const double towards = seen("\xda\x80\xda"), flat = seen("\x80\x80\xff"), away = seen("\x26\x80\xda");
    EXPECT_GT(towards, 1.2 * flat);
    EXPECT_LT(away, 0.3 * flat);
}

TEST(GltfPictures, Transmission) {
    const auto seen = [](const json& extensions) {
        Stage stage;
        stage.material() = {{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0}, {"baseColorFactor", {0.5, 1, 1, 1}}}},
                            {"extensions", extensions}};
        return stage.render(1, 1, Pixel(0.25), {}, 256)[0];
    };
    const json clear = {{"transmissionFactor", 1}};
    // Of an index of 1, nothing is reflected.
    expect_near(seen({{"KHR_materials_transmission", clear}, {"KHR_materials_ior", {{"ior", 1}}}}), Pixel(0.125, 0.25, 0.25), 4e-3);
    // In even surroundings, what is reflected is as bright as what passes.
    const Pixel glass = seen({{"KHR_materials_transmission", clear}});
    EXPECT_GT(glass.x, 0.125);
    expect_near(Pixel(0.0, glass.y, glass.z), Pixel(0, 0.25, 0.25), 4e-3);
}

// A slab of 1 m, of the index of air: what is left is the colour that the volume has after 1 m.
TEST(GltfPictures, Volume) {
    Stage stage;
    json& slab = stage.primitive();
    slab["attributes"] = {
        {"POSITION", stage.accessor<float>("VEC3", {-3, -3, -1, 3, -3, -1, 3, 3, -1, -3, 3, -1, -3, -3, 0, 3, -3, 0, 3, 3, 0, -3, 3, 0})}};
    slab["indices"] = stage.accessor<std::uint8_t>(
        "SCALAR", {4, 5, 6, 4, 6, 7, 0, 2, 1, 0, 3, 2, 0, 1, 5, 0, 5, 4, 2, 3, 7, 2, 7, 6, 1, 2, 6, 1, 6, 5, 0, 4, 7, 0, 7, 3});
    stage.material() = {
        {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0}}},
        {"extensions",
         {{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
          {"KHR_materials_ior", {{"ior", 1}}},
          {"KHR_materials_volume", {{"thicknessFactor", 1}, {"attenuationDistance", 1}, {"attenuationColor", {0.25, 0.5, 1}}}}}}};
    expect_near(stage.render(1, 1, Pixel(1.0), {}, 64)[0], Pixel(0.25, 0.5, 1), 1e-2);
}

TEST(GltfPictures, Specular) {
    const auto seen = [](const json& specular, bool with_texture = false) {
        Stage stage;
        if (with_texture) {
            stage.paint(png({1, 1, 4, {255, 255, 255, 128}}));
        }
        stage.material() = {{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0}, {"baseColorFactor", {0, 0, 0, 1}}}},
                            {"extensions", {{"KHR_materials_specular", specular}}}};
        return stage.render(1, 1, Pixel(1.0), {}, 16384)[0];
    };
    // One sample in 25 is reflected: a standard deviation of 0.0015, and twice as much for the last but one.
    expect_near(seen(json::object()), Pixel(0.04), 6e-3);
    expect_near(seen({{"specularFactor", 0}}), Pixel(0.0));
    expect_near(seen({{"specularFactor", 0.5}}), Pixel(0.02), 6e-3);
    expect_near(seen({{"specularColorFactor", {1, 0.5, 0}}}), Pixel(0.04, 0.02, 0), 6e-3);
    expect_near(seen({{"specularColorFactor", {4, 2, 0}}}), Pixel(0.16, 0.08, 0), 1.2e-2);
    expect_near(seen({{"specularTexture", {{"index", 0}}}}, true), Pixel(0.02), 6e-3);
}

// What each of these adds is seen, and takes no light from nowhere: in white surroundings nothing is brighter than they are.
TEST(GltfPictures, LayersAreSeenAndGiveNoMoreThanTheyGet) {
    const auto seen = [](const json& extensions, double metallic, const Pixel& sky) {
        Stage stage;
        stage.material() = {
            {"pbrMetallicRoughness", {{"metallicFactor", metallic}, {"roughnessFactor", 0.5}, {"baseColorFactor", {0.2, 0.2, 0.2, 1}}}},
            {"extensions", extensions}};
        return stage.render(1, 1, sky, {}, 1024)[0];
    };
    const json layers = {{"KHR_materials_clearcoat", {{"clearcoatFactor", 1}}},
                         {"KHR_materials_sheen", {{"sheenColorFactor", {1, 1, 1}}, {"sheenRoughnessFactor", 0.8}}},
                         {"KHR_materials_iridescence", {{"iridescenceFactor", 1}, {"iridescenceThicknessMaximum", 500}}}};
    for (const auto& [name, layer] : layers.items()) {
        const double metallic = name == "KHR_materials_iridescence" ? 1.0 : 0.0;
        const Pixel plain = seen(json::object(), metallic, Pixel(1.0)), layered = seen({{name, layer}}, metallic, Pixel(1.0));
        EXPECT_GT(glm::length(layered - plain), 0.01) << name;
        EXPECT_LT(std::max({layered.x, layered.y, layered.z}), 1.01) << name;
    }
    // Half a film is half way.
    const auto film = [&](double factor) {
        return seen({{"KHR_materials_iridescence", {{"iridescenceFactor", factor}, {"iridescenceThicknessMaximum", 500}}}}, 1.0,
                    Pixel(1.0));
    };
    expect_near(film(0.5), 0.5 * (film(0.0) + film(1.0)), 0.02);
}

TEST(GltfPictures, PerspectiveCameras) {
    Stage stage;
    stage.json["cameras"][0] = {{"type", "perspective"},
                                {"perspective", {{"yfov", 2.0 * std::atan(0.4)}, {"aspectRatio", 1}, {"znear", 0.1}}}};
    // At a distance of 5 the picture is 4 m high: the quad takes the middle half.
    EXPECT_EQ(letters(stage.render(4, 4)), "kkkkkwwkkwwkkkkk");
}

TEST(GltfPictures, PercentSignsAndUtf8InNames) {
    const TemporaryFolder folder;
    folder.write("a b\xe2\x9d\xa4.ppm", std::string("P6 1 1 255\n\0\0\xff", 14));
    Stage stage;
    stage.paint("a%20b%E2%9D%A4.ppm");
    const Reading reading = read_path(folder.write("s\xc3\xa4.gltf", stage.text()));
    ASSERT_TRUE(reading.scene) << reading.all();
    scene::Scene scene = *reading.scene;
    scene.settings.rgb = true;
    const Film film = film_of(scene, 1, 1, 1);
    expect_near(Pixel(film.radiance.at(0)), Pixel(0, 0, 1));
}

}  // namespace
}  // namespace lancer
