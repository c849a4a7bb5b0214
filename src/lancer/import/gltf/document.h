// A glTF file in memory: its JSON, its arrays by index, and the binary chunk of a .glb.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/base/diagnostic.h"
#include "lancer/base/file.h"
#include "lancer/import/gltf/json.h"
#include "lancer/import/report.h"

namespace lancer::gltf {

class Document {
public:
    // `diagnostics` and `report` must outlive the document. Of more than 100 messages, the rest is only counted.
    Document(std::string path, Diagnostics& diagnostics, ImportReport& report)
        : path_(std::move(path)), diagnostics_(diagnostics), report_(report) {}
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;
    ~Document();

    // Takes the file apart, parses its JSON, holds it against the schema and looks for extensions that it can't do without and we lack. False when
    // there were errors.
    bool load(FileBytes bytes);

    const std::string& path() const { return path_; }
    Json root() const { return tree_.root(); }

    // The items of one of the file's arrays, such as "nodes"; none where the file has no such array.
    const std::vector<Json>& items(std::string_view array) const;

    // The item that a property such as "mesh" of a node names; nothing where the object lacks the property.
    Json item(std::string_view array, Json object, std::string_view property) const;

    Json extension(Json object, std::string_view name) const { return object["extensions"][name]; }

    // The second chunk of a .glb; null where there is none.
    const std::string_view* binary() const { return has_binary_ ? &binary_ : nullptr; }
    std::string_view bytes() const { return bytes_.view(); }

    void error(Json at, const std::string& message);
    void warning(Json at, const std::string& message);
    SourcePosition position(Json at) const;

    void animation(AnimationFacts facts) { report_.animation(std::move(facts)); }
    void honoured(const std::string& feature, Json at) { report_.honoured(feature, position(at)); }
    void approximated(const std::string& feature, const std::string& how, Json at) { report_.approximated(feature, how, position(at)); }
    void dropped(const std::string& feature, const std::string& why, Json at, bool changes_picture = true) {
        report_.dropped(feature, why, position(at), changes_picture);
    }

    bool has_errors() const { return errors_ > 0; }
    Diagnostics& diagnostics() { return diagnostics_; }

private:
    bool open_container(std::string_view& json);
    void error_at(std::uint64_t byte, const std::string& message);
    void warning_at(std::uint64_t byte, const std::string& message);
    SourcePosition position_of_byte(std::uint64_t byte) const;
    bool can_say_more();
    void check_extensions();

    std::string path_;
    Diagnostics& diagnostics_;
    ImportReport& report_;
    FileBytes bytes_;
    JsonTree tree_;
    std::uint64_t json_begin_ = 0;  // in the file
    bool is_binary_ = false;
    bool has_binary_ = false;
    std::string_view binary_;
    std::map<std::string_view, std::vector<Json>> items_;
    mutable std::vector<std::uint64_t> line_begins_;
    int errors_ = 0;
    int said_ = 0;
};

// Holds the whole file against the schema: unknown names and values that can be passed over are warnings, what can't be is an error.
void check_schema(Document& document);

// Whether the extension is one of those that we read.
bool is_known_extension(std::string_view name);

}  // namespace lancer::gltf
