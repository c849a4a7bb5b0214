// A drawing of lines, dots and words, written as SVG or painted into an image.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lancer/image/image.h"

namespace lancer::app {

// Coordinates in pixels from the upper left corner, y downwards. Colours as they are displayed (sRGB, 0 to 1).
struct Drawing {
    enum class Align { left, middle, right };
    struct Line {
        std::vector<glm::dvec2> points;
        double width = 1.0;
        glm::dvec3 color{0.0};
        bool dashed = false;
    };
    struct Dot {
        glm::dvec2 center{0.0};
        double radius = 4.0;
        glm::dvec3 color{0.0};
    };
    struct Words {
        std::string text;
        glm::dvec2 at{0.0};  // on the base line
        double size = 16.0;  // of the letters' full height
        Align align = Align::left;
        glm::dvec3 color{0.0};
    };

    int width = 0;
    int height = 0;
    glm::dvec3 background{1.0};
    std::vector<Line> lines;
    std::vector<Dot> dots;
    std::vector<Words> words;
};

std::string to_svg(const Drawing& drawing);

// Smooth edges; letters are drawn with strokes. Linear light.
Image paint(const Drawing& drawing);

}  // namespace lancer::app
