#include "lancer/device/cpu/photon_map.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace lancer {

PhotonMap::PhotonMap(std::vector<PhotonRecord> photons, float radius) : radius_(radius) {
    const std::uint32_t buckets = std::bit_ceil(std::max<std::uint32_t>(static_cast<std::uint32_t>(photons.size()), 16u));
    mask_ = buckets - 1;
    std::vector<std::uint32_t> own(photons.size());
    first_.assign(buckets + 1u, 0u);
    for (std::size_t i = 0; i < photons.size(); ++i) {
        const glm::vec3 p = photons[i].position;
        own[i] = kernel::photon_bucket(kernel::photon_cell(p.x, radius_), kernel::photon_cell(p.y, radius_),
                                       kernel::photon_cell(p.z, radius_), mask_);
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

void PhotonMap::gather(const glm::vec3 position, std::vector<const PhotonRecord*>& found) const {
    const std::int32_t x = kernel::photon_cell(position.x - radius_, radius_);
    const std::int32_t y = kernel::photon_cell(position.y - radius_, radius_);
    const std::int32_t z = kernel::photon_cell(position.z - radius_, radius_);
    // Different cells may share a bucket, which is to be looked through once.
    std::array<std::uint32_t, 8> seen{};
    std::size_t count = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const std::uint32_t b = kernel::photon_bucket(x + (corner & 1), y + ((corner >> 1) & 1), z + (corner >> 2), mask_);
        const auto end = seen.begin() + static_cast<std::ptrdiff_t>(count);
        if (std::find(seen.begin(), end, b) == end) {
            seen[count++] = b;
        }
    }
    const float radius_2 = radius_ * radius_;
    for (std::size_t s = 0; s < count; ++s) {
        for (std::uint32_t i = first_[seen[s]]; i < first_[seen[s] + 1u]; ++i) {
            const glm::vec3 way = photons_[i].position - position;
            if (way.x * way.x + way.y * way.y + way.z * way.z < radius_2) {
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
