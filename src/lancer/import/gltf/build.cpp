#include "lancer/import/gltf/build.h"

#include <cmath>
#include <map>

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>

#include "lancer/import/gltf/animation.h"
#include "lancer/import/gltf/check.h"
#include "lancer/import/gltf/lights.h"
#include "lancer/import/gltf/materials.h"

namespace lancer::gltf {

namespace {

class Builder {
public:
    Builder(Document& document, ImportContext& context, scene::Scene& scene)
        : document_(document), options_(context.options), scene_(scene), buffers_(document, context.files), accessors_(document, buffers_),
          nodes_(document), textures_(document, buffers_, context.files), materials_(document, textures_, context.options, scene) {}

    void build() {
        if (document_.has_errors()) {
            return;
        }
        check(document_, accessors_, nodes_);
        animate(document_, accessors_, nodes_, options_.frame);
        if (document_.has_errors()) {
            return;
        }
        nodes_.place();
        for (const int index : nodes_.of_scene(chosen_scene())) {
            const Node& node = nodes_.list()[static_cast<std::size_t>(index)];
            add_camera(document_, node, scene_);
            add_light(document_, node, scene_);
            add_mesh(node);
        }
    }

private:
    // By the name or number that the user gave; else the file's default, else its first.
    Json chosen_scene() {
        const std::vector<Json>& scenes = document_.items("scenes");
        if (options_.scene.empty()) {
            const Json standard = document_.item("scenes", document_.root(), "scene");
            return standard ? standard : scenes.empty() ? Json() : scenes.front();
        }
        std::vector<std::string> names;
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            if (scenes[i].text("name") == options_.scene || fmt::format("{}", i) == options_.scene) {
                return scenes[i];
            }
            names.emplace_back(scenes[i].text("name"));
        }
        document_.error(document_.root()["scenes"],
                        fmt::format("there is no scene \"{}\"{}", options_.scene, did_you_mean(options_.scene, names)));
        return {};
    }

    void add_mesh(const Node& node) {
        const Json mesh = document_.item("meshes", node.json, "mesh");
        if (!mesh) {
            return;
        }
        Pose pose;
        pose.weights = node.weights;
        if (pose.weights.empty()) {
            for (const double weight : mesh.numbers("weights")) {
                pose.weights.push_back(static_cast<float>(weight));
            }
        }
        const Json skin = document_.item("skins", node.json, "skin");
        if (skin) {
            pose.joints = joints_of(document_, accessors_, nodes_, skin);
            document_.honoured("skin", skin);
        }
        // Where a skinned mesh is, its joints say alone.
        const glm::dmat4 to_world = skin ? glm::dmat4(1.0) : node.to_world;
        for (const Json primitive : mesh["primitives"]) {
            if (mode_of(primitive) < Mode::triangles) {
                document_.dropped("points and lines", "they have no area that light could fall on", primitive);
                continue;
            }
            Wishes wishes;
            const int material = materials_.of(primitive, wishes);
            if (const auto triangles = triangles_of(primitive, pose, wishes)) {
                scene::Mesh shape;
                shape.data = triangles;
                place(node,
                      {std::string(node.json.text("name", mesh.text("name"))), shape, material, to_world, document_.position(primitive)});
            }
            if (document_.has_errors()) {
                return;
            }
        }
    }

    // Meshes in the same pose share their triangles.
    std::shared_ptr<const scene::TriangleMesh> triangles_of(Json primitive, const Pose& pose, const Wishes& wishes) {
        if (!pose.joints.empty()) {
            return make_triangles(document_, accessors_, primitive, pose, wishes);
        }
        const auto [known, is_new] = made_.try_emplace({primitive.index(), pose.weights, wishes.uv_sets, wishes.tangents}, nullptr);
        if (is_new) {
            known->second = make_triangles(document_, accessors_, primitive, pose, wishes);
        }
        return known->second;
    }

    void place(const Node& node, scene::Object object) {
        const Json instancing = document_.extension(node.json, "EXT_mesh_gpu_instancing");
        if (!instancing) {
            scene_.objects.push_back(std::move(object));
            return;
        }
        const std::vector<glm::dmat4> places = instances(instancing);
        const glm::dmat4 to_world = object.to_parent;
        const SourcePosition position = object.position;
        object.to_parent = glm::dmat4(1.0);
        scene::Group group;
        group.name = object.name;
        group.objects.push_back(std::move(object));
        const int number = static_cast<int>(scene_.groups.size());
        scene_.groups.push_back(std::move(group));
        for (const glm::dmat4& place : places) {
            scene_.placements.push_back({number, to_world * place, std::nullopt, position});
        }
        document_.honoured("EXT_mesh_gpu_instancing", instancing);
    }

    std::vector<glm::dmat4> instances(Json instancing) {
        const Json names = instancing["attributes"];
        std::size_t count = 0;
        bool is_first = true;
        const auto read = [&](const char* name, std::size_t components) -> std::vector<float> {
            if (!names[name]) {
                return {};
            }
            const auto accessor = accessors_.open(document_.item("accessors", names, name));
            if (!accessor || accessor->components != components || (!is_first && accessor->count != count)) {
                document_.error(names[name], fmt::format("expected {} numbers for each instance", components));
                return {};
            }
            count = accessor->count;
            is_first = false;
            return accessors_.floats(*accessor).value_or(std::vector<float>());
        };
        const std::vector<float> t = read("TRANSLATION", 3), r = read("ROTATION", 4), s = read("SCALE", 3);
        if (document_.has_errors()) {
            return {};
        }
        std::vector<glm::dmat4> places(count, glm::dmat4(1.0));
        for (std::size_t i = 0; i < count; ++i) {
            const auto number = [](const std::vector<float>& list, std::size_t at) { return static_cast<double>(list[at]); };
            glm::dmat4& place = places[i];
            if (!t.empty()) {
                place = glm::translate(place, {number(t, 3 * i), number(t, 3 * i + 1), number(t, 3 * i + 2)});
            }
            if (!r.empty()) {
                const glm::dquat q(number(r, 4 * i + 3), number(r, 4 * i), number(r, 4 * i + 1), number(r, 4 * i + 2));
                place *= glm::length(q) > 0.0 ? glm::mat4_cast(glm::normalize(q)) : glm::dmat4(1.0);
            }
            if (!s.empty()) {
                place = glm::scale(place, {number(s, 3 * i), number(s, 3 * i + 1), number(s, 3 * i + 2)});
            }
        }
        return places;
    }

    Document& document_;
    const ImportOptions& options_;
    scene::Scene& scene_;
    Buffers buffers_;
    Accessors accessors_;
    Nodes nodes_;
    Textures textures_;
    Materials materials_;
    std::map<std::tuple<std::uint32_t, std::vector<float>, std::vector<std::size_t>, bool>, std::shared_ptr<const scene::TriangleMesh>>
        made_;
};

}  // namespace

void build(Document& document, ImportContext& context, scene::Scene& scene) { Builder(document, context, scene).build(); }

}  // namespace lancer::gltf
