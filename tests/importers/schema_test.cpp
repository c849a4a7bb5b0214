// The JSON Schema says the same as the reader: it lists every key, takes what the reader takes, and refuses wrong keys, types and ranges.
#define TOML_HEADER_ONLY 0
#define TOML_SHARED_LIB 1
#include <toml++/toml.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <sstream>

#include "lancer/import/toml/notation.h"
#include "reading.h"

namespace lancer {
namespace {

using namespace lancer::testing;
using Json = nlohmann::json;

const Json& schema() {
    static const Json parsed = Json::parse(toml_schema());
    return parsed;
}

// The words of JSON Schema 2020-12 that ours uses; an unknown one fails the test.
class Validator {
public:
    bool holds(const Json& s, const Json& value) {
        for (const auto& [word, rule] : s.items()) {
            if (!holds_word(s, word, rule, value)) {
                return false;
            }
        }
        return true;
    }

private:
    static bool is_type(const std::string& type, const Json& value) {
        return type == "object"    ? value.is_object()
               : type == "array"   ? value.is_array()
               : type == "string"  ? value.is_string()
               : type == "boolean" ? value.is_boolean()
               : type == "integer" ? value.is_number_integer()
               : type == "number"  ? value.is_number()
                                   : false;
    }

    static bool is_hexadecimal_color(const std::string& text) {
        return (text.size() == 4 || text.size() == 7) && text[0] == '#' &&
               text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    }

    bool holds_word(const Json& s, const std::string& word, const Json& rule, const Json& value) {
        if (word == "$schema" || word == "title" || word == "description" || word == "$defs" || word == "default") {
            return true;
        }
        if (word == "type") {
            return is_type(rule, value);
        }
        if (word == "const") {
            return value == rule;
        }
        if (word == "enum") {
            return std::find(rule.begin(), rule.end(), value) != rule.end();
        }
        if (word == "anyOf") {
            return std::any_of(rule.begin(), rule.end(), [&](const Json& one) { return holds(one, value); });
        }
        if (word == "$ref") {
            return holds(schema().at(Json::json_pointer(rule.get<std::string>().substr(1))), value);
        }
        if (word == "pattern") {
            EXPECT_EQ(rule, "^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$") << "the only one that this test knows";
            return !value.is_string() || is_hexadecimal_color(value);
        }
        if (word == "minLength") {
            return !value.is_string() || value.get<std::string>().size() >= rule;
        }
        if (word == "items") {
            return !value.is_array() || std::all_of(value.begin(), value.end(), [&](const Json& one) { return holds(rule, one); });
        }
        if (word == "minItems" || word == "maxItems") {
            return !value.is_array() || (word == "minItems" ? value.size() >= rule : value.size() <= rule);
        }
        if (word == "minimum" || word == "maximum" || word == "exclusiveMinimum" || word == "exclusiveMaximum") {
            return !value.is_number() || (word == "minimum"            ? value >= rule
                                          : word == "maximum"          ? value <= rule
                                          : word == "exclusiveMinimum" ? value > rule
                                                                       : value < rule);
        }
        if (word == "required") {
            return !value.is_object() || std::all_of(rule.begin(), rule.end(), [&](const Json& key) { return value.contains(key); });
        }
        if (word == "properties" || word == "additionalProperties") {
            return !value.is_object() || holds_properties(s, word, rule, value);
        }
        ADD_FAILURE() << "unknown word " << word;
        return false;
    }

    bool holds_properties(const Json& s, const std::string& word, const Json& rule, const Json& value) {
        for (const auto& [key, one] : value.items()) {
            if (word == "properties") {
                if (rule.contains(key) && !holds(rule.at(key), one)) {
                    return false;
                }
            } else if (!s.contains("properties") || !s.at("properties").contains(key)) {
                if (rule.is_boolean() ? !rule.get<bool>() : !holds(rule, one)) {
                    return false;
                }
            }
        }
        return true;
    }
};

Json to_json(const std::string& text) {
    std::ostringstream out;
    out << toml::json_formatter(toml::parse(std::string_view(text)));
    return Json::parse(out.str());
}

bool schema_takes(const std::string& text) { return Validator().holds(schema(), to_json(text)); }

TEST(Schema, NamesItsDialect) { EXPECT_EQ(schema().at("$schema"), "https://json-schema.org/draft/2020-12/schema"); }

TEST(Schema, ListsEveryKeyWithHelp) {
    using namespace notation;
    const Json& all = schema().at("$defs");
    const auto check = [&](const Table& table, const std::string& definition) {
        const Json& properties = all.at(definition).at("properties");
        for (const Key& key : table.keys) {
            ASSERT_TRUE(properties.contains(key.name)) << definition << "." << key.name;
            EXPECT_GT(properties.at(std::string(key.name)).at("description").get<std::string>().size(), 4u)
                << definition << "." << key.name;
        }
    };
    for (const Table* table : shapes()) {
        check(*table, std::string(table->name));
    }
    for (const Table* table : lights()) {
        check(*table, std::string(table->name) + "_light");
    }
    for (const Table* table : materials()) {
        check(*table, std::string(table->name) + "_material");
    }
    for (const Table* table :
         {&camera(), &checker(), &image(), &place(), &include(), &group(), &background(), &clear_sky(), &ambient(), &render()}) {
        check(*table, std::string(table->name));
    }
    check(abbe_glass(), "abbe_glass");
    check(sellmeier_glass(), "sellmeier_glass");
    check(axis_rotation(), "axis_rotation");
    for (const Section& section : file_sections()) {
        EXPECT_TRUE(schema().at("properties").contains(section.name)) << section.name;
    }
    for (const Section& section : group_sections()) {
        EXPECT_TRUE(all.at("group").at("properties").contains(section.name)) << section.name;
    }
}

TEST(Schema, EveryReferenceLeadsSomewhere) {
    const std::function<void(const Json&)> follow = [&](const Json& part) {
        if (part.is_object() && part.contains("$ref")) {
            EXPECT_TRUE(schema().contains(Json::json_pointer(part.at("$ref").get<std::string>().substr(1)))) << part;
        }
        if (part.is_structured()) {
            for (const Json& inner : part) {
                follow(inner);
            }
        }
    };
    follow(schema());
}

// What no schema can say, such as names that must exist, is left out here.
TEST(Schema, TakesWhatTheReaderTakes) {
    const std::string everything = R"(
ambient = [0.5, 0.25, 0.125]
[camera]
position = [0, 0, 9]
direction = [0, 0, -2]
up = [1, 1, 0]
fov = 30
fov_axis = "height"
[camera.zoom]
fov = 10.5
[background]
zenith = "#01f"
horizon = "white"
[render]
size = [640, 480]
aa = "adaptive"
exposure = -1.5
[material.a]
color = { type = "checker", first = "white", second = [0.1, 0.1, 0.1], size = 0.5, solid = false }
refraction = "N-BK7"
[material.b]
color = "#123456"
refraction = { index = 1.6, abbe_number = 40 }
absorption = [1, 2, 3]
[material.c]
refraction = { b = [1.04, 0.23, 1.01], c = [0.006, 0.02, 103.56] }
[[light]]
type = "point"
position = [0, 1, 2]
[[light]]
type = "spot"
position = [0, 1, 2]
look_at = [0, 0, 0]
angle = 20
[[light]]
type = "directional"
direction = [0, -1, 0]
color = "red"
intensity = 0.5
[[group]]
name = "g"
[[group.sphere]]
material = "a"
[[group.place]]
group = "h"
[[group]]
name = "h"
[[group.cylinder]]
from = [0, 0, 0]
[[place]]
group = "h"
matrix = [1, 0.5, 0, 0, 0, 1, 0, 2, 0, 0, 1, 0]
[[place]]
group = "g"
material = { diffuse = 0.5 }
rotate = { axis = [0, 1, 0], angle = 30 }
scale = [1, 2, 3]
[[sphere]]
material = "b"
scale = 2
[[box]]
material = "c"
[[plane]]
rotate = [0, 30, 0]
[[disk]]
[[cone]]
capped = false
[[mesh]]
positions = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
triangles = [[0, 1, 2]]
normals = [[0, 0, 1], [0, 0, 1], [0, 0, 1]]
uvs = [[0, 0], [1, 0], [0, 1]]
)";
    const Reading reading = read_text(everything);
    EXPECT_TRUE(reading.scene) << reading.all();
    EXPECT_TRUE(schema_takes(everything));
    EXPECT_TRUE(schema_takes("background = 'red'\n[ambient]\ncolor = 'blue'\n"));
}

TEST(Schema, TakesEverySceneOfTheProject) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() / "scenes")) {
        if (entry.path().extension() == ".toml") {
            std::ifstream file(entry.path());
            EXPECT_TRUE(schema_takes(std::string{std::istreambuf_iterator<char>(file), {}})) << entry.path();
        }
    }
}

TEST(Schema, RefusesWhatTheReaderRefuses) {
    for (const char* text : {"[[spere]]\n",
                             "[[sphere]]\nradus = 1\n",
                             "[[sphere]]\nradius = 0\n",
                             "[[sphere]]\nradius = 'x'\n",
                             "[[sphere]]\ncenter = [0, 0]\n",
                             "[sphere]\n",
                             "[camera]\nfov = 180\n",
                             "[camera.a]\nfoov = 1\n",
                             "[camera]\nfov_axis = 'x'\n",
                             "[[light]]\ntype = 'pont'\n",
                             "[[light]]\ntype = 'point'\n",
                             "[[light]]\ntype = 'point'\nposition = [0, 0, 0]\nangle = 3\n",
                             "[material.m]\ntype = 'phong'\n",
                             "[material.m]\ncolor = '#12345'\n",
                             "[material.m]\ncolor = 'redd'\n",
                             "[material.m]\ndiffuse = 2\n",
                             "[material.m]\nrefraction = true\n",
                             "[material.m]\nrefraction = { index = 1.5 }\n",
                             "[material.m]\ncolor = { type = 'image' }\n",
                             "[render]\nsize = [0, 1]\n",
                             "[render]\nsize = [1.5, 1]\n",
                             "[render]\nbounces = -1\n",
                             "[render]\naa = 4\n",
                             "[[group]]\n",
                             "[[group]]\nname = 'a'\n[[group.spher]]\n",
                             "[[place]]\n",
                             "[[include]]\n",
                             "[[include]]\nfile = 'a.toml'\ndefine = ['a']\n",
                             "[[sphere]]\nmatrix = [1, 0, 0]\n",
                             "[[place]]\ngroup = ''\n",
                             "background = 3\n",
                             "ambient = [0, 0, -1]\n",
                             "[[mesh]]\ntriangles = [[0, 1, 0.5]]\n",
                             "[[sphere]]\nrotate = 90\n",
                             "[[sphere]]\nrotate = { axis = [0, 1, 0] }\n",
                             "[[sphere]]\nscale = 'x'\n"}) {
        EXPECT_FALSE(schema_takes(text)) << text;
        EXPECT_FALSE(read_text(text).scene) << text;
    }
}

}  // namespace
}  // namespace lancer
