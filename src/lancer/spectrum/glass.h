// Refractive indices of transparent materials.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lancer {

// n^2 = 1 + sum B_i L^2 / (L^2 - C_i), L in micrometres, C_i in square micrometres [Sellmeier 1871].
struct Sellmeier {
    std::array<double, 3> b{};
    std::array<double, 3> c{};

    double index(double wavelength_nm) const;
};

// By catalogue name ("N-BK7", "SF11", "water", "diamond", ...); letter case, spaces and hyphens make no difference. In air, 20 C.
std::optional<Sellmeier> find_glass(std::string_view name);
std::vector<std::string> glass_names();

// Cauchy's n = a + b / L^2 through an index at the d line (587.56 nm) and an Abbe number; n at a wavelength.
double abbe_index(double index_d, double abbe_number, double wavelength_nm);

// The Abbe number (n_d - 1) / (n_F - n_C) of a glass.
double abbe_number(const Sellmeier& glass);

}  // namespace lancer
