// Compiled once for each instruction set: the Whitted integrator on as many rays as a register holds.
#include "lancer/device/cpu/follow.h"
#include "lancer/device/cpu/lane_hits.h"
#include "lancer/kernel/whitted.h"

namespace lancer::LANCER_KERNEL {

#define LANCER_FOLLOW LANCER_JOIN(follow_whitted_, LANCER_ISA)

void LANCER_FOLLOW(const kernel::WorldRecord& world, const glm::vec2* points, glm::vec3* radiance, std::size_t count, RayCounts& counts) {
    RayTally tally{0, 0, 0};
    alignas(64) float x[LANES];
    alignas(64) float y[LANES];
    alignas(64) float z[LANES];
    alignas(64) float number[LANES];
    for (int lane = 0; lane < LANES; ++lane) {
        number[lane] = static_cast<float>(lane);
    }
    const Float lane_numbers = Float::load_aligned(number);
    for (std::size_t first = 0; first < count; first += LANES) {
        const std::size_t here = count - first < LANES ? count - first : LANES;
        for (std::size_t lane = 0; lane < LANES; ++lane) {
            const glm::vec2& point = points[first + (lane < here ? lane : 0)];
            x[lane] = point.x;
            y[lane] = point.y;
        }
        const Mask alive = lane_numbers < Float(static_cast<float>(here));
        const Vec3 light = whitted_radiance(world, camera_ray(world.camera, Float::load_aligned(x), Float::load_aligned(y)), alive, tally);
        light.x.store_aligned(x);
        light.y.store_aligned(y);
        light.z.store_aligned(z);
        for (std::size_t lane = 0; lane < here; ++lane) {
            radiance[first + lane].x = x[lane];
            radiance[first + lane].y = y[lane];
            radiance[first + lane].z = z[lane];
        }
    }
    counts.camera += static_cast<std::uint64_t>(tally.camera);
    counts.secondary += static_cast<std::uint64_t>(tally.secondary);
    counts.shadow += static_cast<std::uint64_t>(tally.shadow);
}

}  // namespace lancer::LANCER_KERNEL
