#include "lancer/image/metrics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace lancer {

ChannelErrors channel_errors(std::span<const float> picture, std::span<const float> reference) {
    assert(picture.size() == reference.size());
    ChannelErrors errors;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const double a = static_cast<double>(picture[i]), r = static_cast<double>(reference[i]);
        if (!std::isfinite(a) || !std::isfinite(r)) {
            ++errors.skipped;
            continue;
        }
        const double d = a - r;
        errors.mean += a;
        errors.reference_mean += r;
        errors.mse += d * d;
        errors.rel_mse += d * d / (r * r + relative_epsilon);
        errors.mae += std::fabs(d);
        errors.largest = std::max(errors.largest, std::fabs(d));
        ++errors.pixels;
    }
    if (errors.pixels > 0) {
        const double count = static_cast<double>(errors.pixels);
        for (double* sum : {&errors.mean, &errors.reference_mean, &errors.mse, &errors.rel_mse, &errors.mae}) {
            *sum /= count;
        }
        errors.bias = errors.mean - errors.reference_mean;
    }
    return errors;
}

ChannelErrors joined(std::span<const ChannelErrors> channels) {
    ChannelErrors all;
    for (const ChannelErrors& one : channels) {
        const double weight = static_cast<double>(one.pixels);
        all.pixels += one.pixels;
        all.skipped += one.skipped;
        all.mean += weight * one.mean;
        all.reference_mean += weight * one.reference_mean;
        all.bias += weight * one.bias;
        all.mse += weight * one.mse;
        all.rel_mse += weight * one.rel_mse;
        all.mae += weight * one.mae;
        all.largest = std::max(all.largest, one.largest);
    }
    if (all.pixels > 0) {
        const double count = static_cast<double>(all.pixels);
        for (double* sum : {&all.mean, &all.reference_mean, &all.bias, &all.mse, &all.rel_mse, &all.mae}) {
            *sum /= count;
        }
    }
    return all;
}

double peak_signal_to_noise(double mse, double peak) {
    return mse > 0.0 ? 10.0 * std::log10(peak * peak / mse) : std::numeric_limits<double>::infinity();
}

}  // namespace lancer
