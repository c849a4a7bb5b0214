// MTL: what becomes of each statement, and OBJ files as scenes.
#include <algorithm>

#include "rendered.h"

namespace lancer {
namespace {

using namespace lancer::testing;

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";

struct Obj : Reading {
    ImportReport report;

    const scene::Material& material(std::size_t object = 0) const {
        return scene->materials.at(static_cast<std::size_t>(scene->objects.at(object).material));
    }
    template <class Model>
    const Model& model(std::size_t object = 0) const {
        return std::get<Model>(material(object).model);
    }
    bool tells(Treatment treatment, const std::string& feature) const {
        return std::any_of(report.entries().begin(), report.entries().end(), [&](const ImportEntry& entry) {
            return entry.treatment == treatment && entry.feature.find(feature) != std::string::npos;
        });
    }
};

Obj read_obj_with(const std::string& mtl, const std::string& obj = std::string(triangle) + "usemtl m\nf 1/1 2/2 3/3\n",
                  ImportOptions options = {}) {
    const TemporaryFolder folder;
    folder.write("a.mtl", mtl);
    folder.write("p.ppm", std::string("P6 1 1 255\n\xff\x80\x00", 14));
    const std::string path = folder.write("a.obj", "mtllib a.mtl\n" + obj);
    Diagnostics diagnostics;
    Obj result;
    auto scene = import_scene(path, options, result.report, diagnostics);
    static_cast<Reading&>(result) = gather(std::move(scene), diagnostics);
    EXPECT_TRUE(result.scene) << result.all();
    return result;
}

TEST(Mtl, MattSurfaces) {
    const Obj obj = read_obj_with("newmtl m\nKd .5 0.25 1.5\nillum 1\n");
    const auto& color = std::get<scene::Color>(obj.model<scene::DiffuseMaterial>().color);
    EXPECT_EQ(color.rgb, scene::Rgb(0.5, 0.25, 1.0));
    EXPECT_TRUE(obj.tells(Treatment::approximated, "kd above 1")) << "no surface gives back more than it gets";
    EXPECT_EQ(obj.scene->lights.size(), 0u);
    EXPECT_GT(obj.scene->background.zenith.rgb.x, 0.0) << "neutral surroundings";
}

TEST(Mtl, HighlightsAreFacetsOfACoat) {
    const Obj obj = read_obj_with("newmtl m\nKd 0.5 0.5 0.5\nKs 0.25 0.25 0.25\nNs 126\n");
    const auto& model = obj.model<scene::PrincipledMaterial>();
    // alpha^2 = 2 / (n + 2), and alpha is the square of the roughness.
    EXPECT_NEAR(model.roughness.number, std::pow(2.0 / 128.0, 0.25), 1e-12);
    EXPECT_EQ(std::get<scene::Color>(model.specular).rgb, scene::Rgb(0.5));
}

TEST(Mtl, MirrorsGiveBackKs) {
    const Obj obj = read_obj_with("newmtl m\nKd 0 0 0\nKs 0.75 0.375 0\nillum 3\n");
    const auto& model = obj.model<scene::PrincipledMaterial>();
    const double amplitude = (model.refraction - 1.0) / (model.refraction + 1.0);
    EXPECT_NEAR(amplitude * amplitude, 0.75, 1e-12);
    EXPECT_EQ(std::get<scene::Color>(model.specular).rgb, scene::Rgb(1.0, 0.5, 0.0));
    EXPECT_EQ(model.roughness.number, 0.0);
}

TEST(Mtl, Glass) {
    const Obj obj = read_obj_with("newmtl m\nNi 1.25\nTf 0.5 1 1\nillum 7\n");
    EXPECT_EQ(std::get<double>(obj.model<scene::DielectricMaterial>().refraction), 1.25);
    EXPECT_EQ(std::get<scene::Color>(obj.model<scene::DielectricMaterial>().color).rgb, scene::Rgb(0.5, 1.0, 1.0));
}

TEST(Mtl, KeysOfPhysicalRenderers) {
    const Obj obj = read_obj_with("newmtl m\nKd 1 0.5 0.25\nPm 0.5\nPr 0.25\nPs 0.125\nPc 1\nPcr 0.75\naniso 0.5\n");
    const auto& model = obj.model<scene::PrincipledMaterial>();
    EXPECT_EQ(model.metalness.number, 0.5);
    EXPECT_EQ(model.roughness.number, 0.25);
    EXPECT_EQ(std::get<scene::Color>(model.sheen).rgb, scene::Rgb(0.125));
    EXPECT_EQ(model.coat.number, 1.0);
    EXPECT_EQ(model.coat_roughness.number, 0.75);
    EXPECT_EQ(model.anisotropy.number, 0.5);
}

TEST(Mtl, LampsAndOpacity) {
    const Obj obj = read_obj_with("newmtl m\nKe 4 2 0\nd 0.25\n");
    ASSERT_TRUE(obj.material().emission);
    EXPECT_EQ(obj.material().emission->strength, 4.0);
    EXPECT_EQ(obj.material().opacity.number, 0.25);
    EXPECT_EQ(obj.scene->background.zenith.rgb, scene::Rgb(0.0)) << "it has a lamp of its own";
    EXPECT_EQ(read_obj_with("newmtl m\nTr 0.25\n").material().opacity.number, 0.75);
}

TEST(Mtl, PicturesAndTheirOptions) {
    const Obj obj = read_obj_with(
        "newmtl m\nKd 0.5 0.5 0.5\nillum 1\nmap_Kd -s 2 3 4 -o 0.25 0.5 -clamp on -blendu off -mm 0 0.5 p.ppm\nbump -bm 2 -imfchan g "
        "p.ppm\nmap_d p.ppm\n");
    const auto& image = std::get<scene::ImageTexture>(obj.model<scene::DiffuseMaterial>().color);
    EXPECT_EQ(image.scale, glm::dvec2(2.0, 3.0));
    EXPECT_EQ(image.offset, glm::dvec2(0.25, 0.5));
    EXPECT_EQ(image.wrap, scene::Wrap::clamp);
    EXPECT_EQ(image.tint, scene::Rgb(0.25));
    EXPECT_FALSE(image.linear);
    EXPECT_EQ(obj.material().relief.heights->channel, scene::Channel::green);
    EXPECT_EQ(obj.material().relief.heights->scale, 0.02);
    EXPECT_EQ(obj.material().opacity.channel, scene::Channel::alpha) << "of the picture that gives the colour as well";
}

TEST(Mtl, EachMaterialOfEachGroupIsAnObject) {
    const Obj obj =
        read_obj_with("newmtl red one\nKd 1 0 0\nnewmtl green\nKd 0 1 0\n",
                      std::string(triangle) +
                          "g left\nusemtl red one\nf 1 2 3\nusemtl green\nf 1 2 3\ng right\nf 1 2 3\nusemtl red one\nf -3 -2 -1\n"
                          "g left\nf 3 2 1\n");
    ASSERT_EQ(obj.scene->objects.size(), 4u);
    EXPECT_EQ(obj.scene->objects[0].name, "left");
    EXPECT_EQ(obj.material(0).name, "red one");
    EXPECT_EQ(std::get<scene::Mesh>(obj.scene->objects[0].shape).data->triangles.size(), 2u);
    EXPECT_EQ(obj.material(1).name, "green");
    EXPECT_EQ(obj.scene->objects[2].name, "right");
    EXPECT_EQ(obj.scene->materials.size(), 2u);
}

TEST(Mtl, MissingFilesAreGreyAndSaid) {
    const TemporaryFolder folder;
    const Reading reading = read_path(folder.write("a.obj", "mtllib gone away.mtl\n" + std::string(triangle) + "usemtl m\nf 1 2 3\n"));
    ASSERT_TRUE(reading.scene) << reading.all();
    EXPECT_NE(reading.all().find("a.obj:1:1: warning"), std::string::npos) << reading.all();
    EXPECT_NE(reading.all().find("grey"), std::string::npos) << reading.all();
}

TEST(Mtl, MissingPicturesAreErrorsOrMagenta) {
    const std::string mtl = "newmtl m\nillum 1\nmap_Kd gone.png\n";
    const TemporaryFolder folder;
    folder.write("a.mtl", mtl);
    const std::string path =
        folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1 4/1\n");
    const Reading refused = read_path(path);
    EXPECT_FALSE(refused.scene);
    EXPECT_NE(refused.all().find("a.mtl:3:1: error"), std::string::npos) << refused.all();
    ImportOptions options;
    options.magenta_textures = true;
    ImportReport report;
    Diagnostics diagnostics;
    auto scene = import_scene(path, options, report, diagnostics);
    ASSERT_TRUE(scene);
    scene->background = {scene::Rgb(1.0), scene::Rgb(1.0), scene::Rgb(1.0)};
    scene->settings.rgb = true;
    const Film film = film_of(*scene, 9, 9, 16);
    const glm::vec3 middle = film.radiance.at(40);
    EXPECT_GT(middle.x, 0.9f);
    EXPECT_LT(middle.y, 0.1f);
    EXPECT_GT(middle.z, 0.9f);
}

TEST(Mtl, OddTextIsToldOf) {
    const Obj obj = read_obj_with("Kd 1 1 1\nnewmtl m\nKd red\nKd 1 2\nfoo 3\nKs spectral a.rfl\nmap_Kd\nnewmtl m\nKd 0 0 0\n");
    const std::string all = obj.all();
    EXPECT_NE(all.find("a.mtl:1:1: warning"), std::string::npos) << all;
    EXPECT_NE(all.find("a.mtl:3:4: warning"), std::string::npos) << all;
    EXPECT_NE(all.find("a.mtl:4:1: warning"), std::string::npos) << all;
    EXPECT_NE(all.find("a.mtl:7:1: warning"), std::string::npos) << all;
    EXPECT_NE(all.find("comes again"), std::string::npos) << all;
    EXPECT_TRUE(obj.tells(Treatment::dropped, "foo"));
    EXPECT_TRUE(obj.tells(Treatment::dropped, "ks spectral"));
}

}  // namespace
}  // namespace lancer
