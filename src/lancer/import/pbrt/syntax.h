// From the text of a file to its directives, in order. What they mean is not looked at here, and numbers are not read yet: a mesh of 100 MB is
// one parameter whose values are still text.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "lancer/base/diagnostic.h"
#include "lancer/import/pbrt/source_text.h"

namespace lancer::pbrt {

enum class Keyword {
    accelerator,
    active_transform,
    area_light_source,
    attribute,
    attribute_begin,
    attribute_end,
    camera,
    color_space,
    concat_transform,
    coordinate_system,
    coord_sys_transform,
    film,
    identity,
    import,
    include,
    integrator,
    light_source,
    look_at,
    make_named_material,
    make_named_medium,
    material,
    medium_interface,
    named_material,
    object_begin,
    object_end,
    object_instance,
    option,
    pixel_filter,
    reverse_orientation,
    rotate,
    sampler,
    scale,
    shape,
    texture,
    transform,
    transform_begin,
    transform_end,
    transform_times,
    translate,
    world_begin,
    world_end,  // of version 3
};

// "float radius" 1, "rgb L" [ 1 1 1 ]
struct Parameter {
    std::string_view type;
    std::string_view name;
    std::string_view values;  // without the brackets
    const SourceText* text = nullptr;
};

struct Directive {
    Keyword keyword{};
    std::string_view word;                    // as it stands in the text
    std::array<std::string_view, 3> strings;  // without quotes; empty where there are less
    int string_count = 0;
    std::string_view numbers;  // as many as the keyword asks for
    std::uint32_t first_parameter = 0;
    std::uint32_t parameter_count = 0;
};

struct Syntax {
    std::shared_ptr<const SourceText> text;
    std::vector<Directive> directives;
    std::vector<Parameter> parameters;

    SourcePosition position(std::string_view part) const { return text->position(part); }
};

// Errors say where and what was expected; after one the reading goes on with the next directive, up to a number of errors.
Syntax parse_syntax(std::shared_ptr<const SourceText> text, Diagnostics& diagnostics);

}  // namespace lancer::pbrt
