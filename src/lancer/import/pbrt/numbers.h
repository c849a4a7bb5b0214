// Numbers between blanks, many of them and fast.
#pragma once

#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "lancer/import/pbrt/words.h"

namespace lancer::pbrt {

// A word as a number: finite, what is too small is 0. Whole numbers may be written as "3.0". Null when it is none, else the end of the number.
template <class T>
const char* read_number(const char* begin, const char* end, T& number) {
    begin += begin != end && *begin == '+' ? 1 : 0;
    const auto exact = std::from_chars(begin, end, number);
    const char* stop = exact.ptr;
    const auto ends_here = [&] { return stop == end || is_blank(*stop) || *stop == '#'; };
    if (exact.ec == std::errc{} && ends_here()) {
        if constexpr (std::is_floating_point_v<T>) {
            return std::isfinite(number) ? stop : nullptr;
        }
        return stop;
    }
    double value = 0.0;
    const auto wide = std::from_chars(begin, end, value);
    stop = wide.ptr;
    if (wide.ec == std::errc::invalid_argument || !ends_here()) {
        return nullptr;
    }
    if (wide.ec == std::errc::result_out_of_range) {
        const std::string_view text(begin, static_cast<std::size_t>(stop - begin));
        const std::size_t exponent = text.find_first_of("eE");
        if (exponent != std::string_view::npos && text[exponent + 1] != '-') {
            return nullptr;
        }
        value = 0.0;
    }
    number = static_cast<T>(value);
    if constexpr (std::is_floating_point_v<T>) {
        return std::isfinite(number) ? stop : nullptr;
    }
    return std::abs(value) < 2147483648.0 && static_cast<double>(number) == value ? stop : nullptr;
}

// Gives each number of a text to `take`. Returns the word that is no number, or an empty one.
template <class T, class Take>
std::string_view for_each_number(std::string_view text, const Take& take) {
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        while (at != end && is_blank(*at)) {
            ++at;
        }
        if (at == end) {
            return {};
        }
        if (*at == '#') {
            while (at != end && *at != '\n') {
                ++at;
            }
            continue;
        }
        T number{};
        const char* const stop = read_number(at, end, number);
        if (stop == nullptr) {
            return Words({at, static_cast<std::size_t>(end - at)}).next();
        }
        take(number);
        at = stop;
    }
}

}  // namespace lancer::pbrt
