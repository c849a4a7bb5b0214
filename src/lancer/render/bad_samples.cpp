#include "lancer/render/bad_samples.h"

#include <algorithm>
#include <tuple>

namespace lancer {

void BadSamples::add(const BadSample& sample) {
    ++count_;
    keep(sample);
}

void BadSamples::add(const BadSamples& others) {
    count_ += others.count_;
    for (const BadSample& sample : others.first_) {
        keep(sample);
    }
}

void BadSamples::keep(const BadSample& sample) {
    const auto before = [](const BadSample& a, const BadSample& b) { return std::tie(a.y, a.x, a.sample) < std::tie(b.y, b.x, b.sample); };
    first_.insert(std::upper_bound(first_.begin(), first_.end(), sample, before), sample);
    if (first_.size() > kept) {
        first_.pop_back();
    }
}

void BadSamples::find_faults(const Device& device) {
    for (BadSample& sample : first_) {
        sample.fault = device.find_fault(sample.x, sample.y, sample.sample);
    }
}

}  // namespace lancer
