// How light is followed through a scene: what each way can't do, and which one suits it.
#pragma once

#include <string>
#include <vector>

#include "lancer/scene/scene.h"

namespace lancer::scene {

struct IntegratorChoice {
    std::string name;
    std::string why;  // in words, to go on with after "because"
};

// What the settings name; for "auto" what the scene asks for, always one that can render it.
IntegratorChoice choose_integrator(const Scene& scene);

// Why an integrator can't render the scene, in words; and where that is written. Nothing where it can.
struct Obstacle {
    std::string what;
    SourcePosition position;
};

std::vector<Obstacle> obstacles(const Scene& scene, const std::string& integrator);

// Which of the AOVs and spectra that the settings ask for it can't make, in words; empty where it makes them all.
std::string lacking(const Scene& scene, const std::string& integrator);

// Whether it follows light from the lamps.
bool starts_at_lamps(const std::string& integrator);

}  // namespace lancer::scene
