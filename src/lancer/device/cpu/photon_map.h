// The photons of one sample of all pixels, to be found by place; and those of the samples that are being worked on.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "lancer/kernel/bidirectional/photon_record.h"

namespace lancer {

using kernel::PhotonRecord;

class PhotonMap {
public:
    // The order of the photons is kept within a cell.
    PhotonMap(std::vector<PhotonRecord> photons, float radius);

    // Appends those within the radius of a place, in an order that depends on nothing else.
    void gather(glm::vec3 position, std::vector<const PhotonRecord*>& found) const;
    std::size_t size() const { return photons_.size(); }

private:
    float radius_;
    std::uint32_t mask_ = 0;
    std::vector<std::uint32_t> first_;  // of each bucket, and the end of the last
    std::vector<PhotonRecord> photons_;
};

class PhotonMaps;

// The map that one thread works with. All of it is compiled elsewhere: sources that are compiled for several instruction sets must not share
// functions.
class PhotonsInUse {
public:
    explicit PhotonsInUse(PhotonMaps* maps);  // null: there are none
    ~PhotonsInUse();
    PhotonsInUse(const PhotonsInUse&) = delete;
    PhotonsInUse& operator=(const PhotonsInUse&) = delete;

    // Stays until the next one is asked for. Null where there are none.
    const PhotonMap* of_sample(int sample);

private:
    PhotonMaps* maps_;
    int sample_ = -1;
    std::shared_ptr<const PhotonMap> map_;
};

// Keeps the maps of a few samples. Whoever asks for one that is not there helps to make it.
class PhotonMaps {
public:
    // Photons of some paths of a sample: from `first` on, `count` of them, in their order. Pure; called by several threads.
    using Trace = std::function<std::vector<PhotonRecord>(int sample, int first, int count)>;

    PhotonMaps(int paths, std::function<float(int)> radius, Trace trace);

    std::shared_ptr<const PhotonMap> of_sample(int sample);

private:
    static constexpr int paths_at_once = 2048;
    static constexpr std::size_t kept = 40;  // more than the samples that one round takes

    struct Entry {
        std::atomic<int> next{0};
        std::atomic<int> done{0};
        std::vector<std::vector<PhotonRecord>> parts;
        std::mutex lock;
        std::condition_variable finished;
        std::shared_ptr<const PhotonMap> map;
    };

    std::shared_ptr<Entry> entry(int sample);

    int paths_;
    std::function<float(int)> radius_;
    Trace trace_;
    std::mutex lock_;
    std::map<int, std::shared_ptr<Entry>> entries_;
    std::vector<int> order_;  // in which they were asked for first
};

}  // namespace lancer
