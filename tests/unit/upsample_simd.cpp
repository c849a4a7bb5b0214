#include "upsample_simd.h"

#if defined(__SSE4_2__)
#define LANCER_ISA sse4_2
#include "lancer/kernel/upsample.h"
#include "lancer/spectrum/upsample.h"

namespace lancer {

std::array<float, 4> four_reflectances(const FourColors& colors, const std::array<bool, 4>& on) {
    using namespace kernel_sse4_2;
    const auto load = [](const std::array<float, 4>& values) { return Float::load_unaligned(values.data()); };
    const std::array<float, 4> ones{on[0] ? 1.0f : 0.0f, on[1] ? 1.0f : 0.0f, on[2] ? 1.0f : 0.0f, on[3] ? 1.0f : 0.0f};
    const Mask mask = load(ones) > Float(0.5f);
    const Vec3 c = reflectance_coefficients(upsampling_table().data(), vec3_of(load(colors.r), load(colors.g), load(colors.b)), mask);
    const Float values = select(mask, sigmoid_polynomial(c, load(colors.nanometres)), Float(0.0f));
    std::array<float, 4> result{};
    values.store_unaligned(result.data());
    return result;
}

}  // namespace lancer
#endif
