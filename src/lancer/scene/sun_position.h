// Where the sun stands.
#pragma once

#include <optional>
#include <string_view>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace lancer::scene {

struct SunPosition {
    double elevation = 0.0;  // degrees above the horizon, without refraction
    double azimuth = 0.0;    // degrees from north over east, 0 to 360
    double distance = 1.0;   // astronomical units
};

// Days since noon of 1 January 2000, Universal Time, of "2026-06-21T14:00:00+02:00": seconds may be left out, and the difference from Universal Time may be
// "Z" or, when it is left out, none. Nothing for any other text or a date that is not in the calendar; years 1950 to 2050.
std::optional<double> days_since_2000(std::string_view time);

// Seen from `latitude` and `longitude`, degrees to the north and to the east; to about 0.01 degrees between 1950 and 2050 [Michalsky 1988].
SunPosition sun_position(double days, double latitude, double longitude);

// Towards the sun, length 1, where +y is up and -z looks `heading` degrees from north over east.
glm::dvec3 sun_direction(double elevation, double azimuth, double heading);

// Where x, y and z come to lie when +y is turned to `up`, of length 1, by the shortest way: with +z up, -z comes to lie along +y.
glm::dmat3 upright(const glm::dvec3& up);

}  // namespace lancer::scene
