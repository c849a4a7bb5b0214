#include "analytic/families.h"

#include <glm/geometric.hpp>

namespace lancer::tests {

namespace {

double size(Dice& dice) { return dice.log_between(0.2, 2.0); }

}  // namespace

const std::vector<Family>& solid_families() {
    static const std::vector<Family> families = {
        {"sphere",
         [](Dice& d) -> scene::Shape {
             return scene::Sphere{d.in_cube(0.5), size(d)};
         }},
        {"box",
         [](Dice& d) -> scene::Shape {
             const glm::dvec3 center = d.in_cube(0.5);
             const double x = size(d), y = size(d);
             const glm::dvec3 half(x, y, size(d));
             return scene::Box{center - half, center + half};
         }},
        {"cylinder",
         [](Dice& d) -> scene::Shape {
             const glm::dvec3 from = d.in_cube(0.5);
             return scene::Cylinder{from, from + d.direction() * size(d), size(d), true};
         }},
        {"cone",
         [](Dice& d) -> scene::Shape {
             const glm::dvec3 from = d.in_cube(0.5);
             return scene::Cone{from, from + d.direction() * size(d), size(d), 0.0, true};
         }},
        {"frustum",
         [](Dice& d) -> scene::Shape {
             const glm::dvec3 from = d.in_cube(0.5);
             const double bottom = size(d);
             return scene::Cone{from, from + d.direction() * size(d), bottom, size(d), true};
         }},
    };
    return families;
}

PlacedShape place(const Family& family, const Placing& placing, Dice& dice) {
    glm::dmat4 m(1.0);
    PlacedShape result;
    result.size = dice.log_between(placing.smallest, placing.largest);
    if (placing.farthest > 0.0) {
        m = glm::translate(m, dice.direction() * dice.log_between(1e-3 * placing.farthest, placing.farthest));
    }
    if (placing.rotates) {
        m = m * dice.rotation();
    }
    m = glm::scale(m, glm::dvec3(result.size));
    if (placing.stretch > 1.0) {
        const double x = dice.log_between(1.0, placing.stretch);
        m = glm::scale(m, glm::dvec3(x, 1.0, dice.log_between(1.0, placing.stretch)));
        m = m * dice.rotation();
    }
    result.center = glm::dvec3(m[3]);
    result.shape = compile_shape(family.make(dice), m);
    return result;
}

glm::dvec3 rounded(const glm::dvec3& v) {
    // Through memory: g++ 12 takes a pair of doubles to floats and back without rounding them.
    volatile float floats[3] = {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    return {static_cast<double>(floats[0]), static_cast<double>(floats[1]), static_cast<double>(floats[2])};
}

}  // namespace lancer::tests
