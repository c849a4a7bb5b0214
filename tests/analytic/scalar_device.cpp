#include "analytic/scalar_device.h"

#include <xmmintrin.h>

#include "lancer/kernel/all_objects.h"
#include "lancer/kernel/whitted.h"

namespace lancer::kernel {

Hit closest_hit(IN(WorldRecord) world, IN(Ray) ray, Mask alive) { return closest_of_all(world, ray, alive); }
Mask occluded(IN(WorldRecord) world, IN(Ray) ray, Mask alive) { return occluded_by_any(world, ray, alive); }

}  // namespace lancer::kernel

namespace lancer::tests {

std::vector<glm::vec3> follow_one_by_one(const World& world, const std::vector<glm::vec2>& points) {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | 0x8040u);  // the device computes without denormal numbers
    const kernel::WorldRecord record = world.record();
    std::vector<glm::vec3> radiance;
    kernel::RayTally tally{0, 0, 0};
    for (const glm::vec2& point : points) {
        const kernel::Vec3 light = kernel::whitted_radiance(record, kernel::camera_ray(record.camera, point.x, point.y), true, tally);
        radiance.emplace_back(light.x, light.y, light.z);
    }
    _mm_setcsr(before);
    return radiance;
}

}  // namespace lancer::tests
