#include "lancer/device/cpu/follow.h"
#include "lancer/device/cpu/photon_map.h"

namespace lancer {

#define LANCER_DECLARE(isa)                                                                                                        \
    namespace kernel_##isa {                                                                                                       \
        void follow_whitted_##isa(const kernel::WorldRecord&, const glm::vec2*, glm::vec3*, std::size_t, RayCounts&);              \
        void trace_paths_##isa(const kernel::WorldRecord&, const PathRange&, const PathSamples&, RayCounts&);                      \
        PathFault find_fault_##isa(const kernel::WorldRecord&, int, int, int);                                                     \
        void trace_bidirectional_##isa(const kernel::WorldRecord&, const PathRange&, PhotonMaps*, const PathSamples&, RayCounts&); \
        std::vector<PhotonRecord> trace_photons_##isa(const kernel::WorldRecord&, int, int, int);                                  \
        float photon_radius_##isa(const kernel::WorldRecord&, int);                                                                \
    }
LANCER_DECLARE(sse4_2)
LANCER_DECLARE(avx2)
LANCER_DECLARE(avx512f)
#undef LANCER_DECLARE

const CpuVariant* find_cpu_variant(int lanes) {
#define LANCER_VARIANT(name, lanes, isa)                                                                                  \
    {                                                                                                                     \
        name, lanes, kernel_##isa::follow_whitted_##isa, kernel_##isa::trace_paths_##isa, kernel_##isa::find_fault_##isa, \
            kernel_##isa::trace_bidirectional_##isa, kernel_##isa::trace_photons_##isa, kernel_##isa::photon_radius_##isa \
    }
    static constexpr CpuVariant avx512 = LANCER_VARIANT("AVX-512", 16, avx512f);
    static constexpr CpuVariant avx2 = LANCER_VARIANT("AVX2", 8, avx2);
    static constexpr CpuVariant sse4 = LANCER_VARIANT("SSE4.2", 4, sse4_2);
#undef LANCER_VARIANT
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
