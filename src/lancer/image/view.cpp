#include "lancer/image/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "lancer/base/failure.h"
#include "lancer/image/aces/aces_module.h"

namespace lancer {
namespace {

// What is not a number or negative is black here.
glm::vec3 not_negative(const glm::vec3& c) {
    const auto up = [](float x) { return x > 0.0f ? std::min(x, 1e6f) : 0.0f; };
    return {up(c.x), up(c.y), up(c.z)};
}

// ---- AgX --------------------------------------------------------------------------------------------------------------------------

// Each channel moves a fifth of the way to one mixture of the three: pure colours keep some of each, and can go to white.
glm::mat3 agx_inset() {
    constexpr float share = 0.2f;
    const glm::vec3 mixture(0.212f, 0.392f, 0.396f);
    return glm::mat3(1.0f - share) + share * glm::outerProduct(glm::vec3(1.0f), mixture);
}

// A sigmoid that is straight with this slope at a pivot, middle grey, and reaches 0 and 1 with the sharpness `power` on either side.
class Sigmoid {
public:
    Sigmoid() : toe_(scale(pivot_x, pivot_y)), shoulder_(scale(1.0f - pivot_x, 1.0f - pivot_y)) {}

    float operator()(float x) const {
        const float size = x < pivot_x ? -toe_ : shoulder_;
        const float t = slope * (x - pivot_x) / size;  // positive
        return std::clamp(size * t / std::pow(1.0f + std::pow(t, power), 1.0f / power) + pivot_y, 0.0f, 1.0f);
    }

    static constexpr float darkest = -10.0f, brightest = 6.5f;  // stops from middle grey

private:
    // So that the curve runs `rise` over the distance `run`.
    static float scale(float run, float rise) {
        const float line = slope * run;
        return std::pow(std::pow(line, -power) * (std::pow(line / rise, power) - 1.0f), -1.0f / power);
    }

    static constexpr float slope = 2.4f, power = 1.5f;
    static constexpr float pivot_x = -darkest / (brightest - darkest);
    static constexpr float pivot_y = 0.4586564f;  // 0.18^(1/2.2)
    float toe_, shoulder_;
};

// ---- ACES -------------------------------------------------------------------------------------------------------------------------

void append(void* receiver, const char* data, std::size_t size) { static_cast<std::string*>(receiver)->append(data, size); }

void apply_aces(std::span<glm::vec3> colors) {
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    std::string reason;
    if (!colors.empty() && !aces_module().develop(&colors.front().x, colors.size(), &reason, append)) {
        throw MachineFailure("the view aces: " + reason);
    }
}

}  // namespace

const std::vector<std::string>& view_names() {
    static const std::vector<std::string> names = {"srgb", "pbr-neutral", "agx", "aces"};
    return names;
}

std::optional<View> find_view(std::string_view name) {
    const auto found = std::find(view_names().begin(), view_names().end(), name);
    return found != view_names().end() ? std::optional(static_cast<View>(found - view_names().begin())) : std::nullopt;
}

std::string_view name_of(View view) { return view_names().at(static_cast<std::size_t>(view)); }

glm::vec3 pbr_neutral(const glm::vec3& light) {
    constexpr float mirrored = 0.04f;        // what a dielectric surface mirrors beside its colour
    constexpr float from = 0.8f - mirrored;  // where compression begins
    constexpr float desaturation = 0.15f;
    glm::vec3 c = not_negative(light);
    const float least = std::min({c.x, c.y, c.z});
    c -= glm::vec3(least < 2.0f * mirrored ? least - least * least / (4.0f * mirrored) : mirrored);
    const float peak = std::max({c.x, c.y, c.z});
    if (peak <= from) {
        return c;
    }
    constexpr float rest = 1.0f - from;
    const float compressed = 1.0f - rest * rest / (peak + rest - from);
    c *= compressed / peak;
    const float white = 1.0f - 1.0f / (desaturation * (peak - compressed) + 1.0f);
    return c * (1.0f - white) + glm::vec3(compressed * white);
}

glm::vec3 agx(const glm::vec3& light) {
    static const glm::mat3 inset = agx_inset();
    static const glm::mat3 outset = glm::inverse(inset);
    static const Sigmoid curve;
    glm::vec3 c = inset * not_negative(light);
    for (int i = 0; i < 3; ++i) {
        const float stops = std::log2(std::max(c[i], 1e-10f) / 0.18f);
        const float place = (stops - Sigmoid::darkest) / (Sigmoid::brightest - Sigmoid::darkest);
        c[i] = curve(std::clamp(place, 0.0f, 1.0f));
    }
    c = outset * c;
    for (int i = 0; i < 3; ++i) {
        c[i] = std::pow(std::clamp(c[i], 0.0f, 1.0f), 2.2f);
    }
    return c;
}

ViewTransform::ViewTransform(View view, double exposure) : view_(view), scale_(static_cast<float>(std::exp2(exposure))) {
    if (view == View::aces) {
        std::array<glm::vec3, 1> probe{glm::vec3(0.18f)};
        apply_aces(probe);
    }
}

void ViewTransform::apply(std::span<glm::vec3> colors) const {
    for (glm::vec3& color : colors) {
        color *= scale_;
        switch (view_) {
            case View::srgb:
                break;
            case View::pbr_neutral:
                color = pbr_neutral(color);
                break;
            case View::agx:
                color = agx(color);
                break;
            case View::aces:
                color = not_negative(color);
                break;
        }
    }
    if (view_ == View::aces) {
        apply_aces(colors);
        for (glm::vec3& color : colors) {  // colours of ACES that the display does not have
            color = glm::clamp(color, 0.0f, 1.0f);
        }
    }
}

}  // namespace lancer
