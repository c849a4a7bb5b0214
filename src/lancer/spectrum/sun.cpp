#include "lancer/spectrum/sun.h"

#include <vector>

namespace lancer {

namespace {

struct Line {
    double nanometres, irradiance, ozone;
};

// The light that one sees, of a table that goes on to 4000 nm.
const Line table[] = {
    {350.0, 0.9755, 0.007}, {360.0, 0.9759, 0.0},  {370.0, 1.1199, 0.0},  {380.0, 1.1038, 0.0},  {390.0, 1.0338, 0.0},
    {400.0, 1.4791, 0.0},   {410.0, 1.7013, 0.0},  {420.0, 1.7404, 0.0},  {430.0, 1.5872, 0.0},  {440.0, 1.837, 0.0},
    {450.0, 2.005, 0.003},  {460.0, 2.043, 0.006}, {470.0, 1.987, 0.009}, {480.0, 2.027, 0.014}, {490.0, 1.896, 0.021},
    {500.0, 1.909, 0.030},  {510.0, 1.927, 0.040}, {520.0, 1.831, 0.048}, {530.0, 1.891, 0.063}, {540.0, 1.898, 0.075},
    {550.0, 1.892, 0.085},  {570.0, 1.840, 0.120}, {593.0, 1.768, 0.119}, {610.0, 1.728, 0.120}, {630.0, 1.658, 0.090},
    {656.0, 1.524, 0.065},  {667.6, 1.531, 0.051}, {690.0, 1.420, 0.028}, {710.0, 1.399, 0.018}, {718.0, 1.374, 0.015},
    {724.4, 1.373, 0.012},  {740.0, 1.298, 0.010}, {752.5, 1.269, 0.008}, {757.5, 1.245, 0.007}, {762.5, 1.223, 0.006},
    {767.5, 1.205, 0.005},  {780.0, 1.183, 0.0},   {800.0, 1.148, 0.0},   {816.0, 1.091, 0.0},   {823.7, 1.062, 0.0},
    {831.5, 1.038, 0.0},    {840.0, 1.022, 0.0},
};

SpectralCurve column(double Line::*value, SpectralCurve::Beyond beyond) {
    std::vector<double> nanometres, values;
    for (const Line& line : table) {
        nanometres.push_back(line.nanometres);
        values.push_back(line.*value);
    }
    return {std::move(nanometres), std::move(values), beyond};
}

}  // namespace

const SpectralCurve& sun_outside_air() {
    static const SpectralCurve curve = column(&Line::irradiance, SpectralCurve::Beyond::zero);
    return curve;
}

const SpectralCurve& ozone_absorption() {
    static const SpectralCurve curve = column(&Line::ozone, SpectralCurve::Beyond::constant);
    return curve;
}

}  // namespace lancer
