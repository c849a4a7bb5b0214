// Any bytes as a photometric file: intensities of finite angles and values in order, or an error.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "lancer/import/ies/ies.h"

namespace {

void require(bool right) {
    if (!right) {
        std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    lancer::Diagnostics diagnostics;
    const auto read = lancer::read_ies({reinterpret_cast<const char*>(data), size}, "fuzz.ies", diagnostics);
    require(read.has_value() != diagnostics.has_errors());
    if (read) {
        require(read->vertical.size() >= 2 && !read->horizontal.empty());
        require(read->candela.size() == read->vertical.size() * read->horizontal.size());
        require(read->vertical.front() == 0.0 && read->vertical.back() <= 180.0 && read->horizontal.front() == 0.0);
        require(read->horizontal.size() == 1 || read->horizontal.back() == 360.0);
        for (std::size_t i = 1; i < read->vertical.size(); ++i) {
            require(read->vertical[i] > read->vertical[i - 1]);
        }
        for (std::size_t i = 1; i < read->horizontal.size(); ++i) {
            require(read->horizontal[i] > read->horizontal[i - 1]);
        }
        for (const double candela : read->candela) {
            require(std::isfinite(candela) && candela >= 0.0);
        }
    }
    return 0;
}
