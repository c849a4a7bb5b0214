// Shapes of all kinds in all sizes and places, as authors may write them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analytic/compiled_shapes.h"
#include "analytic/dice.h"

namespace lancer::tests {

struct Family {
    std::string name;
    std::function<scene::Shape(Dice&)> make;  // about as large as 1, near the origin
};

// The convex bodies.
const std::vector<Family>& solid_families();

struct PlacedShape {
    Shape shape;
    glm::dvec3 center{0.0};  // near its middle
    double size = 1.0;       // about
};

// What a shape goes through before it stands in the world.
struct Placing {
    double smallest = 1.0;  // scale
    double largest = 1.0;
    double stretch = 1.0;   // at most, of one axis against another
    double farthest = 0.0;  // from the world's origin
    bool rotates = false;
};

PlacedShape place(const Family& family, const Placing& placing, Dice& dice);

// As the camera and the kernel would have it: all numbers floats.
glm::dvec3 rounded(const glm::dvec3& v);

}  // namespace lancer::tests
