#include "lancer/spectrum/curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "lancer/spectrum/cie_1931.h"
#include "lancer/spectrum/observer.h"

namespace lancer {
namespace {

constexpr double observer_first = cie_1931_first;
constexpr double observer_last = cie_1931_first + cie_1931_step * (cie_1931_count - 1);

// Where the observer or a curve bends.
std::vector<double> knots_of(const SpectralCurve& a, const SpectralCurve& b) {
    std::vector<double> knots;
    for (double nm = observer_first; nm <= observer_last; nm += 1.0) {
        knots.push_back(nm);
    }
    for (const SpectralCurve* curve : {&a, &b}) {
        for (const double nm : curve->nanometres()) {
            if (nm > observer_first && nm < observer_last) {
                knots.push_back(nm);
            }
        }
    }
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    return knots;
}

// Integral of a b xyz. Between knots that is a product of three straight lines, for which Gauss's rule with two points is exact; and as the
// points lie inside, it does not matter that a curve may jump at its ends.
glm::dvec3 integrate(const SpectralCurve& a, const SpectralCurve& b) {
    const std::vector<double> knots = knots_of(a, b);
    const double offset = 0.5 / std::sqrt(3.0);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double width = knots[i + 1] - knots[i];
        const double middle = 0.5 * (knots[i] + knots[i + 1]);
        for (const double nm : {middle - offset * width, middle + offset * width}) {
            sum += 0.5 * width * a.at(nm) * b.at(nm) * cie_1931_fine(nm);
        }
    }
    return sum;
}

}  // namespace

SpectralCurve::SpectralCurve(double value) : nanometres_{555.0}, values_{value}, beyond_(Beyond::constant) {}

SpectralCurve::SpectralCurve(std::vector<double> nanometres, std::vector<double> values, Beyond beyond)
    : nanometres_(std::move(nanometres)), values_(std::move(values)), beyond_(beyond) {
    assert(!nanometres_.empty() && nanometres_.size() == values_.size());
    assert(std::adjacent_find(nanometres_.begin(), nanometres_.end(), std::greater_equal<>()) == nanometres_.end());
}

double SpectralCurve::at(double nanometres) const {
    const auto above = std::upper_bound(nanometres_.begin(), nanometres_.end(), nanometres);
    if (above == nanometres_.begin()) {
        return beyond_ == Beyond::zero ? 0.0 : values_.front();
    }
    if (above == nanometres_.end()) {
        return beyond_ == Beyond::zero && nanometres > nanometres_.back() ? 0.0 : values_.back();
    }
    const auto i = static_cast<std::size_t>(above - nanometres_.begin());
    const double t = (nanometres - nanometres_[i - 1]) / (nanometres_[i] - nanometres_[i - 1]);
    return values_[i - 1] + t * (values_[i] - values_[i - 1]);
}

std::vector<double> SpectralCurve::on(const SpectralGrid& grid) const {
    std::vector<double> result;
    result.reserve(static_cast<std::size_t>(grid.count));
    for (int i = 0; i < grid.count; ++i) {
        result.push_back(at(grid.first + grid.step * i));
    }
    return result;
}

SpectralCurve SpectralCurve::scaled(double factor) const {
    SpectralCurve result = *this;
    for (double& value : result.values_) {
        value *= factor;
    }
    return result;
}

SpectralCurve SpectralCurve::with_ends(Beyond beyond) const {
    SpectralCurve result = *this;
    result.beyond_ = beyond;
    return result;
}

double SpectralCurve::highest() const { return *std::max_element(values_.begin(), values_.end()); }
double SpectralCurve::lowest() const { return *std::min_element(values_.begin(), values_.end()); }

glm::dvec3 to_xyz(const SpectralCurve& light) { return integrate(light, SpectralCurve(1.0)) / cie_1931_area(); }

glm::dvec3 to_xyz(const SpectralCurve& reflectance, const SpectralCurve& light) {
    const double white = integrate(light, SpectralCurve(1.0)).y;
    return white > 0.0 ? integrate(reflectance, light) / white : glm::dvec3(0.0);
}

glm::dvec3 to_xyz_by_sums(const SpectralCurve& light) {
    glm::dvec3 sum(0.0);
    double area = 0.0;
    for (int nm = 380; nm <= 780; nm += 5) {
        sum += light.at(nm) * cie_1931(nm);
        area += cie_1931(nm).y;
    }
    return sum / area;
}

glm::dvec2 chromaticity(const glm::dvec3& xyz) {
    const double sum = xyz.x + xyz.y + xyz.z;
    return sum > 0.0 ? glm::dvec2(xyz.x, xyz.y) / sum : glm::dvec2(0.0);
}

SpectralCurve with_unit_luminance(const SpectralCurve& light) {
    const double luminance = to_xyz(light).y;
    return luminance > 1e-300 ? light.scaled(1.0 / luminance) : light;
}

}  // namespace lancer
