// Every integrator paints the same picture of surfaces; agreement.h says how often this fails by chance.
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lancer/import/import.h"
#include "statistics/agreement.h"

namespace lancer::statistics {
namespace {

// Light that is followed from the lamps alone can't be seen in mirrors and through glass.
void make_matt(scene::Scene& scene) {
    for (scene::Material& material : scene.materials) {
        const bool shiny = std::holds_alternative<scene::ConductorMaterial>(material.model) ||
                           std::holds_alternative<scene::DielectricMaterial>(material.model);
        if (shiny) {
            material.model = scene::DiffuseMaterial{scene::Rgb(0.6), 0.0};
        }
    }
}

Blocks rendered(const std::string& name, const std::string& integrator, bool matt, int spp, int first_seed) {
    Diagnostics diagnostics;
    std::optional<scene::Scene> scene = import_scene(LANCER_SOURCE_FOLDER "/scenes/" + name, diagnostics);
    if (!scene) {
        ADD_FAILURE() << name;
        return {};
    }
    if (matt) {
        make_matt(*scene);
    }
    scene->settings.bounces = 8;
    return rendered_blocks(*scene, integrator, spp, first_seed);
}

struct AgreementCase {
    std::string name;
    std::string scene;
    std::vector<std::string> integrators;
    int spp = 16;
    bool matt = false;
};

class Agreement : public testing::TestWithParam<AgreementCase> {};

TEST_P(Agreement, OfAllIntegrators) {
    const AgreementCase& c = GetParam();
    const Blocks path = rendered(c.scene, "path", c.matt, c.spp, 100);
    int seed = 200;
    for (const std::string& integrator : c.integrators) {
        const Blocks other = rendered(c.scene, integrator, c.matt, c.spp, seed);
        seed += 100;
        expect_agreement(path, other, integrator);
    }
}

std::string name_of(const testing::TestParamInfo<AgreementCase>& one) { return one.param.name; }

INSTANTIATE_TEST_SUITE_P(Statistics, Agreement,
                         testing::Values(AgreementCase{"CornellBox", "gallery/cornell-box.toml", {"bdpt"}, 8},
                                         AgreementCase{"MattBox", "gallery/cornell-box.toml", {"light", "bdpt"}, 8, true},
                                         AgreementCase{"Principled", "features/principled.toml", {"bdpt"}, 4},
                                         AgreementCase{"ClearBodies", "features/clear-bodies.toml", {"bdpt"}, 4},
                                         AgreementCase{"VertexColors", "features/vertex-colors.toml", {"bdpt"}, 8}),
                         name_of);

INSTANTIATE_TEST_SUITE_P(SlowStatistics, Agreement,
                         testing::Values(AgreementCase{"CornellBoxWithPhotons", "gallery/cornell-box.toml", {"vcm"}},
                                         AgreementCase{"MattBoxWithPhotons", "gallery/cornell-box.toml", {"vcm"}, 16, true},
                                         AgreementCase{"MattRoom", "features/both-ends.toml", {"light", "bdpt", "vcm"}, 16, true},
                                         AgreementCase{"Lamps", "features/lamps.toml", {"bdpt"}},
                                         AgreementCase{"Plastics", "features/plastics.toml", {"bdpt"}},
                                         AgreementCase{"Metals", "features/metals.toml", {"bdpt"}},
                                         AgreementCase{"DepthOfField", "features/depth-of-field.toml", {"bdpt"}},
                                         AgreementCase{"Masks", "features/masks.toml", {"bdpt"}},
                                         AgreementCase{"Mixes", "features/mixes.toml", {"bdpt"}},
                                         AgreementCase{"Bumps", "features/bumps.toml", {"bdpt"}},
                                         AgreementCase{"Environment", "features/environment.toml", {"bdpt"}},
                                         AgreementCase{"StillLife", "gallery/still-life.toml", {"bdpt"}}),
                         name_of);

}  // namespace
}  // namespace lancer::statistics
