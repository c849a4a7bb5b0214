#include "lancer/device/cpu/photon_map.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace lancer {

namespace {

// Cells are two radii wide, so that what lies within one radius is in eight cells at most.
std::int32_t cell_of(float place, float radius) {
    return static_cast<std::int32_t>(std::clamp(std::floor(place / (2.0f * radius)), -1.0e9f, 1.0e9f));
}

}  // namespace

PhotonMap::PhotonMap(std::vector<PhotonRecord> photons, float radius) : radius_(radius) {
    const std::uint32_t buckets = std::bit_ceil(std::max<std::uint32_t>(static_cast<std::uint32_t>(photons.size()), 16u));
    mask_ = buckets - 1;
    std::vector<std::uint32_t> own(photons.size());
    first_.assign(buckets + 1u, 0u);
    for (std::size_t i = 0; i < photons.size(); ++i) {
        const float* const p = photons[i].position;
        own[i] = bucket(cell_of(p[0], radius_), cell_of(p[1], radius_), cell_of(p[2], radius_));
        ++first_[own[i] + 1u];
    }
    for (std::uint32_t b = 0; b < buckets; ++b) {
        first_[b + 1u] += first_[b];
    }
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    photons_.resize(photons.size());
    for (std::size_t i = 0; i < photons.size(); ++i) {
        photons_[next[own[i]]++] = photons[i];
    }
}

// [Teschner et al. 2003]
std::uint32_t PhotonMap::bucket(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return ((static_cast<std::uint32_t>(x) * 73856093u) ^ (static_cast<std::uint32_t>(y) * 19349663u) ^
            (static_cast<std::uint32_t>(z) * 83492791u)) &
           mask_;
}

void PhotonMap::gather(const float position[3], std::vector<const PhotonRecord*>& found) const {
    std::int32_t low[3];
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = cell_of(position[axis] - radius_, radius_);
    }
    // Different cells may share a bucket, which is to be looked through once.
    std::array<std::uint32_t, 8> seen{};
    std::size_t count = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const std::uint32_t b = bucket(low[0] + (corner & 1), low[1] + ((corner >> 1) & 1), low[2] + (corner >> 2));
        const auto end = seen.begin() + static_cast<std::ptrdiff_t>(count);
        if (std::find(seen.begin(), end, b) == end) {
            seen[count++] = b;
        }
    }
    const float radius_2 = radius_ * radius_;
    for (std::size_t s = 0; s < count; ++s) {
        for (std::uint32_t i = first_[seen[s]]; i < first_[seen[s] + 1u]; ++i) {
            const float* const p = photons_[i].position;
            const float x = p[0] - position[0], y = p[1] - position[1], z = p[2] - position[2];
            if (x * x + y * y + z * z < radius_2) {
                found.push_back(&photons_[i]);
            }
        }
    }
}

PhotonMaps::PhotonMaps(int paths, std::function<float(int)> radius, Trace trace)
    : paths_(paths), radius_(std::move(radius)), trace_(std::move(trace)) {}

std::shared_ptr<PhotonMaps::Entry> PhotonMaps::entry(int sample) {
    const std::scoped_lock lock(lock_);
    std::shared_ptr<Entry>& place = entries_[sample];
    if (place) {
        return place;
    }
    place = std::make_shared<Entry>();
    place->parts.resize(static_cast<std::size_t>((paths_ + paths_at_once - 1) / paths_at_once));
    const std::shared_ptr<Entry> made = place;
    order_.push_back(sample);
    if (order_.size() > kept) {
        entries_.erase(order_.front());
        order_.erase(order_.begin());
    }
    return made;
}

std::shared_ptr<const PhotonMap> PhotonMaps::of_sample(int sample) {
    const std::shared_ptr<Entry> own = entry(sample);
    const int parts = static_cast<int>(own->parts.size());
    for (int part = own->next.fetch_add(1); part < parts; part = own->next.fetch_add(1)) {
        const int first = part * paths_at_once;
        own->parts[static_cast<std::size_t>(part)] = trace_(sample, first, std::min(paths_at_once, paths_ - first));
        if (own->done.fetch_add(1) + 1 == parts) {
            // The last one puts them together, in their order.
            std::vector<PhotonRecord> all;
            for (std::vector<PhotonRecord>& some : own->parts) {
                all.insert(all.end(), some.begin(), some.end());
                some = {};
            }
            auto map = std::make_shared<const PhotonMap>(std::move(all), radius_(sample));
            const std::scoped_lock lock(own->lock);
            own->map = std::move(map);
            own->finished.notify_all();
        }
    }
    std::unique_lock lock(own->lock);
    own->finished.wait(lock, [&] { return own->map != nullptr; });
    return own->map;
}

PhotonsInUse::PhotonsInUse(PhotonMaps* maps) : maps_(maps) {}

PhotonsInUse::~PhotonsInUse() = default;

const PhotonMap* PhotonsInUse::of_sample(int sample) {
    if (maps_ != nullptr && sample != sample_) {
        map_ = maps_->of_sample(sample);
        sample_ = sample;
    }
    return map_.get();
}

}  // namespace lancer
