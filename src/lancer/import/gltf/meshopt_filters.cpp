#include "lancer/import/gltf/meshopt_filters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

namespace lancer::gltf {

namespace {

template <class Number>
Number rounded(float v) {
    return static_cast<Number>(v + (v >= 0.0f ? 0.5f : -0.5f));
}

// A direction as two coordinates on an octahedron, and the number that stands for 1 in the third; the fourth passes through.
template <class Number>
void from_octahedron(char* bytes) {
    Number v[4];
    std::memcpy(v, bytes, sizeof v);
    float x = static_cast<float>(v[0]), y = static_cast<float>(v[1]);
    const float z = static_cast<float>(v[2]) - std::abs(x) - std::abs(y);
    const float fold = std::min(z, 0.0f);
    x += x >= 0.0f ? fold : -fold;
    y += y >= 0.0f ? fold : -fold;
    const float length = std::sqrt(x * x + y * y + z * z);
    const float scale = length > 0.0f ? static_cast<float>(std::numeric_limits<Number>::max()) / length : 0.0f;
    v[0] = rounded<Number>(x * scale);
    v[1] = rounded<Number>(y * scale);
    v[2] = rounded<Number>(z * scale);
    std::memcpy(bytes, v, sizeof v);
}

// The three smaller components of a quaternion; the fourth number says which is missing, and how large 1/sqrt(2) is.
void from_three_components(char* bytes) {
    std::int16_t v[4];
    std::memcpy(v, bytes, sizeof v);
    const auto largest = static_cast<unsigned>(v[3]) & 3u;
    const float scale = 0.70710678f / static_cast<float>(v[3] | 3);
    const float x = static_cast<float>(v[0]) * scale, y = static_cast<float>(v[1]) * scale, z = static_cast<float>(v[2]) * scale;
    const float w = std::sqrt(std::max(1.0f - x * x - y * y - z * z, 0.0f));
    const float parts[4] = {w, x, y, z};
    for (unsigned i = 0; i < 4; ++i) {
        v[(largest + i) & 3u] = rounded<std::int16_t>(std::clamp(parts[i], -1.0f, 1.0f) * 32767.0f);
    }
    std::memcpy(bytes, v, sizeof v);
}

// A float as a signed exponent of 8 bits and a signed mantissa of 24.
void from_exponent(char* bytes) {
    std::int32_t v;
    std::memcpy(&v, bytes, sizeof v);
    const auto mantissa = static_cast<std::int32_t>(static_cast<std::uint32_t>(v) << 8) >> 8;
    const float result = std::ldexp(static_cast<float>(mantissa), v >> 24);
    std::memcpy(bytes, &result, sizeof result);
}

}  // namespace

bool apply_filter(const MeshoptView& view, std::string& elements, std::string& problem) {
    const auto for_each = [&](std::size_t step, void (*apply)(char*)) {
        for (std::size_t i = 0; i + step <= elements.size(); i += step) {
            apply(&elements[i]);
        }
        return true;
    };
    if (view.filter == "NONE") {
        return true;
    }
    if (view.mode == "ATTRIBUTES") {
        if (view.filter == "OCTAHEDRAL" && view.stride == 4) {
            return for_each(4, from_octahedron<std::int8_t>);
        }
        if (view.filter == "OCTAHEDRAL" && view.stride == 8) {
            return for_each(8, from_octahedron<std::int16_t>);
        }
        if (view.filter == "QUATERNION" && view.stride == 8) {
            return for_each(8, from_three_components);
        }
        if (view.filter == "EXPONENTIAL") {
            return for_each(4, from_exponent);
        }
    }
    problem = fmt::format("the filter {} does not fit {} elements of {} bytes", view.filter.substr(0, 80), view.mode, view.stride);
    return false;
}

}  // namespace lancer::gltf
