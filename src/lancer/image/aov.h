// What can stand in an EXR file beside the picture ("arbitrary output variables"), by name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lancer {

enum class Aov { albedo, normal, depth, position, uv, object_id, material_id, direct, indirect, samples, variance, interval };

struct AovKind {
    Aov aov;
    std::string_view name;
    std::string_view channels;
    std::string_view help;
};

const std::vector<AovKind>& aov_kinds();
std::vector<std::string> aov_names();
std::optional<Aov> find_aov(std::string_view name);

}  // namespace lancer
