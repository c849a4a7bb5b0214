#include "lancer/image/aov.h"

namespace lancer {

const std::vector<AovKind>& aov_kinds() {
    static const std::vector<AovKind> kinds = {
        {Aov::albedo, "albedo", "albedo.R G B", "the share of light that what is seen first sends back"},
        {Aov::normal, "normal", "normal.X Y Z", "its smooth normal, turned to the camera, in world space"},
        {Aov::depth, "depth", "depth.Z", "its distance along the view in metres; infinite where nothing is seen"},
        {Aov::position, "position", "position.X Y Z", "its place in world space, in metres"},
        {Aov::uv, "uv", "uv.U V", "its texture coordinates"},
        {Aov::object_id, "object_id", "CryptoObject00 ...", "which objects cover the pixel, as Cryptomatte"},
        {Aov::material_id, "material_id", "CryptoMaterial00 ...", "which materials cover the pixel, as Cryptomatte"},
        {Aov::direct, "direct", "direct.R G B", "light that was emitted towards the camera or scattered once"},
        {Aov::indirect, "indirect", "indirect.R G B", "the rest of the light"},
        {Aov::samples, "samples", "samples", "how many samples the pixel rests on"},
        {Aov::variance, "variance", "variance.R G B", "the variance of the pixel's mean"},
        {Aov::interval, "interval", "interval.low high tail", "where the truth lies with the stated confidence, as luminance"},
    };
    return kinds;
}

std::vector<std::string> aov_names() {
    std::vector<std::string> names;
    for (const AovKind& kind : aov_kinds()) {
        names.emplace_back(kind.name);
    }
    return names;
}

std::optional<Aov> find_aov(std::string_view name) {
    for (const AovKind& kind : aov_kinds()) {
        if (kind.name == name) {
            return kind.aov;
        }
    }
    return std::nullopt;
}

}  // namespace lancer
