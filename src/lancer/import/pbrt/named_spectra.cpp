#include "lancer/import/pbrt/named_spectra.h"

#include "lancer/spectrum/glass.h"
#include "lancer/spectrum/illuminant.h"
#include "lancer/spectrum/metal.h"

namespace lancer::pbrt {

namespace {

// What stands between two parts of a name; empty when it has not both.
std::string between(std::string_view name, std::string_view before, std::string_view after) {
    if (name.size() <= before.size() + after.size() || !name.starts_with(before) || !name.ends_with(after)) {
        return {};
    }
    return std::string(name.substr(before.size(), name.size() - before.size() - after.size()));
}

}  // namespace

std::string metal_of(std::string_view name) {
    const std::string eta = between(name, "metal-", "-eta");
    const std::string metal = eta.empty() ? between(name, "metal-", "-k") : eta;
    return find_metal(metal) ? metal : std::string();
}

std::string glass_of(std::string_view name) {
    const std::string melt = between(name, "glass-", "");
    for (const std::string& spelled : {melt, "N-" + melt}) {
        if (!melt.empty() && find_glass(spelled)) {
            return spelled;
        }
    }
    return {};
}

std::optional<SpectralCurve> find_named_spectrum(std::string_view name) {
    if (const std::string metal = metal_of(name); !metal.empty()) {
        const Metal found = find_metal(metal).value();
        return (name.ends_with("-k") ? found.k : found.n).with_ends(SpectralCurve::Beyond::zero);
    }
    if (const std::string glass = glass_of(name); !glass.empty()) {
        const Sellmeier found = find_glass(glass).value();
        std::vector<double> nanometres, values;
        for (int i = 0; i < coarse_grid.count; ++i) {
            nanometres.push_back(coarse_grid.first + i * coarse_grid.step);
            values.push_back(found.index(nanometres.back()));
        }
        return SpectralCurve(std::move(nanometres), std::move(values), SpectralCurve::Beyond::zero);
    }
    if (const std::string illuminant = between(name, "stdillum-", ""); !illuminant.empty()) {
        return find_illuminant(illuminant);
    }
    if (name == "illum-acesD60") {
        return find_illuminant("D60");
    }
    return std::nullopt;
}

}  // namespace lancer::pbrt
