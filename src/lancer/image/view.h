// How linear light becomes what a display shows: exposure, then one of a few curves for what is too bright for it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace lancer {

enum class View {
    srgb,         // as it is; what is brighter than white is clipped
    pbr_neutral,  // Khronos PBR Neutral: base colours as they are, highlights compressed [Khronos 2024]
    agx,          // after AgX: a film-like curve of the logarithm, bright colours go to white
    aces          // the output transform of ACES 1 for SDR video
};

const std::vector<std::string>& view_names();  // "srgb", "pbr-neutral", "agx", "aces": in the order of View
std::optional<View> find_view(std::string_view name);
std::string_view name_of(View view);

// Linear Rec. 709 to linear Rec. 709 of the display, 1 its white.
glm::vec3 pbr_neutral(const glm::vec3& light);
glm::vec3 agx(const glm::vec3& light);

class ViewTransform {
public:
    ViewTransform() = default;
    // `exposure` in stops. Throws MachineFailure where the view needs a part of lancer that is not there (aces: OpenColorIO).
    ViewTransform(View view, double exposure);

    // From scene light to the display's, linear. May be called by several threads.
    void apply(std::span<glm::vec3> colors) const;

private:
    View view_ = View::srgb;
    float scale_ = 1.0f;
};

}  // namespace lancer
