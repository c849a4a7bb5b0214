// What the parts of this reader share: the scene being made, and what has been made of elements that are used more than once.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lancer/import/mitsuba/document.h"
#include "lancer/import/mitsuba/element.h"
#include "lancer/import/mitsuba/plugin.h"
#include "lancer/import/reader.h"

namespace lancer::mitsuba {

struct Builder {
    ImportContext& context;
    scene::Scene& scene;
    const Document& document;
    Ids ids;

    std::map<std::pair<const Element*, const Element*>, int> materials;  // by BSDF and emitter, each may be null
    std::map<const Element*, int> groups;
    std::map<std::string, std::shared_ptr<const scene::TriangleMesh>> meshes;  // by file and how it was changed
    std::map<const Element*, std::optional<int>> media;
    std::map<std::pair<int, int>, int> filled;  // materials by what they are without the medium inside, and that
    const Element* around_camera = nullptr;     // a medium
    int depth = 0;                              // of plugins in plugins

    Plugin plugin(const Element& element) const { return {element, ids, context}; }
    void honoured(const Plugin& plugin) const { context.report.honoured(plugin.title(), plugin.position()); }
    void approximated(const Plugin& plugin, std::string how) const {
        context.report.approximated(plugin.title(), std::move(how), plugin.position());
    }
    void dropped(const Plugin& plugin, std::string why, bool changes_picture = true) const {
        context.report.dropped(plugin.title(), std::move(why), plugin.position(), changes_picture);
    }
    void error(const SourcePosition& position, std::string message) const { context.diagnostics.error(position, std::move(message)); }
};

// Plugins may nest, and references make circles: beyond some depth it is an error.
class Nesting {
public:
    Nesting(Builder& builder, const SourcePosition& position) : builder_(builder) {
        if (++builder_.depth == deepest) {
            builder_.error(position, "plugins are nested too deeply; do references make a circle?");
        }
    }
    ~Nesting() { --builder_.depth; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

    bool too_deep() const { return builder_.depth >= deepest; }

private:
    static constexpr int deepest = 32;

    Builder& builder_;
};

}  // namespace lancer::mitsuba
