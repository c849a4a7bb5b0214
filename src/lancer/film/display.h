// What the eye will see of linear light: exposed, encoded as sRGB, clipped to what a display can show.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace lancer {

// A table of the sRGB curve: many times faster than the curve and right to 0.0005, enough to compare pixels. Values that are not numbers
// count as black.
class DisplayCurve {
public:
    explicit DisplayCurve(double exposure);  // stops

    float encode(float linear) const {
        const float exposed = linear * scale_;
        if (!(exposed > 0.0f)) {
            return 0.0f;
        }
        if (exposed >= 1.0f) {
            return 1.0f;
        }
        const float place = exposed * static_cast<float>(steps);
        const int index = static_cast<int>(place);
        const float rest = place - static_cast<float>(index);
        const std::size_t i = static_cast<std::size_t>(index);
        return table_[i] + rest * (table_[i + 1] - table_[i]);
    }
    glm::vec3 encode(const glm::vec3& linear) const { return {encode(linear.x), encode(linear.y), encode(linear.z)}; }

private:
    static constexpr int steps = 1024;
    float scale_;
    std::array<float, steps + 2> table_;
};

}  // namespace lancer
