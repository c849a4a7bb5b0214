#include "lancer/spectrum/sensor.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/observer.h"

namespace lancer {
namespace {

glm::dvec3 to_sensor_rgb(const glm::dvec3& xyz) {
    static const glm::dmat3 matrix = glm::inverse(rgb_to_xyz_matrix(to_xyz(unit_d65())));
    return matrix * xyz;
}

}  // namespace

glm::dvec3 sensor_weight(double nanometres) { return to_sensor_rgb(cie_1931_fine(nanometres) / cie_1931_area()); }

glm::dvec3 to_rgb(const SpectralCurve& light) { return to_sensor_rgb(to_xyz(light)); }

glm::dvec3 reflected_rgb(const SpectralCurve& reflectance) { return to_sensor_rgb(to_xyz(reflectance, unit_d65())); }

}  // namespace lancer
