// Light in clear air: what is left of the sun's, and what comes from the rest of the sky.
//
// Air molecules scatter [Rayleigh 1871], haze scatters forwards and absorbs a little [Ångström 1929; Henyey and Greenstein 1941], ozone absorbs; the
// ground scatters to all sides alike. Light that is scattered once is followed along straight lines through spherical shells. Light that is scattered
// more often is found order by order in flat layers, in which the sun's light has come through round ones [Dahlback and Stamnes 1991], with its
// dependence on the azimuth as a Fourier series [Chandrasekhar 1950]. Polarisation and refraction are left out.
#pragma once

#include <vector>

namespace lancer {

// Shares of the sun's irradiance outside the air.
struct SkyShares {
    // Of radiance, 1/sr: at azimuths from the sun in even steps over 0 to 180 degrees, of each at elevations 90 (i / (count - 1))^2 degrees, of each at
    // the wavelengths.
    std::vector<double> radiance;
    std::vector<double> ground;  // radiance of the ground, at the wavelengths
    std::vector<double> sky;     // irradiance of level ground by the sky without the sun, by flat layers
};

class Atmosphere {
public:
    // `turbidity`: all that dims the sun over what molecules dim, 1 to 10 [Preetham et al. 1999]. `ozone`: the column, atm-cm. `ground`: the share of light that
    // is scattered back.
    Atmosphere(double turbidity, double ozone, double ground, std::vector<double> nanometres);

    // Of the sun's irradiance at right angles, seen from the ground at `elevation` above the horizon, in radians, 0 at least; at the wavelengths.
    std::vector<double> sun_transmittance(double elevation) const;

    // The sun at `sun_elevation`, radians; it may be below the horizon.
    SkyShares sky(double sun_elevation, int azimuths, int elevations) const;

    // Vertical optical depths from the ground up, at the wavelengths.
    std::vector<double> molecules() const { return molecules_; }
    std::vector<double> haze() const { return haze_; }
    std::vector<double> absorption() const { return ozone_; }

private:
    std::vector<double> nanometres_;
    std::vector<double> molecules_;
    std::vector<double> haze_;
    std::vector<double> haze_albedo_;  // what haze scatters of what it takes
    std::vector<double> ozone_;
    double ground_;
};

// Vertical optical depth of air molecules at sea level [Bird and Riordan 1984, eq. 2-4].
double molecular_depth(double nanometres);

// Of haze [Preetham et al. 1999, appendix A.1: beta of Ångström's formula, with the exponent 1.3].
double haze_depth(double turbidity, double nanometres);

}  // namespace lancer
