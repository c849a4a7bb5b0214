#include <cmath>
#include <set>

#include <fmt/format.h>

#include "lancer/import/gltf/document.h"
#include "lancer/import/gltf/schema.h"

namespace lancer::gltf {

namespace {

class SchemaCheck {
public:
    explicit SchemaCheck(Document& document) : document_(document) {}

    void check_object(Json object, const Schema& schema) {
        std::set<std::string_view> seen;
        for (const Json member : object) {
            const std::string_view key = member.value().key;
            if (!seen.insert(key).second) {
                document_.warning(member, "the name stands twice in its object; the first counts");
            } else if (key == "extensions") {
                check_extensions(member, schema);
            } else if (key != "extras") {
                const Property* property = find(schema, key);
                if (property == nullptr) {
                    document_.warning(member, "glTF knows no such property here");
                } else {
                    check_value(member, *property);
                }
            }
        }
        for (const Property& property : schema.properties) {
            if (property.required && !object[property.name]) {
                document_.error(object, fmt::format("\"{}\" is missing", property.name));
            }
        }
    }

private:
    static const Property* find(const Schema& schema, std::string_view name) {
        for (const Property& property : schema.properties) {
            if (property.name == name) {
                return &property;
            }
        }
        return nullptr;
    }

    void check_extensions(Json extensions, const Schema& schema) {
        if (!expect(extensions, JsonKind::object, "an object of extensions")) {
            return;
        }
        for (const Json extension : extensions) {
            const std::string_view name = extension.value().key;
            if (!is_used(name)) {
                document_.warning(extension, fmt::format("{} is not listed in extensionsUsed", name));
            }
            const Schema* known = find_schema(fmt::format("{}/{}", schema.name, name));
            if (known == nullptr) {
                if (is_known_extension(name)) {
                    document_.warning(extension, fmt::format("{} does not belong here", name));
                }
            } else if (expect(extension, JsonKind::object, "an object")) {
                check_object(extension, *known);
            }
        }
    }

    bool is_used(std::string_view name) const {
        for (const Json used : document_.root()["extensionsUsed"]) {
            if (used.value().text == name) {
                return true;
            }
        }
        return false;
    }

    bool expect(Json value, JsonKind kind, std::string_view words) {
        if (!value.is(kind)) {
            document_.error(value, fmt::format("expected {}", words));
        }
        return value.is(kind);
    }

    void check_value(Json value, const Property& property) {
        switch (property.type) {
            case Type::any:
                break;
            case Type::boolean:
                expect(value, JsonKind::boolean, "true or false");
                break;
            case Type::integer:
            case Type::number:
                check_number(value, property);
                break;
            case Type::text:
                if (expect(value, JsonKind::string, "a string") && !is_allowed(value.value().text, property)) {
                    document_.warning(value, fmt::format("\"{}\": expected one of {}", value.value().text.substr(0, 80), property.allowed));
                }
                break;
            case Type::object:
                if (expect(value, JsonKind::object, "an object")) {
                    check_object(value, *find_schema(property.of));
                }
                break;
            case Type::index:
                check_index(value, property.of);
                break;
            case Type::index_map:
                check_map(value, property.of);
                break;
            default:
                check_array(value, property);
        }
    }

    void check_number(Json value, const Property& property) {
        if (!expect(value, JsonKind::number, property.type == Type::integer ? "a whole number" : "a number")) {
            return;
        }
        const double number = value.value().number;
        if (property.type == Type::integer && number != std::floor(number)) {
            document_.error(value, fmt::format("{}: expected a whole number", number));
        } else if (!property.allowed.empty() && !is_allowed(fmt::format("{}", number), property)) {
            document_.error(value, fmt::format("{}: expected one of {}", number, property.allowed));
        } else if (number < property.low || number > property.high) {
            const std::string words = property.high == unbounded
                                          ? fmt::format("{}: expected {} or more", number, property.low)
                                          : fmt::format("{}: expected {} to {}", number, property.low, property.high);
            // What is a measure can be moved into its range; what counts bytes can't.
            if (property.type == Type::integer && property.name != "byteStride") {
                document_.error(value, words);
            } else {
                document_.warning(value, words);
            }
        }
    }

    static bool is_allowed(std::string_view text, const Property& property) {
        return property.allowed.empty() || fmt::format(" {} ", property.allowed).find(fmt::format(" {} ", text)) != std::string::npos;
    }

    void check_index(Json value, std::string_view array) {
        if (!value.is(JsonKind::number) || value.value().number < 0.0 || value.value().number != std::floor(value.value().number)) {
            document_.error(value, "expected an index: a whole number from 0");
        } else if (!array.empty() && value.value().number >= static_cast<double>(document_.items(array).size())) {
            document_.error(value, fmt::format("{}: the file has {} {}", value.value().number, document_.items(array).size(), array));
        }
    }

    void check_map(Json value, std::string_view array) {
        if (expect(value, JsonKind::object, "an object of indices")) {
            if (value.size() == 0) {
                document_.warning(value, "the object is empty");
            }
            for (const Json item : value) {
                check_index(item, array);
            }
        }
    }

    void check_array(Json list, const Property& property) {
        if (!expect(list, JsonKind::array, "an array")) {
            return;
        }
        if (list.size() == 0) {
            document_.warning(list, "the array is empty");
        } else if (list.size() < property.fewest || list.size() > property.most) {
            document_.error(list, property.fewest == property.most
                                      ? fmt::format("{} values: expected {}", list.size(), property.fewest)
                                      : fmt::format("{} values: expected {} to {}", list.size(), property.fewest, property.most));
        }
        std::set<double> numbers;
        std::set<std::string_view> texts;
        const Schema* schema = property.type == Type::objects ? find_schema(property.of) : nullptr;
        for (const Json item : list) {
            if (property.type == Type::numbers) {
                check_number(item, {property.name, Type::number, {}, false, property.low, property.high});
            } else if (property.type == Type::indices) {
                check_index(item, property.of);
                if (!numbers.insert(item.value().number).second) {
                    document_.error(item, "the same index stands here twice");
                }
            } else if (property.type == Type::texts) {
                if (expect(item, JsonKind::string, "a string") && !texts.insert(item.value().text).second) {
                    document_.warning(item, "the same name stands here twice");
                }
            } else if (property.type == Type::index_maps) {
                check_map(item, property.of);
            } else if (expect(item, JsonKind::object, "an object")) {
                check_object(item, *schema);
            }
        }
    }

    Document& document_;
};

}  // namespace

void check_schema(Document& document) { SchemaCheck(document).check_object(document.root(), *find_schema("gltf")); }

}  // namespace lancer::gltf
