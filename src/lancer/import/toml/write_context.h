// What the writers of a scene share, and what each of them writes.
//
// Every struct of a scene is taken apart by a structured binding and every variant by a visit without a rest, so that a new member or a new kind
// does not compile here until somebody has said how it is written: a key in tables.cpp, its reading, and a line in these files.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lancer/base/overloaded.h"
#include "lancer/import/import.h"
#include "lancer/import/toml/toml_text.h"
#include "lancer/scene/scene.h"

namespace lancer::notation {

struct WriteContext {
    const scene::Scene& scene;
    std::filesystem::path folder;  // where the text will stand
    std::string stem;              // its name without its ending; files beside it begin like this
    WrittenScene& result;
    std::vector<std::string> materials;  // their names, each another one
    std::vector<std::string> groups;
    std::vector<std::string> media;
    std::vector<std::shared_ptr<const scene::TriangleMesh>> meshes = {};  // in the order of the mesh file
    std::map<const scene::TriangleMesh*, std::size_t> parts = {};         // their numbers
    std::map<const std::string*, std::string> pictures = {};              // by their bytes, their files
    std::map<const scene::VoxelData*, std::string> voxels = {};           // their files
    std::map<const scene::Photometry*, std::string> photometries = {};    // their files

    const std::string& material(int index) const { return materials[static_cast<std::size_t>(index)]; }
    std::string mesh_file() const { return stem + ".meshes"; }
};

// ---- Colours and textures: texts of values --------------------------------------------------------------------------------------

std::string write_color(const scene::Color& color);
std::string write_curve(const scene::MeasuredSpectrum& curve);
std::string write_texture(WriteContext& context, const scene::Texture& texture);
std::string write_value(WriteContext& context, const scene::Value& value);
std::string write_refraction(const scene::Refraction& refraction);
const char* wrap_word(scene::Wrap wrap);
// The name of a picture's file, seen from the scene's.
std::string write_picture(WriteContext& context, const scene::ImageTexture& image);

// Leave out what equals the preset.
void add_color(Fields& fields, std::string_view key, const scene::Color& color, const scene::Color& preset);
void add_texture(Fields& fields, std::string_view key, WriteContext& context, const scene::Texture& texture, const scene::Color& preset);
void add_value(Fields& fields, std::string_view key, WriteContext& context, const scene::Value& value, double preset);
// `translate`, or `matrix`; nothing where nothing is moved.
void add_transform(Fields& fields, const glm::dmat4& map);

// ---- Sections: tables with their headers ----------------------------------------------------------------------------------------

std::string write_cameras(const std::vector<scene::Camera>& cameras);
std::string write_light(WriteContext& context, const scene::Light& light);
std::string write_background(WriteContext& context, const scene::Background& background);
std::string write_settings(const scene::RenderSettings& settings);
std::string write_medium(WriteContext& context, const scene::Medium& medium, const std::string& name, bool everywhere);
std::string write_material(WriteContext& context, const scene::Material& material, const std::string& name);
// `prefix` is "group." inside of groups.
std::string write_object(WriteContext& context, const scene::Object& object, const std::string& prefix);
std::string write_placement(const WriteContext& context, const scene::Placement& placement, const std::string& prefix);

// Each name another one, none empty and none of `taken`: what is there already gets a number behind it.
std::vector<std::string> distinct_names(const std::vector<std::string>& names, const std::string& for_empty,
                                        const std::vector<std::string>& taken = {});

}  // namespace lancer::notation
