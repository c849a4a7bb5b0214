// Runs when lancer is built: makes the table of smooth spectra (see upsample.h) and writes it to the file that its only argument names.
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <vector>

#include "lancer/spectrum/upsample.h"
#include "lancer/spectrum/upsample_fit.h"
#include "lancer/spectrum/upsample_grid.h"

namespace {

using namespace lancer;

constexpr int hues = upsampling_hues, saturations = upsampling_saturations, lightnesses = upsampling_lightnesses;

glm::dvec3 color_of(double hue, double saturation, double lightness) {
    const double chroma = 2.0 * lightness * saturation, low = lightness - 0.5 * chroma, high = low + chroma;
    const int sixth = static_cast<int>(hue);
    const double rising = low + chroma * (hue - sixth), falling = low + chroma * (1.0 - (hue - sixth));
    switch (sixth) {
        case 0:
            return {high, rising, low};
        case 1:
            return {falling, high, low};
        case 2:
            return {low, high, rising};
        case 3:
            return {low, falling, high};
        case 4:
            return {rising, low, high};
        default:
            return {high, low, falling};
    }
}

class Table {
public:
    // Each hue and lightness from grey outwards, so that two neighbours tell nearly where the next one lies.
    void make() {
        for (int l = 0; l < lightnesses; ++l) {
            // At lightness 0 stands the limit, near enough.
            const double lightness = l == 0 ? 1e-6 : 0.5 * from_even_ends(static_cast<double>(l) / (lightnesses - 1));
            for (int h = 0; h < hues; ++h) {
                const int sixth = h / (hues / 6);
                const double hue = sixth + from_even_ends(static_cast<double>(h % (hues / 6)) / (hues / 6));
                make_ray(l, h, hue, lightness);
            }
        }
        // Halfway between black and white, a colour and its complement share a lightness: opposites to the last bit.
        for (int s = 0; s < saturations; ++s) {
            for (int h = 0; h < hues / 2; ++h) {
                value(lightnesses - 1, s, h + hues / 2) = -value(lightnesses - 1, s, h);
            }
        }
    }

    bool write(const char* path) const {
        std::vector<float> floats;
        for (const glm::dvec3& v : values_) {
            for (int c = 0; c < 3; ++c) {
                floats.push_back(static_cast<float>(v[c]));
            }
        }
        std::FILE* const file = std::fopen(path, "wb");
        const bool written = file && std::fwrite(floats.data(), sizeof(float), floats.size(), file) == floats.size();
        return (file && std::fclose(file) == 0) && written;
    }

    double worst() const { return worst_; }  // difference left in rgb, as a part of the colour's lightness

private:
    void make_ray(int l, int h, double hue, double lightness) {
        const double divisor = upsampling_divisor(lightness);
        const glm::dvec3 grey(0.0, 0.0, lightness - 0.5);
        for (int s = 1; s < saturations; ++s) {
            const glm::dvec3 rgb = color_of(hue, from_even_end(static_cast<double>(s) / (saturations - 1)), lightness);
            const glm::dvec3 last = value(l, s - 1, h);
            const glm::dvec3 before = s > 1 ? value(l, s - 2, h) : last;
            glm::dvec3 coefficients = (2.0 * last - before + grey) / divisor;
            double left = fit_.fit(rgb, coefficients);
            if (left > 1e-6 * lightness) {
                glm::dvec3 again = (last + grey) / divisor;
                if (const double left_again = fit_.fit(rgb, again); left_again < left) {
                    coefficients = again;
                    left = left_again;
                }
            }
            if (l > 0) {
                worst_ = std::fmax(worst_, left / lightness);
            }
            value(l, s, h) = coefficients * divisor - grey;
        }
    }

    glm::dvec3& value(int l, int s, int h) { return values_[static_cast<std::size_t>((l * saturations + s) * hues + h)]; }

    SmoothSpectrumFit fit_;
    std::vector<glm::dvec3> values_ = std::vector<glm::dvec3>(static_cast<std::size_t>(upsampling_values / 3), glm::dvec3(0.0));
    double worst_ = 0.0;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s FILE\n", argv[0]);
        return 2;
    }
    Table table;
    table.make();
    if (!(table.worst() < 1e-6)) {
        std::fprintf(stderr, "a colour has no smooth spectrum: %g of its lightness is left\n", table.worst());
        return 1;
    }
    if (!table.write(argv[1])) {
        std::fprintf(stderr, "cannot write %s\n", argv[1]);
        return 3;
    }
    return 0;
}
