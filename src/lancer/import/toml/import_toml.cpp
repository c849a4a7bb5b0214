#include <algorithm>

#include "lancer/import/reader.h"
#include "lancer/import/toml/build.h"
#include "lancer/import/toml/parse.h"

namespace lancer {

namespace {

// The tree of values takes many times the text's size; large meshes belong into files of their own.
constexpr std::size_t largest_toml = std::size_t{32} << 20;

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

// What was said before stays before.
void sort_new(Diagnostics& diagnostics, Diagnostics& before, const std::string& file) {
    const std::vector<Diagnostic> added = sorted_by_position(diagnostics, file);
    diagnostics = std::move(before);
    for (const Diagnostic& diagnostic : added) {
        diagnostics.add(diagnostic);
    }
}

void read_text(std::string_view text, ImportContext& context, scene::Scene& scene) {
    Diagnostics before;
    std::swap(before, context.diagnostics);
    if (const auto root = notation::parse(text, context.path, context.diagnostics)) {
        notation::Messages messages(context.path, context.diagnostics);
        notation::Context building{messages, context.files, scene, context};
        notation::build(building, *root);
    }
    sort_new(context.diagnostics, before, context.path);
}

}  // namespace

void read_toml(ImportContext& context, scene::Scene& scene) {
    if (const auto bytes = context.files.open(context.path, {}, largest_toml)) {
        read_text(bytes->view(), context, scene);
    }
}

std::optional<scene::Scene> import_toml(std::string_view text, const std::string& path, Diagnostics& diagnostics) {
    Diagnostics ours;
    ImportReport report;
    const ImportOptions options;
    SceneFiles files(path, options, ours);
    files.add_to_hash(path, text);
    scene::Scene scene;
    scene.file = path;
    ImportContext context{path, options, files, report, ours};
    if (files.enter(path, {})) {
        read_text(text, context, scene);
    }
    scene.hash = files.hash();
    scene.inputs = files.inputs();
    const bool failed = ours.has_errors();
    diagnostics.append(std::move(ours));
    return failed ? std::nullopt : std::optional<scene::Scene>(std::move(scene));
}

}  // namespace lancer
