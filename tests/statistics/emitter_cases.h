// One world for each kind of emitter, and more where a kind has several ways to be drawn from.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lancer/kernel/all_objects.h"
#include "lancer/kernel/emitter/emission.h"
#include "lancer/world/world.h"

namespace lancer::statistics {

struct EmitterCase {
    std::string name;
    int kind = 0;
    std::shared_ptr<const World> world;
    std::vector<kernel::Vec3> corners;  // of a mesh's triangles
    int count = 1;                      // of emitters; the first one is tested
};

std::vector<EmitterCase> emitter_cases();

// All points of the emitter along a direction from the origin. Of spheres the first only, unless all are asked for.
struct Met {
    kernel::SurfacePoint point;
    int part = 0;
};

std::vector<Met> points_along(const EmitterCase& c, const kernel::WorldRecord& world, const kernel::Vec3& direction, bool all = false);

}  // namespace lancer::statistics
