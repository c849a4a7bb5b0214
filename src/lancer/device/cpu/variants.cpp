#include "lancer/device/cpu/follow.h"

namespace lancer {

#define LANCER_DECLARE(isa)                                                                                           \
    namespace kernel_##isa {                                                                                          \
        void follow_whitted_##isa(const kernel::WorldRecord&, const glm::vec2*, glm::vec3*, std::size_t, RayCounts&); \
        void follow_paths_##isa(const kernel::WorldRecord&, const PathRange&, glm::vec3*, RayCounts&);                \
    }
LANCER_DECLARE(sse4_2)
LANCER_DECLARE(avx2)
LANCER_DECLARE(avx512f)
#undef LANCER_DECLARE

const CpuVariant* find_cpu_variant(int lanes) {
    static constexpr CpuVariant avx512{"AVX-512", 16, kernel_avx512f::follow_whitted_avx512f, kernel_avx512f::follow_paths_avx512f};
    static constexpr CpuVariant avx2{"AVX2", 8, kernel_avx2::follow_whitted_avx2, kernel_avx2::follow_paths_avx2};
    static constexpr CpuVariant sse4{"SSE4.2", 4, kernel_sse4_2::follow_whitted_sse4_2, kernel_sse4_2::follow_paths_sse4_2};
    const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") &&
                            __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    const bool has_avx2 =
        __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
    if (has_avx512 && (lanes == 0 || lanes == 16)) {
        return &avx512;
    }
    if (has_avx2 && (lanes == 0 || lanes == 8)) {
        return &avx2;
    }
    return lanes == 0 || lanes == 4 ? &sse4 : nullptr;
}

}  // namespace lancer
