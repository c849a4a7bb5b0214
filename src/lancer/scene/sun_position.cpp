#include "lancer/scene/sun_position.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lancer::scene {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

double turned(double degrees) { return degrees - 360.0 * std::floor(degrees / 360.0); }

// So many digits at the start; moves behind them. -1: none.
int take_digits(std::string_view& text, std::size_t count) {
    int value = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (i >= text.size() || text[i] < '0' || text[i] > '9') {
            return -1;
        }
        value = 10 * value + (text[i] - '0');
    }
    text.remove_prefix(count);
    return value;
}

bool take(std::string_view& text, char c) {
    const bool here = !text.empty() && text.front() == c;
    text.remove_prefix(here ? 1 : 0);
    return here;
}

bool is_leap(int year) { return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0); }

}  // namespace

std::optional<double> days_since_2000(std::string_view time) {
    const int year = take_digits(time, 4);
    const bool dash = take(time, '-');
    const int month = take_digits(time, 2);
    const bool second_dash = take(time, '-');
    const int day = take_digits(time, 2);
    const bool separated = take(time, 'T') || take(time, ' ');
    const int hour = take_digits(time, 2);
    const bool colon = take(time, ':');
    const int minute = take_digits(time, 2);
    int second = 0;
    if (take(time, ':')) {
        second = take_digits(time, 2);
    }
    double ahead = 0.0;  // of Universal Time, hours
    if (!take(time, 'Z') && !time.empty()) {
        const double sign = time.front() == '-' ? -1.0 : 1.0;
        const bool is_signed = take(time, '+') || take(time, '-');
        const int hours = take_digits(time, 2);
        const bool zone_colon = take(time, ':');
        const int minutes = take_digits(time, 2);
        if (!is_signed || !zone_colon || hours < 0 || hours > 14 || minutes < 0 || minutes > 59) {
            return std::nullopt;
        }
        ahead = sign * (hours + minutes / 60.0);
    }
    static constexpr std::array<int, 12> lengths = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    if (!dash || !second_dash || !separated || !colon || !time.empty() || year < 1950 || year > 2050 || month < 1 || month > 12) {
        return std::nullopt;
    }
    const int length = lengths[static_cast<std::size_t>(month - 1)] + (month == 2 && is_leap(year) ? 1 : 0);
    if (day < 1 || day > length || hour < 0 || hour > 23 || minute < 0 || minute > 59 || second < 0 || second > 60) {
        return std::nullopt;
    }
    int days = day - 1;
    for (int m = 1; m < month; ++m) {
        days += lengths[static_cast<std::size_t>(m - 1)] + (m == 2 && is_leap(year) ? 1 : 0);
    }
    for (int y = 2000; y < year; ++y) {
        days += is_leap(y) ? 366 : 365;
    }
    for (int y = year; y < 2000; ++y) {
        days -= is_leap(y) ? 366 : 365;
    }
    return days - 0.5 + (hour - ahead + minute / 60.0 + second / 3600.0) / 24.0;
}

SunPosition sun_position(double days, double latitude, double longitude) {
    const double anomaly = turned(357.528 + 0.9856003 * days) * degree;
    const double mean_longitude = turned(280.460 + 0.9856474 * days);
    const double ecliptic = (mean_longitude + 1.915 * std::sin(anomaly) + 0.020 * std::sin(2.0 * anomaly)) * degree;
    const double tilt = (23.439 - 4e-7 * days) * degree;
    const double ascension = std::atan2(std::cos(tilt) * std::sin(ecliptic), std::cos(ecliptic));
    const double declination = std::asin(std::clamp(std::sin(tilt) * std::sin(ecliptic), -1.0, 1.0));
    // Sidereal time at Greenwich: 6.697375 + 0.0657098242 days + the hour of the day, in hours.
    const double of_day = days + 0.5 - std::floor(days + 0.5);
    const double sidereal = turned(15.0 * (6.697375 + 0.0657098242 * days + 24.0 * of_day));
    const double hour = (sidereal + longitude) * degree - ascension;
    const double phi = latitude * degree;
    SunPosition sun;
    const double rise = std::sin(declination) * std::sin(phi) + std::cos(declination) * std::cos(phi) * std::cos(hour);
    sun.elevation = std::asin(std::clamp(rise, -1.0, 1.0)) / degree;
    const double north = std::sin(declination) * std::cos(phi) - std::cos(declination) * std::sin(phi) * std::cos(hour);
    const double east = -std::cos(declination) * std::sin(hour);
    sun.azimuth = turned(std::atan2(east, north) / degree);
    sun.distance = 1.00014 - 0.01671 * std::cos(anomaly) - 0.00014 * std::cos(2.0 * anomaly);
    return sun;
}

glm::dvec3 sun_direction(double elevation, double azimuth, double heading) {
    const double up = elevation * degree, around = (azimuth - heading) * degree;
    return {std::sin(around) * std::cos(up), std::sin(up), -std::cos(around) * std::cos(up)};
}

glm::dmat3 upright(const glm::dvec3& up) {
    if (up == glm::dvec3(0.0, 1.0, 0.0)) {
        return glm::dmat3(1.0);
    }
    if (up.y < -1.0 + 1e-12) {
        return {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, -1.0, 0.0), glm::dvec3(0.0, 0.0, -1.0)};
    }
    // Turned about the cross product of the two [Rodrigues].
    const double share = 1.0 / (1.0 + up.y);
    return {glm::dvec3(1.0 - up.x * up.x * share, -up.x, -up.x * up.z * share), up,
            glm::dvec3(-up.x * up.z * share, -up.z, 1.0 - up.z * up.z * share)};
}

}  // namespace lancer::scene
