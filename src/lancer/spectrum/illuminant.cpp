#include "lancer/spectrum/illuminant.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>

#include "lancer/spectrum/fluorescent.h"

namespace lancer {
namespace {

// The mean of measured daylights, S0, and how they differ most, S1 and S2 [Judd et al. 1964]: 300 to 830 nm, every 10 nm.
constexpr int daylight_count = 54;
const std::array<std::array<double, 3>, daylight_count> daylight_components = {{
    {0.04, 0.02, 0.0},    // 300
    {6.0, 4.5, 2.0},      // 310
    {29.6, 22.4, 4.0},    // 320
    {55.3, 42.0, 8.5},    // 330
    {57.3, 40.6, 7.8},    // 340
    {61.8, 41.6, 6.7},    // 350
    {61.5, 38.0, 5.3},    // 360
    {68.8, 42.4, 6.1},    // 370
    {63.4, 38.5, 3.0},    // 380
    {65.8, 35.0, 1.2},    // 390
    {94.8, 43.4, -1.1},   // 400
    {104.8, 46.3, -0.5},  // 410
    {105.9, 43.9, -0.7},  // 420
    {96.8, 37.1, -1.2},   // 430
    {113.9, 36.7, -2.6},  // 440
    {125.6, 35.9, -2.9},  // 450
    {125.5, 32.6, -2.8},  // 460
    {121.3, 27.9, -2.6},  // 470
    {121.3, 24.3, -2.6},  // 480
    {113.5, 20.1, -1.8},  // 490
    {113.1, 16.2, -1.5},  // 500
    {110.8, 13.2, -1.3},  // 510
    {106.5, 8.6, -1.2},   // 520
    {108.8, 6.1, -1.0},   // 530
    {105.3, 4.2, -0.5},   // 540
    {104.4, 1.9, -0.3},   // 550
    {100.0, 0.0, 0.0},    // 560
    {96.0, -1.6, 0.2},    // 570
    {95.1, -3.5, 0.5},    // 580
    {89.1, -3.5, 2.1},    // 590
    {90.5, -5.8, 3.2},    // 600
    {90.3, -7.2, 4.1},    // 610
    {88.4, -8.6, 4.7},    // 620
    {84.0, -9.5, 5.1},    // 630
    {85.1, -10.9, 6.7},   // 640
    {81.9, -10.7, 7.3},   // 650
    {82.6, -12.0, 8.6},   // 660
    {84.9, -14.0, 9.8},   // 670
    {81.3, -13.6, 10.2},  // 680
    {71.9, -12.0, 8.3},   // 690
    {74.3, -13.3, 9.6},   // 700
    {76.4, -12.9, 8.5},   // 710
    {63.3, -10.6, 7.0},   // 720
    {71.7, -11.6, 7.6},   // 730
    {77.0, -12.2, 8.0},   // 740
    {65.2, -10.2, 6.7},   // 750
    {47.7, -7.8, 5.2},    // 760
    {68.6, -11.2, 7.4},   // 770
    {65.0, -10.4, 6.8},   // 780
    {66.0, -10.6, 7.0},   // 790
    {61.0, -9.7, 6.4},    // 800
    {53.3, -8.3, 5.5},    // 810
    {58.9, -9.3, 6.1},    // 820
    {61.9, -9.8, 6.5},    // 830
}};

// Illuminant C, 320 to 780 nm, every 5 nm [CIE 15:2004].
const std::array<double, 93> illuminant_c = {
    0.01,   0.20,   0.40,   1.55,   2.70,   4.85,   7.00,   9.95,   12.90,  17.20,  21.40,  27.50,  33.00,  39.92,  47.40,  55.17,   // 320
    63.30,  71.81,  80.60,  89.53,  98.10,  105.80, 112.40, 117.75, 121.50, 123.45, 124.00, 123.60, 123.10, 123.30, 123.80, 124.09,  // 400
    123.90, 122.92, 120.70, 116.90, 112.10, 106.98, 102.30, 98.81,  96.90,  96.78,  98.00,  99.94,  102.10, 103.95, 105.20, 105.67,  // 480
    105.30, 104.11, 102.30, 100.15, 97.80,  95.43,  93.20,  91.22,  89.70,  88.83,  88.40,  88.19,  88.10,  88.06,  88.00,  87.86,   // 560
    87.80,  87.99,  88.20,  88.20,  87.90,  87.22,  86.30,  85.30,  84.00,  82.21,  80.20,  78.24,  76.30,  74.36,  72.40,  70.40,   // 640
    68.30,  66.30,  64.40,  62.80,  61.50,  60.20,  59.20,  58.50,  58.10,  58.00,  58.20,  58.50,  59.10,                           // 720
};

std::vector<double> wavelengths(double first, double step, std::size_t count) {
    std::vector<double> result;
    for (std::size_t i = 0; i < count; ++i) {
        result.push_back(first + step * static_cast<double>(i));
    }
    return result;
}

template <class Table>
SpectralCurve tabulated(double first, double step, const Table& table) {
    return {wavelengths(first, step, std::size(table)), {std::begin(table), std::end(table)}, SpectralCurve::Beyond::zero};
}

// A formula, tabulated finely enough that straight lines differ from it by less than 1e-5.
template <class Formula>
SpectralCurve tabulated_formula(double first, double last, const Formula& formula) {
    const std::vector<double> nm = wavelengths(first, 1.0, static_cast<std::size_t>(last - first) + 1);
    std::vector<double> values;
    for (const double l : nm) {
        values.push_back(formula(l));
    }
    return {nm, values, SpectralCurve::Beyond::zero};
}

// [CIE 15:2004, 3.1], with the c2 of 1931 that belongs to the nominal 2848 K.
SpectralCurve illuminant_a() {
    return tabulated_formula(300.0, 1100.0, [](double nm) {
        constexpr double exponent = 1.435e7 / 2848.0;  // nm
        return 100.0 * std::pow(560.0 / nm, 5.0) * std::expm1(exponent / 560.0) / std::expm1(exponent / nm);
    });
}

std::string simplified(std::string_view name) {
    std::string result;
    for (const char c : name) {
        if (c != ' ' && c != '-' && c != '_') {
            result += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        }
    }
    return result.rfind("CIE", 0) == 0 ? result.substr(3) : result;
}

std::optional<int> number_after(const std::string& name, std::string_view prefix) {
    if (name.rfind(prefix, 0) != 0) {
        return std::nullopt;
    }
    int number = 0;
    const char* const last = name.data() + name.size();
    const auto [end, error] = std::from_chars(name.data() + prefix.size(), last, number);
    return error == std::errc() && end == last ? std::optional(number) : std::nullopt;
}

}  // namespace

SpectralCurve daylight(double kelvin) {
    const double t = 1e3 / std::clamp(kelvin, 4000.0, 25000.0);
    const double x = kelvin <= 7000.0 ? ((-4.6070 * t + 2.9678) * t + 0.09911) * t + 0.244063  //
                                      : ((-2.0064 * t + 1.9018) * t + 0.24748) * t + 0.237040;
    const double y = (-3.0 * x + 2.870) * x - 0.275;
    const double divisor = 0.0241 + 0.2562 * x - 0.7341 * y;
    // To three decimals, as the CIE prescribes.
    const double m1 = std::round(1e3 * (-1.3515 - 1.7703 * x + 5.9114 * y) / divisor) * 1e-3;
    const double m2 = std::round(1e3 * (0.0300 - 31.4424 * x + 30.0717 * y) / divisor) * 1e-3;
    std::vector<double> values;
    for (const auto& s : daylight_components) {
        values.push_back(std::max(0.0, s[0] + m1 * s[1] + m2 * s[2]));
    }
    return tabulated(300.0, 10.0, values);
}

double blackbody_radiance(double kelvin, double nanometres) {
    assert(kelvin > 0.0 && nanometres > 0.0);
    constexpr double planck = 6.62607015e-34;    // J s [CODATA 2018]
    constexpr double light_speed = 299792458.0;  // m/s
    constexpr double boltzmann = 1.380649e-23;   // J/K
    const double l = nanometres * 1e-9;          // m
    const double exponent = planck * light_speed / (l * boltzmann * kelvin);
    return 2.0 * planck * light_speed * light_speed / std::pow(l, 5.0) / std::expm1(exponent) * 1e-9;
}

SpectralCurve blackbody(double kelvin) {
    return tabulated_formula(300.0, 1100.0, [&](double nm) { return blackbody_radiance(kelvin, nm); });
}

std::optional<SpectralCurve> find_illuminant(std::string_view name) {
    const std::string wanted = simplified(name);
    if (wanted == "A") {
        return illuminant_a();
    }
    if (wanted == "C") {
        return tabulated(320.0, 5.0, illuminant_c);
    }
    if (wanted == "E") {
        return SpectralCurve(100.0);
    }
    if (const auto hundreds = number_after(wanted, "D"); hundreds && *hundreds >= 40 && *hundreds <= 250) {
        return daylight(std::clamp(*hundreds * 100.0 * 1.4388 / 1.4380, 4000.0, 25000.0));
    }
    for (const char* prefix : {"FL", "F"}) {
        if (const auto number = number_after(wanted, prefix); number && *number >= 1 && *number <= fluorescent_count) {
            return tabulated(fluorescent_first, fluorescent_step, fluorescent_table[static_cast<std::size_t>(*number - 1)]);
        }
    }
    return std::nullopt;
}

std::vector<std::string> illuminant_names() {
    std::vector<std::string> names = {"A", "C", "D50", "D55", "D60", "D65", "D75", "E"};
    for (int i = 1; i <= fluorescent_count; ++i) {
        names.push_back("FL" + std::to_string(i));
    }
    return names;
}

const SpectralCurve& unit_d65() {
    static const SpectralCurve curve = with_unit_luminance(*find_illuminant("D65"));
    return curve;
}

}  // namespace lancer
