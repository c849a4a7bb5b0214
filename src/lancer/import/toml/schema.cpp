// JSON Schema (draft 2020-12) of the notation, for editors.
#include <cmath>

#include <nlohmann/json.hpp>

#include "lancer/import/import.h"
#include "lancer/import/toml/colors.h"
#include "lancer/import/toml/notation.h"

namespace lancer {

namespace {

using Json = nlohmann::ordered_json;
using namespace notation;

Json numbers(const Range& range, const char* type) {
    Json schema{{"type", type}};
    if (std::isfinite(range.least)) {
        schema[range.above_least ? "exclusiveMinimum" : "minimum"] = range.least;
    }
    if (std::isfinite(range.most)) {
        schema[range.below_most ? "exclusiveMaximum" : "maximum"] = range.most;
    }
    return schema;
}

Json list(Json items, int count) { return {{"type", "array"}, {"items", std::move(items)}, {"minItems", count}, {"maxItems", count}}; }

Json any_length(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

Json reference(std::string_view definition) { return {{"$ref", "#/$defs/" + std::string(definition)}}; }

Json rgb(const Range& range) { return {{"anyOf", Json::array({reference("color_text"), list(numbers(range, "number"), 3)})}}; }

Json color(const Range& range) {
    return {{"anyOf", Json::array({reference("color_text"), list(numbers(range, "number"), 3), reference("spectrum")})}};
}

Json value_schema(const Key& key) {
    switch (key.kind) {
        case Kind::number:
            return numbers(key.range, "number");
        case Kind::integer:
            return numbers(key.range, "integer");
        case Kind::flag:
            return {{"type", "boolean"}};
        case Kind::text:
        case Kind::file:
            return {{"type", "string"}, {"minLength", 1}};
        case Kind::choices:
            return any_length({{"enum", key.words}});
        case Kind::choice:
            if (key.words.size() == 1) {
                return {{"const", key.words.front()}};
            }
            return {{"enum", key.words}};
        case Kind::vector2:
            return list(numbers(key.range, "number"), 2);
        case Kind::vector3:
        case Kind::direction:
            return list(numbers(key.range, "number"), 3);
        case Kind::size:
            return list(numbers(key.range, "integer"), 2);
        case Kind::rgb:
            return rgb(key.range);
        case Kind::color:
            return color(key.range);
        case Kind::texture:
            return {{"anyOf", Json::array({reference("color_text"), list(numbers(key.range, "number"), 3), reference("spectrum"),
                                           reference("checker"), reference("image"), reference("vertex_color"), reference("face_color")})}};
        case Kind::value:
            return {{"anyOf", Json::array({numbers(key.range, "number"), reference("texture_value")})}};
        case Kind::refraction:
            return {{"anyOf", Json::array({numbers(key.range, "number"), Json{{"type", "string"}}, reference("abbe_glass"),
                                           reference("sellmeier_glass"), reference("curve")})}};
        case Kind::curve:
            return {{"anyOf", Json::array({numbers(key.range, "number"), Json{{"type", "string"}, {"minLength", 1}}, reference("curve")})}};
        case Kind::index:
            return {{"anyOf", Json::array({numbers(key.range, "number"), Json{{"type", "string"}, {"minLength", 1}}, reference("curve"),
                                           list(numbers(key.range, "number"), 3)})}};
        case Kind::material:
            return {{"anyOf", Json::array({Json{{"type", "string"}}, reference("material")})}};
        case Kind::grid:
            return reference("grid");
        case Kind::rotation:
            return {{"anyOf", Json::array({list(numbers(key.range, "number"), 3), reference("axis_rotation")})}};
        case Kind::matrix:
            return list(numbers(key.range, "number"), 12);
        case Kind::texts:
            return {{"type", "object"}, {"additionalProperties", Json{{"type", "string"}}}};
        case Kind::scale:
            return {{"anyOf", Json::array({numbers(key.range, "number"), list(numbers(key.range, "number"), 3)})}};
        case Kind::vectors3:
            return any_length(list(numbers(key.range, "number"), 3));
        case Kind::vectors2:
            return any_length(list(numbers(key.range, "number"), 2));
        case Kind::numbers:
            return any_length(numbers(key.range, "number"));
        case Kind::triangles:
            return any_length(list(numbers(key.range, "integer"), 3));
    }
    return {};
}

Json default_value(const Default& preset) {
    struct Visitor {
        Json operator()(std::monostate) const { return nullptr; }
        Json operator()(bool flag) const { return flag; }
        Json operator()(double number) const {
            return number == std::floor(number) && std::abs(number) < 1e9 ? Json(static_cast<long long>(number)) : Json(number);
        }
        Json operator()(std::string_view word) const { return word; }
        Json operator()(const glm::dvec2& v) const { return Json::array({(*this)(v.x), (*this)(v.y)}); }
        Json operator()(const glm::dvec3& v) const { return Json::array({(*this)(v.x), (*this)(v.y), (*this)(v.z)}); }
    };
    return std::visit(Visitor{}, preset);
}

Json table_schema(const Table& table) {
    Json properties = Json::object();
    Json required = Json::array();
    for (const Key& key : table.keys) {
        Json& property = properties[std::string(key.name)];
        property = value_schema(key);
        property["description"] = std::string(key.help) + (key.unit.empty() ? "" : " Unit: " + std::string(key.unit) + ".");
        if (!std::holds_alternative<std::monostate>(key.preset)) {
            property["default"] = default_value(key.preset);
        }
        if (key.required) {
            required.push_back(key.name);
        }
    }
    Json schema{{"type", "object"}, {"description", table.help}, {"properties", std::move(properties)}};
    if (!required.empty()) {
        schema["required"] = std::move(required);
    }
    schema["additionalProperties"] = false;
    return schema;
}

Json section_schema(const Section& section) {
    const Table& first = *section.tables.front();
    switch (section.form) {
        case Form::single:
            return reference(first.name);
        case Form::list: {
            Json items = Json::array();
            for (const Table* table : section.tables) {
                items.push_back(reference(section.tables.size() > 1 ? std::string(table->name) + "_light" : std::string(table->name)));
            }
            return any_length(items.size() > 1 ? Json{{"anyOf", items}} : items.front());
        }
        case Form::named:
            return {{"type", "object"}, {"additionalProperties", reference(section.name)}};
        case Form::camera:
            return reference("camera");
        case Form::color:
            return {{"anyOf", Json::array({color(first.find("color")->range), reference(first.name)})}};
    }
    return {};
}

Json definitions() {
    Json all;
    all["color_text"] = {{"anyOf", Json::array({Json{{"type", "string"}, {"pattern", "^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$"}},
                                                Json{{"enum", color_names()}}})},
                         {"description", "A color in sRGB: \"#rrggbb\" or a name."}};
    all["checker"] = table_schema(checker());
    all["image"] = table_schema(image());
    all["spectrum"] = table_schema(spectrum());
    all["curve"] = table_schema(curve());
    all["vertex_color"] = table_schema(vertex_color());
    all["face_color"] = table_schema(face_color());
    all["texture_value"] = table_schema(texture_value());
    all["medium"] = table_schema(medium());
    all["grid"] = table_schema(grid());
    all["abbe_glass"] = table_schema(abbe_glass());
    all["sellmeier_glass"] = table_schema(sellmeier_glass());
    all["axis_rotation"] = table_schema(axis_rotation());
    all["material"]["anyOf"] = Json::array();
    for (const Table* table : materials()) {
        const std::string name = std::string(table->name) + "_material";
        all[name] = table_schema(*table);
        all["material"]["anyOf"].push_back(reference(name));
    }
    for (const Table* table : lights()) {
        all[std::string(table->name) + "_light"] = table_schema(*table);
    }
    for (const Table* table : shapes()) {
        all[std::string(table->name)] = table_schema(*table);
    }
    for (const Table* table : {&place(), &include(), &background(), &clear_sky(), &ambient(), &render()}) {
        all[std::string(table->name)] = table_schema(*table);
    }

    all["named_camera"] = table_schema(camera());
    all["camera"] = table_schema(camera());
    all["camera"]["additionalProperties"] = reference("named_camera");

    Json group_schema = table_schema(group());
    for (const Section& section : group_sections()) {
        group_schema["properties"][std::string(section.name)] = section_schema(section);
    }
    all["group"] = std::move(group_schema);
    return all;
}

}  // namespace

std::string toml_schema() {
    Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                {"title", "lancer scene"},
                {"description", "A scene for the lancer ray tracer, in TOML. Lengths in metres, angles in degrees."},
                {"type", "object"}};
    for (const Section& section : file_sections()) {
        schema["properties"][std::string(section.name)] = section_schema(section);
    }
    schema["additionalProperties"] = false;
    schema["$defs"] = definitions();
    return schema.dump(2) + "\n";
}

}  // namespace lancer
