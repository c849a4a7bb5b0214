#include <algorithm>
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "lancer/base/file.h"
#include "lancer/import/default_view.h"
#include "lancer/import/mesh/mesh_check.h"
#include "lancer/import/obj/mtl.h"
#include "lancer/import/obj/obj.h"
#include "lancer/import/obj/obj_build.h"

namespace lancer {

namespace obj {

namespace {

class Builder {
public:
    Builder(const Statements& statements, ImportContext& context, scene::Scene& scene)
        : statements_(statements), context_(context), scene_(scene) {}

    void build() {
        for (const Library& library : statements_.libraries) {
            read(library);
        }
        std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> known;  // by name and material, in the order of the file
        std::vector<std::pair<Run, std::vector<FaceRange>>> parts;
        for_each_run([&](const Run& run, const FaceRange& faces) {
            const auto [found, is_new] = known.try_emplace({run.name, run.material}, parts.size());
            if (is_new) {
                parts.push_back({run, {}});
            }
            parts[found->second].second.push_back(faces);
        });
        for (const auto& [run, faces] : parts) {
            add(run, faces);
        }
        if (scene_.objects.empty() && !context_.diagnostics.has_errors()) {
            context_.diagnostics.error({context_.path, 0, 0}, "this file has no triangle with an area");
        }
    }

private:
    template <class Function>
    void for_each_run(const Function& function) {
        Run run;
        std::size_t begin = 0;
        const auto end_at = [&](std::size_t end) {
            if (end > begin) {
                function(run, FaceRange{begin, end});
            }
            begin = end;
        };
        for (const Run& next : statements_.runs) {
            end_at(next.first_face);
            run = next;
        }
        end_at(statements_.face_ends.size());
    }

    // Names may have blanks, or blanks may part names.
    void read(const Library& library) {
        const SourcePosition position{context_.path, library.line, library.column};
        std::vector<std::string> files = {library.names};
        std::error_code problem;
        if (!std::filesystem::exists(path_beside(context_.path, library.names), problem)) {
            files.clear();
            for (std::size_t at = 0; at < library.names.size();) {
                const std::size_t begin = library.names.find_first_not_of(" \t", at);
                const std::size_t end = std::min(library.names.find_first_of(" \t", begin), library.names.size());
                files.push_back(library.names.substr(begin, end - begin));
                at = end;
            }
        }
        for (std::string& file : files) {
            std::replace(file.begin(), file.end(), '\\', '/');
            const std::string path = path_beside(context_.path, file);
            if (const auto bytes = context_.files.open_or_warn(path, position, "its materials are grey")) {
                for (const MaterialStatements& statements : parse_materials(bytes->view(), path, context_)) {
                    if (written_.try_emplace(statements.name, std::pair(statements, path)).second) {
                        context_.report.honoured("mtllib", position);
                    }
                }
            }
        }
    }

    // Only materials that something has become materials of the scene.
    int material(const Run& run) {
        const auto [found, is_new] = materials_.try_emplace(run.material, static_cast<int>(scene_.materials.size()));
        if (!is_new) {
            return found->second;
        }
        const std::string name = run.material == absent ? "" : statements_.materials[static_cast<std::size_t>(run.material)];
        const auto written = written_.find(name);
        if (run.material != absent && written != written_.end()) {
            scene_.materials.push_back(make_material(written->second.first, written->second.second, context_));
        } else if (statements_.materials.empty()) {
            scene_.materials.push_back({{}, scene::WhittedMaterial{}, {context_.path, 0, 0}, std::nullopt, true});  // a shape and no more
        } else {
            scene_.materials.push_back({name, scene::DiffuseMaterial{}, {context_.path, 0, 0}});
            if (run.material != absent) {
                context_.report.approximated(fmt::format("usemtl {}", lancer::quoted(name)), "grey: no .mtl file tells what it is",
                                             {context_.path, 0, 0});
            }
        }
        return found->second;
    }

    void add(const Run& run, const std::vector<FaceRange>& faces) {
        auto mesh = std::make_shared<scene::TriangleMesh>(obj::build(statements_, faces));
        Diagnostics problems;
        MeshMessages messages(context_.path, problems);
        if (!check_mesh(*mesh, messages)) {
            // A part without area is nothing to be seen; anything else is an error of the file.
            const bool is_flat = mesh->triangles.empty();
            for (Diagnostic diagnostic : problems.list()) {
                diagnostic.severity = is_flat && diagnostic.severity == Severity::error ? Severity::warning : diagnostic.severity;
                context_.diagnostics.add(std::move(diagnostic));
            }
            return;
        }
        context_.diagnostics.append(std::move(problems));
        const std::string name = run.name == absent ? "" : statements_.names[static_cast<std::size_t>(run.name)];
        scene_.objects.push_back({name, scene::Mesh{std::move(mesh)}, material(run), glm::dmat4(1.0), {context_.path, 0, 0}});
    }

    const Statements& statements_;
    ImportContext& context_;
    scene::Scene& scene_;
    std::map<std::string, std::pair<MaterialStatements, std::string>> written_;  // by name; and the file that they stand in
    std::map<std::int32_t, int> materials_;
};

}  // namespace

}  // namespace obj

void read_obj_scene(ImportContext& context, scene::Scene& scene) {
    const auto bytes = context.files.open(context.path, {});
    if (!bytes) {
        return;
    }
    MeshMessages messages(context.path, context.diagnostics);
    const obj::Statements statements = obj::parse(bytes->view(), messages);
    if (messages.has_errors()) {
        return;
    }
    if (statements.lines_and_points > 0) {
        context.report.dropped("lines and points", "they have no area that light could fall on", {context.path, 0, 0});
    }
    if (statements.face_ends.empty()) {
        messages.error(0, 0, "this mesh has no triangles");
        return;
    }
    obj::Builder(statements, context, scene).build();
}

}  // namespace lancer
