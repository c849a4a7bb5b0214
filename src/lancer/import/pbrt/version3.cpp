#include "lancer/import/pbrt/version3.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace lancer::pbrt {

namespace {

constexpr std::array<std::string_view, 10> old_materials = {"matte",     "plastic",     "metal",  "glass",        "mirror",
                                                            "substrate", "translucent", "disney", "kdsubsurface", "uber"};

bool is_old_material(std::string_view word) { return std::find(old_materials.begin(), old_materials.end(), word) != old_materials.end(); }

bool is_old(const Syntax& syntax, const Directive& directive) {
    switch (directive.keyword) {
        case Keyword::world_end:
            return true;
        case Keyword::film:
            return directive.strings[0] == "image";
        case Keyword::material:
            return is_old_material(directive.strings[0]);
        case Keyword::texture:
            return directive.strings[1] == "color";
        case Keyword::make_named_material:
            for (std::uint32_t i = 0; i < directive.parameter_count; ++i) {
                const Parameter& parameter = syntax.parameters[directive.first_parameter + i];
                const std::size_t begin = parameter.values.find('"');
                const std::size_t end = parameter.values.rfind('"');
                if (parameter.name == "type" && begin < end && is_old_material(parameter.values.substr(begin + 1, end - begin - 1))) {
                    return true;
                }
            }
            return false;
        default:
            return false;
    }
}

}  // namespace

std::optional<SourcePosition> sign_of_version3(const Syntax& syntax) {
    for (const Directive& directive : syntax.directives) {
        if (is_old(syntax, directive)) {
            return syntax.position(directive.word);
        }
    }
    return std::nullopt;
}

}  // namespace lancer::pbrt
