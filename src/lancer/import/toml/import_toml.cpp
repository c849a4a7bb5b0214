#include <algorithm>

#include "lancer/import/import.h"
#include "lancer/import/toml/build.h"
#include "lancer/import/toml/parse.h"

namespace lancer {

namespace {

// As written: the builders go by kind, the reader of the messages goes from top to bottom. Those about the whole file come last.
std::vector<Diagnostic> sorted_by_position(const Diagnostics& diagnostics, const std::string& file) {
    std::vector<Diagnostic> list = diagnostics.list();
    const auto rank = [&](const Diagnostic& d) {
        const int group = d.position.file != file ? 1 : d.position.line == 0 ? 2 : 0;
        return std::tuple(group, group == 0 ? d.position.line : 0, group == 0 ? d.position.column : 0);
    };
    std::stable_sort(list.begin(), list.end(), [&](const Diagnostic& a, const Diagnostic& b) { return rank(a) < rank(b); });
    return list;
}

}  // namespace

std::optional<scene::Scene> import_toml(std::string_view text, const std::string& path, Diagnostics& diagnostics) {
    Diagnostics ours;
    scene::Scene scene;
    scene.file = path;
    if (const auto root = notation::parse(text, path, ours)) {
        SceneFiles files(path, {}, ours);
        files.add_to_hash(path, text);
        notation::Messages messages(path, ours);
        notation::Context context{messages, files, scene};
        notation::build(context, *root);
        scene.hash = files.hash();
        scene.inputs = files.inputs();
    }
    for (Diagnostic& diagnostic : sorted_by_position(ours, path)) {
        diagnostics.add(std::move(diagnostic));
    }
    if (ours.has_errors()) {
        return std::nullopt;
    }
    return scene;
}

}  // namespace lancer
