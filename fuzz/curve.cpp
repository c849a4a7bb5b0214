// Any bytes as measured curves: curves of finite values at rising wavelengths, or at least one error.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "lancer/spectrum/curve_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    for (const int columns : {1, 2}) {
        lancer::Diagnostics diagnostics;
        const auto curves = lancer::parse_curves({reinterpret_cast<const char*>(data), size}, "fuzz.csv", columns,
                                                 lancer::SpectralCurve::Beyond::constant, diagnostics);
        if (curves.has_value() == diagnostics.has_errors() || diagnostics.list().size() > 20) {
            std::abort();
        }
        if (curves) {
            for (const lancer::SpectralCurve& curve : *curves) {
                for (std::size_t i = 0; i < curve.values().size(); ++i) {
                    if (!std::isfinite(curve.at(curve.nanometres()[i])) || (i > 0 && curve.nanometres()[i] <= curve.nanometres()[i - 1])) {
                        std::abort();
                    }
                }
            }
        }
    }
    return 0;
}
