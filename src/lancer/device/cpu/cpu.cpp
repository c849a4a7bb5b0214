#include "lancer/device/cpu/cpu.h"

#include <xmmintrin.h>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lancer/base/failure.h"
#include "lancer/device/cpu/follow.h"
#include "lancer/device/cpu/photon_map.h"
#include "lancer/trace/tree.h"

namespace lancer {

namespace {

// Numbers too small for a normal float become zero while this lives: what Embree asks for, and always, so that every tracer rounds alike.
class FlushDenormals {
public:
    FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040u); }
    ~FlushDenormals() { _mm_setcsr(before_); }
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
    unsigned before_;
};

class CpuDevice : public Device {
public:
    CpuDevice(std::shared_ptr<const World> world, const CpuVariant& variant, const CpuOptions& options)
        : world_(std::move(world)), variant_(variant), record_(world_->record()) {
        if (options.tracer == Tracer::tree || !world_->is_small()) {
            tree_.emplace(*world_, options.threads);
            record_.tree = tree_->address();
        }
        if (record_.halves == kernel::HALVES_MERGED) {
            photons_.emplace(
                kernel::PHOTON_PATHS, [this](int sample) { return variant_.photon_radius(record_, sample); },
                [this](int sample, int first, int count) { return variant_.photons(record_, sample, first, count); });
        }
    }

    int lanes() const override { return variant_.lanes; }

    std::string description() const override {
        return fmt::format("CPU, {}, {}", variant_.name, tree_ ? "Embree" : "all objects in lanes");
    }

    void follow(std::span<const glm::vec2> points, std::span<glm::vec3> radiance, RayCounts& counts) const override {
        const FlushDenormals flush;
        variant_.whitted(record_, points.data(), radiance.data(), points.size(), counts);
    }

    void trace_paths(const PathRange& range, const PathSamples& samples, RayCounts& counts) const override {
        const FlushDenormals flush;
        if (makes_splats() && samples.splats != nullptr) {
            variant_.both_ends(record_, range, photons_ ? &*photons_ : nullptr, samples, counts);
            if (!samples.first_hits.empty()) {
                // The camera's halves begin as paths do: these are followed to what they meet first.
                kernel::WorldRecord shortest = record_;
                shortest.max_depth = 0;
                std::vector<glm::vec3> unused(range.paths());
                variant_.paths(shortest, range, {unused, {}, samples.first_hits, {}, nullptr}, counts);
            }
        } else {
            variant_.paths(record_, range, samples, counts);
        }
    }

    bool makes_splats() const override { return record_.halves != kernel::HALF_OF_CAMERA; }

    PathFault find_fault(int x, int y, int sample) const override {
        const FlushDenormals flush;
        return variant_.fault(record_, x, y, sample);
    }

private:
    std::shared_ptr<const World> world_;
    const CpuVariant& variant_;
    kernel::WorldRecord record_;
    std::optional<Tree> tree_;
    mutable std::optional<PhotonMaps> photons_;  // a cache: what it holds is a function of the world
};

}  // namespace

std::unique_ptr<Device> make_cpu_device(std::shared_ptr<const World> world, const CpuOptions& options) {
    const CpuVariant* variant = find_cpu_variant(options.lanes);
    if (variant == nullptr) {
        throw MachineFailure(fmt::format("this processor can't follow {} rays in one register", options.lanes));
    }
    return std::make_unique<CpuDevice>(std::move(world), *variant, options);
}

}  // namespace lancer
