// The materials of a Wavefront OBJ file, as its .mtl file writes them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/import/reader.h"

namespace lancer::obj {

// A picture with its options.
struct Map {
    std::string file;  // as written, but with slashes
    glm::dvec2 scale{1.0};
    glm::dvec2 offset{0.0};
    double base = 0.0;  // value = base + gain * picture
    double gain = 1.0;
    double bump = 1.0;
    bool clamps = false;
    char channel = 0;  // r, g, b, m, l, z; 0: not written
    SourcePosition position;
};

// One newmtl: its statements by their names, in lower case.
struct MaterialStatements {
    std::string name;
    SourcePosition position;
    std::map<std::string, std::vector<double>> numbers;
    std::map<std::string, Map> maps;

    std::optional<double> number(const char* key) const;
    std::optional<glm::dvec3> color(const char* key) const;  // one number stands for three
    const Map* map(const char* key) const;
};

// Statements that are none become warnings; the first of several materials of a name counts.
std::vector<MaterialStatements> parse_materials(std::string_view bytes, const std::string& file, ImportContext& context);

// A material that follows physics. Pictures are looked for beside `file`, which holds the statements.
scene::Material make_material(const MaterialStatements& statements, const std::string& file, ImportContext& context);

}  // namespace lancer::obj
