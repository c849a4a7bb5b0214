#include "lancer/app/figures/drawing.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "lancer/app/figures/stroke_font.h"

namespace lancer::app {

namespace {

constexpr double dash = 6.0;  // pixels drawn, and as many left out

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string svg_color(const glm::dvec3& color) {
    const auto byte = [](double value) { return static_cast<int>(std::lround(255.0 * std::clamp(value, 0.0, 1.0))); };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(color.r), byte(color.g), byte(color.b));
}

// Paint on display values; strokes cover a pixel as far as they reach into it.
class Painter {
public:
    explicit Painter(const Drawing& drawing)
        : width_(drawing.width), height_(drawing.height),
          pixels_(static_cast<std::size_t>(drawing.width) * static_cast<std::size_t>(drawing.height), drawing.background) {}

    void segment(const glm::dvec2& a, const glm::dvec2& b, double width, const glm::dvec3& color) {
        const double reach = width / 2.0 + 1.0;
        const int x0 = std::max(0, static_cast<int>(std::floor(std::min(a.x, b.x) - reach)));
        const int x1 = std::min(width_, static_cast<int>(std::ceil(std::max(a.x, b.x) + reach)));
        const int y0 = std::max(0, static_cast<int>(std::floor(std::min(a.y, b.y) - reach)));
        const int y1 = std::min(height_, static_cast<int>(std::ceil(std::max(a.y, b.y) + reach)));
        const glm::dvec2 ab = b - a;
        const double length_squared = std::max(glm::dot(ab, ab), 1e-12);
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x) {
                const glm::dvec2 p(x + 0.5, y + 0.5);
                const double along = std::clamp(glm::dot(p - a, ab) / length_squared, 0.0, 1.0);
                const double cover = std::clamp(width / 2.0 + 0.5 - glm::length(p - a - along * ab), 0.0, 1.0);
                glm::dvec3& pixel = pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
                pixel += cover * (color - pixel);
            }
        }
    }

    void line(const Drawing::Line& line) {
        for (std::size_t i = 1; i < line.points.size(); ++i) {
            const glm::dvec2& a = line.points[i - 1];
            const glm::dvec2& b = line.points[i];
            const double length = std::max(glm::length(b - a), 1e-9);
            const double piece = line.dashed ? dash : length;
            for (double start = 0.0; start < length; start += 2.0 * piece) {
                segment(a + (b - a) * (start / length), a + (b - a) * (std::min(start + piece, length) / length), line.width, line.color);
            }
        }
    }

    void words(const Drawing::Words& words) {
        const double capital = 0.72 * words.size;  // as in most fonts
        const double shift =
            words.align == Drawing::Align::left ? 0.0 : text_width(words.text) * (words.align == Drawing::Align::middle ? 0.5 : 1.0);
        for (const std::vector<glm::dvec2>& stroke : text_strokes(words.text)) {
            for (std::size_t i = 1; i < stroke.size(); ++i) {
                const auto place = [&](const glm::dvec2& p) { return words.at + glm::dvec2(p.x - shift, -p.y) * capital; };
                segment(place(stroke[i - 1]), place(stroke[i]), 0.1 * words.size, words.color);
            }
        }
    }

    Image image() const {
        Image image;
        image.width = width_;
        image.height = height_;
        image.channels = 3;
        for (const glm::dvec3& pixel : pixels_) {
            for (int c = 0; c < 3; ++c) {
                image.pixels.push_back(srgb_decode(static_cast<float>(pixel[c])));
            }
        }
        return image;
    }

private:
    int width_;
    int height_;
    std::vector<glm::dvec3> pixels_;  // display values
};

}  // namespace

std::string to_svg(const Drawing& drawing) {
    std::string svg = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n",
                                  drawing.width, drawing.height);
    svg += fmt::format("<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n", svg_color(drawing.background));
    for (const Drawing::Line& line : drawing.lines) {
        std::string points;
        for (const glm::dvec2& p : line.points) {
            points += fmt::format("{:.2f},{:.2f} ", p.x, p.y);
        }
        svg += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", points, svg_color(line.color),
                           line.width, line.dashed ? fmt::format(" stroke-dasharray=\"{}\"", dash) : "");
    }
    for (const Drawing::Dot& dot : drawing.dots) {
        svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"{}\"/>\n", dot.center.x, dot.center.y, dot.radius,
                           svg_color(dot.color));
    }
    for (const Drawing::Words& words : drawing.words) {
        const char* const anchors[] = {"start", "middle", "end"};
        svg += fmt::format(
            "<text x=\"{:.2f}\" y=\"{:.2f}\" font-family=\"sans-serif\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n",
            words.at.x, words.at.y, words.size, anchors[static_cast<int>(words.align)], svg_color(words.color), escaped(words.text));
    }
    return svg + "</svg>\n";
}

Image paint(const Drawing& drawing) {
    Painter painter(drawing);
    for (const Drawing::Line& line : drawing.lines) {
        painter.line(line);
    }
    for (const Drawing::Dot& dot : drawing.dots) {
        painter.segment(dot.center, dot.center, 2.0 * dot.radius, dot.color);
    }
    for (const Drawing::Words& words : drawing.words) {
        painter.words(words);
    }
    return painter.image();
}

}  // namespace lancer::app
