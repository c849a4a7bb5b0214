// Light that is scattered more than once in flat layers of air, see atmosphere.h.
#pragma once

#include <vector>

namespace lancer {

// The layers between levels, from the ground up, at one wavelength.
struct AirLayers {
    std::vector<double> depth;      // optical depth of each layer, straight up
    std::vector<double> scattered;  // of what a layer takes, the share that it scatters,
    std::vector<double> molecular;  // and of that the share that molecules scatter
    std::vector<double> sunlight;   // share of the sun's light that is left at each level: one more than layers
    double sun_cosine = 1.0;        // of its angle from the zenith; below 0 it shines from below the horizon
    double ground = 0.0;
};

// Directions in which the result is given: cosines of the angle from the zenith, above 0, towards which one looks.
// Per unit of the sun's irradiance outside the air.
struct ManyTimesScattered {
    // What each level sends down per unit of optical depth, of light that comes from there along a line seen under that cosine: modes of the azimuth
    // from the sun, of each all levels, of each all cosines. Without light that was scattered once.
    std::vector<double> source;
    double down = 0.0;         // irradiance of level ground, without the sun itself
    double up = 0.0;           // what leaves the air at its top
    double direct_down = 0.0;  // irradiance of the ground by the sun itself
};

// The scattering functions' modes for one position of the sun and one set of cosines; the same at all wavelengths.
class ScatteringModes {
public:
    static constexpr int count = 16;    // of the Fourier series
    static constexpr int streams = 16;  // cosines, upwards and as many downwards

    ScatteringModes(double sun_cosine, double asymmetry, const std::vector<double>& looks);

    ManyTimesScattered scatter(const AirLayers& layers) const;

    std::size_t looks() const { return looks_; }

private:
    // Of one kind of particle: into each direction (streams up, streams down, looks) from each stream (up, down) and from the sun.
    struct Matrix {
        std::vector<double> from_streams;
        std::vector<double> from_sun;
    };

    std::vector<double> cosines_;  // of the streams, above 0
    std::vector<double> weights_;
    std::size_t looks_;
    std::vector<Matrix> molecules_;  // by mode
    std::vector<Matrix> haze_;
};

// How likely light is to turn by an angle of that cosine, per solid angle: its integral over all directions is 1.
double molecular_phase(double cosine);               // [Rayleigh 1871]
double haze_phase(double cosine, double asymmetry);  // [Henyey and Greenstein 1941]

}  // namespace lancer
