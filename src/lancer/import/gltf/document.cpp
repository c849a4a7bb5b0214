#include "lancer/import/gltf/document.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "lancer/import/gltf/schema.h"

namespace lancer::gltf {

namespace {

constexpr int most_messages = 100;

// Extensions without properties of their own.
constexpr std::string_view silent_extensions[] = {"KHR_mesh_quantization"};

}  // namespace

bool is_known_extension(std::string_view name) {
    const std::span<const Schema> schemas = extension_schemas();
    return std::any_of(schemas.begin(), schemas.end(),
                       [&](const Schema& schema) {
                           const std::size_t slash = schema.name.find('/');
                           return slash != std::string_view::npos && schema.name.substr(slash + 1) == name;
                       }) ||
           std::find(std::begin(silent_extensions), std::end(silent_extensions), name) != std::end(silent_extensions);
}

Document::~Document() {
    if (said_ > most_messages) {
        diagnostics_.note({path_}, fmt::format("{} more messages about this file are left out", said_ - most_messages));
    }
}

bool Document::load(FileBytes bytes) {
    bytes_ = std::move(bytes);
    std::string_view json;
    if (!open_container(json)) {
        return false;
    }
    if (json.substr(0, 3) == "\xEF\xBB\xBF") {
        warning_at(json_begin_, "the JSON begins with a byte order mark, which glTF does not allow");
        json.remove_prefix(3);
        json_begin_ += 3;
    }
    JsonProblem problem;
    if (!tree_.parse(json, problem)) {
        error_at(json_begin_ + problem.byte, "this is not JSON: " + problem.message);
        return false;
    }
    if (!root().is(JsonKind::object)) {
        error(root(), "expected an object, the whole of a glTF file");
        return false;
    }
    for (const Json member : root()) {
        if (member.is(JsonKind::array)) {
            std::vector<Json>& list = items_[member.value().key];
            list.clear();
            list.reserve(member.size());
            for (const Json item : member) {
                list.push_back(item);
            }
        }
    }
    check_schema(*this);
    check_extensions();
    const std::string_view version = root()["asset"].text("version");
    const std::string_view needs = root()["asset"].text("minVersion", version);
    if (!version.empty() && (version.substr(0, 2) != "2." || (needs != "2.0" && needs.substr(0, 2) != "2."))) {
        error(root()["asset"]["version"], fmt::format("this is glTF {}: expected version 2.0", version));
    } else if (needs.size() > 2 && needs.substr(0, 2) == "2." && needs != "2.0" && needs > version) {
        error(root()["asset"]["minVersion"], fmt::format("the file needs glTF {}: expected version 2.0", needs));
    }
    return !has_errors();
}

void Document::check_extensions() {
    const Json used = root()["extensionsUsed"];
    const Json required = root()["extensionsRequired"];
    const auto holds = [](Json list, std::string_view name) {
        for (const Json item : list) {
            if (item.value().text == name) {
                return true;
            }
        }
        return false;
    };
    for (const Json name : required) {
        if (name.is(JsonKind::string)) {
            if (!is_known_extension(name.value().text)) {
                error(name, fmt::format("the file requires the extension {}, which lancer does not have", name.value().text));
            } else if (!holds(used, name.value().text)) {
                warning(name, fmt::format("{} is required but not listed in extensionsUsed", name.value().text));
            }
        }
    }
    for (const Json name : used) {
        if (name.is(JsonKind::string) && !is_known_extension(name.value().text) && !holds(required, name.value().text)) {
            dropped(std::string(name.value().text), "lancer does not know this extension", name);
        }
    }
}

const std::vector<Json>& Document::items(std::string_view array) const {
    static const std::vector<Json> none;
    const auto found = items_.find(array);
    return found == items_.end() ? none : found->second;
}

Json Document::item(std::string_view array, Json object, std::string_view property) const {
    const auto index = object.natural(property);
    const std::vector<Json>& list = items(array);
    return index && *index < list.size() ? list[*index] : Json();
}

bool Document::can_say_more() { return ++said_ <= most_messages; }

void Document::error_at(std::uint64_t byte, const std::string& message) {
    ++errors_;
    if (can_say_more() || errors_ == 1) {
        diagnostics_.error(position_of_byte(byte), message);
    }
}

void Document::warning_at(std::uint64_t byte, const std::string& message) {
    if (can_say_more()) {
        diagnostics_.warning(position_of_byte(byte), message);
    }
}

void Document::error(Json at, const std::string& message) {
    const std::string pointer = tree_.pointer_to(at);
    error_at(json_begin_ + (at ? at.value().byte : 0), pointer.empty() ? message : pointer + ": " + message);
}

void Document::warning(Json at, const std::string& message) {
    const std::string pointer = tree_.pointer_to(at);
    warning_at(json_begin_ + (at ? at.value().byte : 0), pointer.empty() ? message : pointer + ": " + message);
}

SourcePosition Document::position(Json at) const { return at ? position_of_byte(json_begin_ + at.value().byte) : SourcePosition{path_}; }

SourcePosition Document::position_of_byte(std::uint64_t byte) const {
    SourcePosition position{path_};
    if (is_binary_) {
        position.byte = static_cast<std::int64_t>(byte);
        return position;
    }
    const std::string_view text = bytes_.view();
    if (line_begins_.empty()) {
        line_begins_.push_back(0);
        for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) {
            line_begins_.push_back(at + 1);
        }
    }
    const auto line = std::upper_bound(line_begins_.begin(), line_begins_.end(), byte) - 1;
    constexpr std::uint64_t most = 1u << 30;
    position.line = static_cast<int>(std::min<std::uint64_t>(static_cast<std::uint64_t>(line - line_begins_.begin()) + 1, most));
    position.column = static_cast<int>(std::min(byte - *line + 1, most));
    return position;
}

}  // namespace lancer::gltf
