// Carries out directives one after the other and fills the scene.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lancer/import/pbrt/graphics_state.h"
#include "lancer/import/pbrt/lights.h"
#include "lancer/import/pbrt/material_table.h"
#include "lancer/import/pbrt/options.h"
#include "lancer/import/pbrt/shapes.h"
#include "lancer/import/pbrt/syntax.h"
#include "lancer/import/pbrt/textures.h"

namespace lancer::pbrt {

class Interpreter {
public:
    Interpreter(ImportContext& context, scene::Scene& scene);

    // The whole scene from its first file.
    void run();

private:
    struct Saved {
        Keyword opened{};
        SourcePosition position;
        GraphicsState state;
    };

    const Syntax* syntax_of(const std::string& path, const SourcePosition& named_at);
    void carry_out(const Syntax& syntax);
    void carry_out(const Syntax& syntax, const Directive& directive);
    void include(const Syntax& syntax, const Directive& directive);

    Parameters parameters(const Syntax& syntax, const Directive& directive, std::optional<Target> target = std::nullopt) const;
    Recipe recipe(const Syntax& syntax, const Directive& directive, std::optional<Target> target = std::nullopt) const;

    void transform(const Syntax& syntax, const Directive& directive);
    void coordinate_system(const Syntax& syntax, const Directive& directive);
    void open(const Syntax& syntax, const Directive& directive, Keyword keyword);
    void close(const Syntax& syntax, const Directive& directive, Keyword keyword);
    void set_defaults(const Syntax& syntax, const Directive& directive);
    void make_named_material(const Syntax& syntax, const Directive& directive);
    void define_texture(const Syntax& syntax, const Directive& directive);
    void begin_object(const Syntax& syntax, const Directive& directive);
    void end_object(const Syntax& syntax, const Directive& directive);
    void place_object(const Syntax& syntax, const Directive& directive);
    void add_shape(const Syntax& syntax, const Directive& directive);
    bool has_room(const SourcePosition& position);

    ImportContext& context_;
    scene::Scene& scene_;
    bool version3_ = false;
    bool in_world_ = false;
    bool full_ = false;
    bool spectral_ = false;  // some colour is written as a spectrum
    std::size_t sequence_ = 0;
    std::size_t things_ = 0;  // objects and placements

    std::map<std::string, std::unique_ptr<const Syntax>> files_;
    std::vector<std::string> open_files_;

    glm::dmat4 to_scene_{1.0};   // from the world of the file
    std::string around_camera_;  // the medium
    GraphicsState state_;
    std::vector<Saved> saved_;
    std::map<std::string, GraphicsState, std::less<>> coordinate_systems_;
    std::map<std::string, int, std::less<>> objects_;  // by name: groups
    std::optional<int> object_;                        // the group that is being defined
    std::map<std::pair<const Directive*, bool>, std::optional<BuiltShape>> shapes_;

    Options options_;
    Textures textures_;
    MaterialTable materials_;
    Lights lights_;
};

}  // namespace lancer::pbrt
