// From a scene file and what it includes to one tree.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lancer/import/mitsuba/element.h"
#include "lancer/import/reader.h"

namespace pugi {
class xml_node;
}

namespace lancer::mitsuba {

class Document {
public:
    explicit Document(ImportContext& context);

    // The <scene> with everything that it includes in the place of the includes. Nothing when there are errors. Files that include each other,
    // trees deeper than 100 and scenes of more than 4 million elements are errors.
    std::optional<Element> read();

    // Where a file is that the scene names: in the scene's folder, in those that it names by <path>, beside the file that names it, or, with a warning,
    // in the folders above. When it is nowhere: as if in the scene's folder.
    std::string resolve(const std::string& name, const SourcePosition& named_at) const;

    // Of the scene file itself: 0, 2, 3, ...; 3 when it is not written.
    int major_version() const { return major_version_; }

private:
    std::optional<std::string> find_above(const std::string& name, const SourcePosition& named_at) const;
    bool read_file(const std::string& path, const SourcePosition& named_at, Element& parent);
    void add_children(const class Xml& xml, const pugi::xml_node& node, Element& parent, int depth);
    void set_default(const Element& element);
    void add_folder(const Element& element);
    void include(const Element& element, Element& parent);
    void modernise(Element& element) const;
    std::string substitute(std::string_view text, const SourcePosition& position);
    void fail(const SourcePosition& position, std::string message);

    ImportContext& context_;
    std::map<std::string, std::string> parameters_;
    std::vector<std::string> folders_;  // that <path> named, the last one first
    std::vector<std::string> open_;     // files that are being read, the innermost last
    bool old_ = false;                  // the file being read was written for version 0.x
    std::size_t elements_ = 0;
    int includes_ = 0;
    int major_version_ = 3;
    bool failed_ = false;
};

}  // namespace lancer::mitsuba
