#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lancer/spectrum/curve_file.h"
#include "lancer/spectrum/metal.h"
#include "lancer/spectrum/sensor.h"

namespace lancer {
namespace {

namespace fs = std::filesystem;

// Measurements that others published as files, where there is a collection of them: named by LANCER_REFERENCE, or beside the source folder.
std::optional<fs::path> reference_spectra() {
    const char* named = std::getenv("LANCER_REFERENCE");
    const fs::path folder = named ? fs::path(named) : fs::path(LANCER_SOURCE_FOLDER) / ".." / "shared" / "reference";
    return fs::exists(folder / "spectra") ? std::optional(folder / "spectra") : std::nullopt;
}

double reflectance_at(const Metal& metal, double nm) { return normal_reflectance(metal.n.at(nm), metal.k.at(nm)); }

SpectralCurve reflectance_of(const Metal& metal) {
    std::vector<double> nm, r;
    for (double l = 360.0; l <= 830.0; l += 1.0) {
        nm.push_back(l);
        r.push_back(reflectance_at(metal, l));
    }
    return {nm, r, SpectralCurve::Beyond::constant};
}

TEST(Metal, NamesAndSymbols) {
    for (const std::string& name : metal_names()) {
        const auto metal = find_metal(name);
        ASSERT_TRUE(metal) << name;
        EXPECT_LE(metal->n.nanometres().front(), 360.0) << name;
        EXPECT_GE(metal->n.nanometres().back(), 830.0) << name;
        EXPECT_GT(metal->n.lowest(), 0.0) << name;
        EXPECT_GT(metal->k.lowest(), 0.5) << name;
    }
    EXPECT_EQ(find_metal("Aluminum")->n.values(), find_metal("al")->n.values());
    EXPECT_EQ(find_metal("stainless-steel")->n.values(), find_metal("STEEL")->n.values());
    EXPECT_NE(find_metal("Co")->n.values(), find_metal("Cu")->n.values());
    EXPECT_FALSE(find_metal("unobtainium"));
    EXPECT_FALSE(find_metal(""));
}

// No table has a slip of the pen: from one wavelength to the next, nothing jumps.
TEST(Metal, CurvesAreSmooth) {
    for (const std::string& name : metal_names()) {
        const Metal metal = find_metal(name).value();
        for (double nm = 360.0; nm < 830.0; nm += 5.0) {
            EXPECT_LT(std::fabs(reflectance_at(metal, nm + 5.0) - reflectance_at(metal, nm)), 0.06) << name << " at " << nm;
        }
        const auto bends = [&](const SpectralCurve& curve) {
            double worst = 0.0;  // how far a value lies from the line through its neighbours
            const auto& x = curve.nanometres();
            const auto& y = curve.values();
            for (std::size_t i = 1; i + 1 < x.size(); ++i) {
                const double t = (x[i] - x[i - 1]) / (x[i + 1] - x[i - 1]);
                worst = std::max(worst, std::fabs(y[i] - y[i - 1] - t * (y[i + 1] - y[i - 1])));
            }
            return worst;
        };
        EXPECT_LT(bends(metal.n), 0.25) << name;
        EXPECT_LT(bends(metal.k), 0.25) << name;
    }
}

// What handbooks say that polished or freshly evaporated metals reflect of yellow-green light, and their colours.
TEST(Metal, ReflectanceAndColour) {
    const std::pair<const char*, double> known[] = {{"silver", 0.98},   {"aluminium", 0.915}, {"gold", 0.80},  {"copper", 0.62},
                                                    {"nickel", 0.61},   {"chromium", 0.55},   {"iron", 0.52},  {"platinum", 0.66},
                                                    {"titanium", 0.56}, {"tungsten", 0.50},   {"brass", 0.79}, {"palladium", 0.70},
                                                    {"zinc", 0.87},     {"cobalt", 0.67},     {"steel", 0.58}};
    for (const auto& [name, expected] : known) {
        EXPECT_NEAR(reflectance_at(find_metal(name).value(), 550.0), expected, 0.04) << name;
    }
    const glm::dvec3 gold_color = reflected_rgb(reflectance_of(find_metal("gold").value()));
    EXPECT_GT(gold_color.r, 0.95);
    EXPECT_NEAR(gold_color.g, 0.75, 0.05);
    EXPECT_NEAR(gold_color.b, 0.35, 0.05);
    const glm::dvec3 copper_color = reflected_rgb(reflectance_of(find_metal("copper").value()));
    EXPECT_GT(copper_color.r, 0.9);
    EXPECT_GT(copper_color.g, copper_color.b);
    const glm::dvec3 silver_color = reflected_rgb(reflectance_of(find_metal("silver").value()));
    EXPECT_GT(std::min({silver_color.r, silver_color.g, silver_color.b}), 0.95);
}

// [Rakić et al. 1998] give platinum and tungsten as formulas; values that others computed from them.
TEST(Metal, LorentzDrudeModel) {
    const Metal platinum = find_metal("Pt").value(), tungsten = find_metal("W").value();
    EXPECT_NEAR(platinum.n.at(551.23), 2.0939, 3e-4);
    EXPECT_NEAR(platinum.k.at(551.23), 3.7106, 3e-4);
    EXPECT_NEAR(platinum.n.at(399.83), 1.7237, 3e-4);
    EXPECT_NEAR(tungsten.n.at(551.23), 3.4586, 3e-4);
    EXPECT_NEAR(tungsten.k.at(551.23), 2.7601, 3e-4);
    EXPECT_NEAR(tungsten.k.at(699.96), 2.8371, 3e-4);
}

// Rows "micrometres n k" of a file.
std::vector<std::array<double, 3>> rows_of(const fs::path& path) {
    std::vector<std::array<double, 3>> rows;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::array<double, 3> row{};
        if (words >> row[0] >> row[1] >> row[2]) {
            rows.push_back(row);
        }
    }
    return rows;
}

TEST(Metal, TablesAgreeWithThoseOfOthers) {
    const auto folder = reference_spectra();
    if (!folder) {
        GTEST_SKIP() << "no collection of files: set LANCER_REFERENCE";
    }
    const std::pair<const char*, const char*> same[] = {
        {"Ag", "main_Ag_Johnson.yml"}, {"Au", "main_Au_Johnson.yml"}, {"Cu", "main_Cu_Johnson.yml"}, {"Al", "main_Al_Rakic.yml"}};
    for (const auto& [symbol, file] : same) {
        const Metal metal = find_metal(symbol).value();
        int compared = 0;
        for (const auto& row : rows_of(*folder / "nk" / file)) {
            const double nm = row[0] * 1000.0;
            if (nm >= 360.0 && nm <= 830.0) {
                EXPECT_NEAR(metal.n.at(nm), row[1], 5e-5 + 1e-4 * row[1]) << symbol << " at " << nm;
                EXPECT_NEAR(metal.k.at(nm), row[2], 5e-5 + 1e-4 * row[2]) << symbol << " at " << nm;
                ++compared;
            }
        }
        EXPECT_GE(compared, 12) << file;
    }
    // Other measurements of the same metals reflect about as much; chromium least so, whose films oxidise.
    for (const char* symbol : {"Ag", "Au", "Cr", "W"}) {
        Diagnostics diagnostics;
        const auto n = read_curve((*folder / "spd-metals" / (std::string(symbol) + ".eta.spd")).string(), {},
                                  SpectralCurve::Beyond::constant, diagnostics);
        const auto k = read_curve((*folder / "spd-metals" / (std::string(symbol) + ".k.spd")).string(), {}, SpectralCurve::Beyond::constant,
                                  diagnostics);
        ASSERT_TRUE(n && k) << symbol;
        EXPECT_TRUE(diagnostics.list().empty()) << to_string(diagnostics.list().front());
        const Metal metal = find_metal(symbol).value();
        double difference = 0.0;
        for (double nm = 400.0; nm <= 700.0; nm += 10.0) {
            difference += std::fabs(normal_reflectance(n->at(nm), k->at(nm)) - reflectance_at(metal, nm)) / 31.0;
        }
        EXPECT_LT(difference, std::string(symbol) == "Cr" ? 0.12 : 0.06) << symbol;
    }
}

// Each file of measurements that others ship can be read.
TEST(CurveFile, FilesOfOthers) {
    const auto folder = reference_spectra();
    if (!folder) {
        GTEST_SKIP() << "no collection of files: set LANCER_REFERENCE";
    }
    int read = 0;
    for (const char* part : {"illuminants", "spd-metals", "colorchecker-ohta", "cornell"}) {
        for (const auto& entry : fs::directory_iterator(*folder / part)) {
            Diagnostics diagnostics;
            EXPECT_TRUE(read_curve(entry.path().string(), {}, SpectralCurve::Beyond::zero, diagnostics)) << entry.path();
            for (const Diagnostic& diagnostic : diagnostics.list()) {
                ADD_FAILURE() << to_string(diagnostic);
            }
            ++read;
        }
    }
    EXPECT_GT(read, 50);
}

}  // namespace
}  // namespace lancer
