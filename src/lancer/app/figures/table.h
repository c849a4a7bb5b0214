// Every figure of the report, made anew, and one for each thing added since: what is rendered and what is said about it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lancer::app {

// A part of the picture, each pixel repeated so that it can be seen.
struct Enlargement {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    int factor = 1;
};

struct Figure {
    std::string id;                                      // the picture is ID.png
    std::string caption;                                 // plain text
    std::string scene;                                   // an embedded scene: "scenes/report/figure-1.toml"
    std::vector<std::string> options;                    // of `lancer render`
    std::optional<Enlargement> enlarged = std::nullopt;  // shown beside, as ID-enlarged.png
    bool sample_map = false;                             // shown beside, as ID-samples.png
};

struct FigureGroup {
    std::string title;
    std::string text;  // a sentence or two, or none
    std::vector<Figure> figures;
};

const std::vector<FigureGroup>& figure_table();

}  // namespace lancer::app
