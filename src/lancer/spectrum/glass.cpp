#include "lancer/spectrum/glass.h"

#include <cctype>
#include <cmath>
#include <string>

namespace lancer {
namespace {

constexpr double line_d = 587.5618;  // nm, helium
constexpr double line_f = 486.1327;  // nm, hydrogen
constexpr double line_c = 656.2725;  // nm, hydrogen

struct CataloguedGlass {
    const char* name;
    Sellmeier sellmeier;
};

// In air, 20 C. The Schott rows are the coefficients of the catalogue of 2017-01-20; the sources of the others stand beside them. Where a
// source gives four terms, the two ultraviolet ones that lie closest together are refitted as one over 370 to 800 nm: the difference in n is
// below 1e-8.
const CataloguedGlass catalogue[] = {
    {"N-BK7", {{1.03961212, 0.231792344, 1.01046945}, {0.00600069867, 0.0200179144, 103.560653}}},
    {"N-BAK4", {{1.28834642, 0.132817724, 0.945395373}, {0.00779980626, 0.0315631177, 105.965875}}},
    {"N-BAF10", {{1.5851495, 0.143559385, 1.08521269}, {0.00926681282, 0.0424489805, 105.613573}}},
    {"N-FK51A", {{0.971247817, 0.216901417, 0.904651666}, {0.00472301995, 0.0153575612, 168.68133}}},
    {"N-KZFS2", {{1.23697554, 0.153569376, 0.903976272}, {0.00747170505, 0.0308053556, 70.1731084}}},
    {"N-LAK33B", {{1.42288601, 0.593661336, 1.1613526}, {0.00670283452, 0.021941621, 80.7407701}}},
    {"N-LASF9", {{2.00029547, 0.298926886, 1.80691843}, {0.0121426017, 0.0538736236, 156.530829}}},
    {"N-SK16", {{1.34317774, 0.241144399, 0.994317969}, {0.00704687339, 0.0229005, 92.7508526}}},
    {"N-F2", {{1.39757037, 0.159201403, 1.2686543}, {0.00995906143, 0.0546931752, 119.248346}}},
    {"F2", {{1.34533359, 0.209073176, 0.937357162}, {0.00997743871, 0.0470450767, 111.886764}}},
    {"N-SF10", {{1.62153902, 0.256287842, 1.64447552}, {0.0122241457, 0.0595736775, 147.468793}}},
    {"SF10", {{1.61625977, 0.259229334, 1.07762317}, {0.0127534559, 0.0581983954, 116.60768}}},
    {"N-SF11", {{1.73759695, 0.313747346, 1.89878101}, {0.013188707, 0.0623068142, 155.23629}}},
    {"SF11", {{1.73848403, 0.311168974, 1.17490871}, {0.0136068604, 0.0615960463, 121.922711}}},
    // [Malitson 1965], whose formula gives the square roots of the C.
    {"fused silica", {{0.6961663, 0.4079426, 0.8974794}, {0.0684043 * 0.0684043, 0.1162414 * 0.1162414, 9.896161 * 9.896161}}},
    // [Daimon and Masumura 2002], calcium fluoride in nitrogen; four terms there.
    {"fluorite", {{0.584330018, 0.454483998, 8.85319946}, {0.00251050091, 0.0103303354, 2752.28175}}},
    // [Malitson and Dodge 1972], the ordinary ray.
    {"sapphire", {{1.4313493, 0.65054713, 5.3414021}, {0.0726631 * 0.0726631, 0.1193242 * 0.1193242, 18.028251 * 18.028251}}},
    // [Peter 1923]
    {"diamond", {{0.3306, 4.3356, 0.0}, {0.1750 * 0.1750, 0.1060 * 0.1060, 0.0}}},
    // [Daimon and Masumura 2007], distilled; four terms there.
    {"water", {{0.595127632, 0.166754606, 0.1130748688}, {0.00536724511, 0.0203666552, 10.69792721}}},
    // Ours: fitted over 390 to 800 nm to the table of [Warren and Brandt 2008], -7 C, within 1e-4 (the table is rounded to 1e-4).
    {"ice", {{0.700561, 0.113215, 0.0}, {0.00906567, 10.0, 0.0}}},
    // Poly(methyl methacrylate): the measurements of [Sultanova et al. 2009], good to 1e-3.
    {"acrylic", {{1.1819, 0.0, 0.0}, {0.011313, 0.0, 0.0}}},
};

struct Alias {
    const char* name;
    const char* glass;
};

const Alias aliases[] = {
    {"BK7", "N-BK7"},  // the older melt has the same coefficients
    {"silica", "fused silica"},
    {"PMMA", "acrylic"},
    {"CaF2", "fluorite"},
};

// Letter case, spaces, hyphens and underscores make no difference.
std::string simplified(std::string_view name) {
    std::string result;
    for (const char c : name) {
        if (c != ' ' && c != '-' && c != '_') {
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
    }
    return result;
}

}  // namespace

double Sellmeier::index(double wavelength_nm) const {
    const double square = wavelength_nm * wavelength_nm * 1e-6;  // um^2
    double n_square = 1.0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        n_square += b[i] * square / (square - c[i]);
    }
    return std::sqrt(n_square);
}

std::optional<Sellmeier> find_glass(std::string_view name) {
    std::string wanted = simplified(name);
    for (const Alias& alias : aliases) {
        if (simplified(alias.name) == wanted) {
            wanted = simplified(alias.glass);
        }
    }
    for (const CataloguedGlass& glass : catalogue) {
        if (simplified(glass.name) == wanted) {
            return glass.sellmeier;
        }
    }
    return std::nullopt;
}

std::vector<std::string> glass_names() {
    std::vector<std::string> names;
    for (const CataloguedGlass& glass : catalogue) {
        names.emplace_back(glass.name);
    }
    return names;
}

double abbe_index(double index_d, double abbe_number, double wavelength_nm) {
    const auto inverse_square = [](double nm) { return 1e6 / (nm * nm); };  // um^-2
    const double b = (index_d - 1.0) / abbe_number / (inverse_square(line_f) - inverse_square(line_c));
    return index_d + b * (inverse_square(wavelength_nm) - inverse_square(line_d));
}

double abbe_number(const Sellmeier& glass) { return (glass.index(line_d) - 1.0) / (glass.index(line_f) - glass.index(line_c)); }

}  // namespace lancer
