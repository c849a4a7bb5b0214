#include "lancer/import/toml/includes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "lancer/base/file.h"
#include "lancer/base/overloaded.h"
#include "lancer/import/toml/contents.h"
#include "lancer/import/toml/transforms.h"

namespace lancer::notation {

namespace {

constexpr std::uint64_t many = std::uint64_t{1} << 40;  // enough objects to be refused

glm::dvec3 turned(const glm::dmat4& map, const glm::dvec3& direction) {
    return unit_vector(glm::dmat3(map) * direction).value_or(direction);
}

glm::dvec3 moved(const glm::dmat4& map, const glm::dvec3& point) { return glm::dvec3(map * glm::dvec4(point, 1.0)); }

// Its strength stays, whatever the scale.
void place(scene::Light& light, const glm::dmat4& map) {
    std::visit(Overloaded{[&](scene::PointLight& point) { point.position = moved(map, point.position); },
                          [&](scene::SpotLight& spot) {
                              spot.position = moved(map, spot.position);
                              spot.direction = turned(map, spot.direction);
                              spot.up = turned(map, spot.up);
                          },
                          [&](scene::DirectionalLight& sun) { sun.direction = turned(map, sun.direction); },
                          [&](scene::ProjectorLight& projector) {
                              projector.position = moved(map, projector.position);
                              projector.direction = turned(map, projector.direction);
                              projector.up = turned(map, projector.up);
                          },
                          [&](scene::GoniometricLight& lamp) {
                              lamp.position = moved(map, lamp.position);
                              lamp.direction = turned(map, lamp.direction);
                              lamp.up = turned(map, lamp.up);
                          },
                          [&](scene::IesLight& lamp) {
                              lamp.position = moved(map, lamp.position);
                              lamp.direction = turned(map, lamp.direction);
                              lamp.forward = turned(map, lamp.forward);
                          }},
               light.model);
}

void place(scene::Camera& camera, const glm::dmat4& map) {
    const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(map))));
    camera.position = moved(map, camera.position);
    camera.direction = turned(map, camera.direction);
    camera.up = turned(map, camera.up);
    camera.focus_distance *= scale;
    camera.aperture *= scale;
    camera.extent *= scale;
}

bool is_black(const scene::Background& background) {
    const scene::Color black;
    return !background.image && !background.sky && background.zenith == black && background.horizon == black && background.nadir == black;
}

class Reading {
public:
    Reading(Context& context, Materials& materials) : context_(context), materials_(materials) {}

    std::optional<Included> read(const toml::table& table) {
        TableReader reader(context_.messages, table, include());
        Included result;
        result.name = reader.text("name");
        result.position = reader.position();
        result.placement.position = reader.position();
        result.placement.to_parent = read_transform(reader);
        const bool lights = reader.flag("lights"), cameras = reader.flag("cameras"), settings = reader.flag("settings");
        ImportOptions options = context_.import.options;
        options.is_part = true;
        options.frame = reader.number_if_written("frame").value_or(options.frame);
        options.scene = reader.text("scene");
        options.variant = reader.text("variant");
        for (const auto& [name, value] : reader.texts("define")) {
            options.defines[name] = value;
        }
        const std::string file = reader.text("file");
        if (!reader.good() || file.empty()) {
            return std::nullopt;
        }
        const std::string path = path_beside(context_.messages.file(), file);
        std::error_code problem;
        if (!std::filesystem::exists(path, problem)) {
            reader.error("file", fmt::format("{}: no such file", path));
            return std::nullopt;
        }
        scene::Scene part;
        ImportContext inside{path, options, context_.files, context_.import.report, context_.messages.diagnostics()};
        read_scene(inside, reader.position("file"), part);
        if (context_.messages.diagnostics().has_errors()) {
            return std::nullopt;
        }
        take_over(part, path, result);
        if (result.name.empty()) {
            take_surroundings(part, lights, cameras, settings, result);
        }
        if (const int material = materials_.read(reader, "material"); material >= 0) {
            result.placement.material = material;
        }
        return result;
    }

private:
    // Materials, groups and shapes.
    void take_over(scene::Scene& part, const std::string& path, Included& result) {
        scene::Scene& whole = context_.scene;
        const std::vector<int> media = adopt_media(part, result);
        for (scene::Material& material : part.materials) {
            if (material.interior) {
                material.interior = media[static_cast<std::size_t>(*material.interior)];
            }
        }
        const std::vector<int> numbers = materials_.adopt(std::move(part.materials));
        const int first_group = static_cast<int>(whole.groups.size());
        const auto renumber = [&](std::vector<scene::Object>& objects, std::vector<scene::Placement>& placements) {
            for (scene::Object& object : objects) {
                object.material = numbers[static_cast<std::size_t>(object.material)];
            }
            for (scene::Placement& placement : placements) {
                placement.group += first_group;
                if (placement.material) {
                    placement.material = numbers[static_cast<std::size_t>(*placement.material)];
                }
            }
        };
        part.groups.push_back({std::filesystem::path(path).stem().string(), std::move(part.objects), std::move(part.placements)});
        struct Size {
            int depth = 1;
            std::uint64_t objects = 0;
        };
        std::vector<Size> sizes;  // a group comes after every group it places
        for (scene::Group& group : part.groups) {
            Size size{1, group.objects.size()};
            for (const scene::Placement& placement : group.placements) {
                const Size& inner = sizes[static_cast<std::size_t>(placement.group)];
                size.depth = std::max(size.depth, inner.depth + 1);
                size.objects = std::min(size.objects + inner.objects + 1, many);
            }
            sizes.push_back(size);
            renumber(group.objects, group.placements);
            whole.groups.push_back(std::move(group));
        }
        result.placement.group = static_cast<int>(whole.groups.size()) - 1;
        result.depth = sizes.back().depth;
        result.objects = sizes.back().objects;
    }

    // The number that each of its media has in this scene. Where this file has one of that name, it is the one that is meant.
    std::vector<int> adopt_media(scene::Scene& part, const Included& result) {
        std::vector<scene::Medium>& all = context_.scene.media;
        std::vector<int> numbers;
        for (scene::Medium& medium : part.media) {
            const auto same = std::find_if(all.begin(), all.end(), [&](const scene::Medium& other) { return other.name == medium.name; });
            if (same != all.end() && same->position.file == context_.messages.file()) {
                numbers.push_back(static_cast<int>(same - all.begin()));
                continue;
            }
            for (std::optional<scene::Grid>* grid : {&medium.density, &medium.albedo, &medium.temperature}) {
                if (*grid) {
                    (*grid)->to_world = result.placement.to_parent * (*grid)->to_world;
                }
            }
            numbers.push_back(static_cast<int>(all.size()));
            all.push_back(std::move(medium));
        }
        if (part.medium && result.name.empty() && !context_.scene.medium) {
            context_.scene.medium = numbers[static_cast<std::size_t>(*part.medium)];
        }
        return numbers;
    }

    void take_surroundings(scene::Scene& part, bool lights, bool cameras, bool settings, Included& result) {
        const glm::dmat4& map = result.placement.to_parent;
        const bool stays = map == glm::dmat4(1.0);
        if (lights) {
            result.lights = std::move(part.lights);
            if (!is_black(part.background)) {
                result.background = std::move(part.background);
            }
            if (part.ambient != scene::Color(scene::Rgb(1.0))) {
                result.ambient = part.ambient;
            }
        }
        if (cameras) {
            result.cameras = std::move(part.cameras);
        }
        if (settings) {
            result.settings = std::move(part.settings);
        }
        if (stays) {
            return;
        }
        for (scene::Light& light : result.lights) {
            place(light, map);
        }
        for (scene::Camera& camera : result.cameras) {
            place(camera, map);
        }
        if (result.background) {
            turn(*result.background, map, result.position);
        }
    }

    void turn(scene::Background& background, const glm::dmat4& map, const SourcePosition& position) {
        const glm::dmat3 all(map);
        const double scale = std::cbrt(std::abs(glm::determinant(all)));
        const glm::dmat3 rotation = all / scale;
        const glm::dmat3 square = glm::transpose(rotation) * rotation;
        double off = 0.0;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                off = std::max(off, std::abs(square[i][j] - (i == j ? 1.0 : 0.0)));
            }
        }
        const bool stays_upright = glm::length(rotation[1] - glm::dvec3(0.0, 1.0, 0.0)) < 1e-6;
        if (background.image && off < 1e-6) {
            background.axes = rotation * background.axes;
        } else if (background.sky && off < 1e-6) {
            background.sky->sun = rotation * background.sky->sun;
            background.sky->up = rotation * background.sky->up;
        } else if (background.image || !stays_upright) {
            context_.messages.warning(position, "the surroundings of this file are not turned with it");
        }
    }

    Context& context_;
    Materials& materials_;
};

}  // namespace

std::vector<Included> read_includes(Context& context, Materials& materials, const toml::table& root) {
    std::vector<Included> all;
    for (const toml::table* table : tables_of(context.messages, root, include().name)) {
        if (context.messages.diagnostics().has_errors()) {
            break;
        }
        if (auto included = Reading(context, materials).read(*table)) {
            all.push_back(std::move(*included));
        }
    }
    return all;
}

}  // namespace lancer::notation
