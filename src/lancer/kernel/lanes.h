// The C++ side of the dialect: Float, Int, Mask and Vec3 for one ray, for one ray in double, and for as many rays as a SIMD register holds.
// Included by language.h only.
#ifndef LANCER_KERNEL_LANES_H
#define LANCER_KERNEL_LANES_H

#include <cmath>

#if defined(LANCER_ISA)
#include <xsimd/xsimd.hpp>
#endif

namespace lancer::LANCER_KERNEL {

#if !defined(LANCER_ISA) && !defined(LANCER_DOUBLE)
#else
using namespace lancer::kernel;  // the records
#endif

#if defined(LANCER_ISA)

using Isa = xsimd::LANCER_ISA;
using Float = xsimd::batch<float, Isa>;
using Int = xsimd::batch<std::int32_t, Isa>;
using UInt = xsimd::batch<std::uint32_t, Isa>;
using Mask = xsimd::batch_bool<float, Isa>;
constexpr int LANES = static_cast<int>(Float::size);

FN bool some(Mask m) { return xsimd::any(m); }
FN Mask both(Mask a, Mask b) { return a & b; }
FN Mask either(Mask a, Mask b) { return a | b; }
FN Mask without(Mask a, Mask b) { return a & !b; }
FN unsigned mask_bits(Mask m) {
#if defined(__AVX512F__)
    return static_cast<unsigned>(m.data);
#elif defined(__AVX__)
    return static_cast<unsigned>(_mm256_movemask_ps(m));
#else
    return static_cast<unsigned>(_mm_movemask_ps(m));
#endif
}
FN int lanes_in(Mask m) { return __builtin_popcount(mask_bits(m)); }
FN Float as_float(Int a) { return xsimd::bitwise_cast<Float>(a); }
FN Int as_int(Float a) { return xsimd::bitwise_cast<Int>(a); }
FN Float select(Mask m, Float a, Float b) { return xsimd::select(m, a, b); }
FN Int select(Mask m, Int a, Int b) { return as_int(xsimd::select(m, as_float(a), as_float(b))); }
FN UInt select(Mask m, UInt a, UInt b) {
    return xsimd::bitwise_cast<UInt>(xsimd::select(m, xsimd::bitwise_cast<Float>(a), xsimd::bitwise_cast<Float>(b)));
}
FN Int as_signed(UInt x) { return xsimd::bitwise_cast<Int>(x); }
FN UInt as_unsigned(Int x) { return xsimd::bitwise_cast<UInt>(x); }
FN Mask to_mask(xsimd::batch_bool<std::int32_t, Isa> m) {
    Mask result;
    static_assert(sizeof(result) == sizeof(m), "both are one register of the same width");
    std::memcpy(&result, &m, sizeof(result));
    return result;
}
FN Mask is_equal(Int a, Int b) { return to_mask(a == b); }
FN Mask is_above(Int a, Int b) { return to_mask(a > b); }
FN Float sqrt(Float a) { return xsimd::sqrt(a); }
FN Float abs(Float a) { return xsimd::abs(a); }
FN Float min(Float a, Float b) { return xsimd::min(a, b); }
FN Float max(Float a, Float b) { return xsimd::max(a, b); }
FN Float floor(Float a) { return xsimd::floor(a); }
FN Int float_bits(Float x) { return as_int(x); }
FN Float bits_float(Int x) { return as_float(x); }
FN Float to_float(Int x) { return xsimd::to_float(x); }
FN Int round_to_int(Float x) { return xsimd::nearbyint_as_int(x); }
FN Int to_int(Float x) { return xsimd::to_int(x); }  // towards zero

// The largest value of all lanes.
FN float highest(Float x) {
#if defined(__AVX512F__)
    return _mm512_reduce_max_ps(x);
#else
#if defined(__AVX__)
    const __m128 four = _mm_max_ps(_mm256_castps256_ps128(x), _mm256_extractf128_ps(x, 1));
#else
    const __m128 four = x;
#endif
    const __m128 two = _mm_max_ps(four, _mm_movehl_ps(four, four));
    return _mm_cvtss_f32(_mm_max_ss(two, _mm_shuffle_ps(two, two, 1)));
#endif
}

// One lane's value, and the value of the first lane that is on.
FN float lane_of(Float x, int lane) {
    float values[LANES];
    x.store_unaligned(values);
    return values[lane];
}
FN int lane_of(Int x, int lane) {
    std::int32_t values[LANES];
    x.store_unaligned(values);
    return values[lane];
}
FN int first_of(Int x, Mask m) { return lane_of(x, __builtin_ctz(mask_bits(m))); }
FN bool lane_is_on(Mask m, int lane) { return ((mask_bits(m) >> lane) & 1u) != 0; }
FN void set_lane(Float& x, int lane, float v) {
    float values[LANES];
    x.store_unaligned(values);
    values[lane] = v;
    x = Float::load_unaligned(values);
}
FN void set_lane(Int& x, int lane, int v) {
    std::int32_t values[LANES];
    x.store_unaligned(values);
    values[lane] = v;
    x = Int::load_unaligned(values);
}

#else

#if defined(LANCER_DOUBLE)
using Float = double;
#else
using Float = float;
#endif
using Int = int;
using UInt = std::uint32_t;
using Mask = bool;
constexpr int LANES = 1;

FN bool some(Mask m) { return m; }
FN Mask both(Mask a, Mask b) { return a && b; }
FN Mask either(Mask a, Mask b) { return a || b; }
FN Mask without(Mask a, Mask b) { return a && !b; }
FN int lanes_in(Mask m) { return m ? 1 : 0; }
FN Float select(Mask m, Float a, Float b) { return m ? a : b; }
FN Int select(Mask m, Int a, Int b) { return m ? a : b; }
FN UInt select(Mask m, UInt a, UInt b) { return m ? a : b; }
FN Int as_signed(UInt x) { return static_cast<Int>(x); }
FN UInt as_unsigned(Int x) { return static_cast<UInt>(x); }
FN Mask is_equal(Int a, Int b) { return a == b; }
FN Mask is_above(Int a, Int b) { return a > b; }
FN Float sqrt(Float a) { return std::sqrt(a); }
FN Float abs(Float a) { return std::fabs(a); }
FN Float min(Float a, Float b) { return a < b ? a : b; }  // as the SIMD instruction: b where one is not a number
FN Float max(Float a, Float b) { return a > b ? a : b; }
FN Float floor(Float a) { return std::floor(a); }
FN Int float_bits(Float x) {
    const float value = static_cast<float>(x);
    Int bits;
    std::memcpy(&bits, &value, sizeof(bits));
    return bits;
}
FN Float bits_float(Int x) {
    float value;
    std::memcpy(&value, &x, sizeof(value));
    return static_cast<Float>(value);
}
FN Float to_float(Int x) { return static_cast<Float>(x); }
FN Int round_to_int(Float x) { return static_cast<Int>(std::nearbyint(x)); }
FN Int to_int(Float x) { return static_cast<Int>(x); }
FN Int first_of(Int x, Mask) { return x; }
FN bool lane_is_on(Mask m, int) { return m; }
FN float lane_of(Float x, int) { return static_cast<float>(x); }
FN int lane_of(Int x, int) { return x; }
FN void set_lane(Float& x, int, float v) { x = static_cast<Float>(v); }
FN void set_lane(Int& x, int, int v) { x = v; }

#endif

struct Vec2 {
    Float x, y;
};

struct Vec3 {
    Float x, y, z;
};

struct Vec4 {
    Float x, y, z, w;
};

FN Vec2 vec2_of(Float x, Float y) { return Vec2{x, y}; }
FN Vec3 vec3_of(Float x, Float y, Float z) { return Vec3{x, y, z}; }
FN Vec3 vec3_all(Float x) { return Vec3{x, x, x}; }
FN Vec3 broadcast(const glm::vec3& v) { return Vec3{Float(v.x), Float(v.y), Float(v.z)}; }

FN Vec3 operator+(const Vec3& a, const Vec3& b) { return Vec3{a.x + b.x, a.y + b.y, a.z + b.z}; }
FN Vec3 operator-(const Vec3& a, const Vec3& b) { return Vec3{a.x - b.x, a.y - b.y, a.z - b.z}; }
FN Vec3 operator*(const Vec3& a, const Vec3& b) { return Vec3{a.x * b.x, a.y * b.y, a.z * b.z}; }
FN Vec3 operator/(const Vec3& a, const Vec3& b) { return Vec3{a.x / b.x, a.y / b.y, a.z / b.z}; }
FN Vec3 operator*(const Vec3& a, Float b) { return Vec3{a.x * b, a.y * b, a.z * b}; }
FN Vec3 operator*(Float a, const Vec3& b) { return b * a; }
FN Vec3 operator/(const Vec3& a, Float b) { return Vec3{a.x / b, a.y / b, a.z / b}; }
FN Vec3 operator-(const Vec3& a) { return Vec3{-a.x, -a.y, -a.z}; }

FN Float dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
FN Vec3 cross(const Vec3& a, const Vec3& b) { return Vec3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
FN Float length(const Vec3& a) { return sqrt(dot(a, a)); }
FN Vec3 normalize(const Vec3& a) { return a * (Float(1.0f) / length(a)); }
FN Vec3 abs(const Vec3& a) { return Vec3{abs(a.x), abs(a.y), abs(a.z)}; }
FN Vec3 min(const Vec3& a, const Vec3& b) { return Vec3{min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)}; }
FN Vec3 max(const Vec3& a, const Vec3& b) { return Vec3{max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)}; }
FN Vec3 reciprocal(const Vec3& a) { return Vec3{Float(1.0f) / a.x, Float(1.0f) / a.y, Float(1.0f) / a.z}; }
FN Vec3 select(Mask m, const Vec3& a, const Vec3& b) { return Vec3{select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)}; }

FN Vec4 vec4_of(Float x, Float y, Float z, Float w) { return Vec4{x, y, z, w}; }
FN Vec4 vec4_all(Float x) { return Vec4{x, x, x, x}; }
FN Vec4 broadcast(const glm::vec4& v) { return Vec4{Float(v.x), Float(v.y), Float(v.z), Float(v.w)}; }
FN Vec4 operator+(const Vec4& a, const Vec4& b) { return Vec4{a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }
FN Vec4 operator-(const Vec4& a, const Vec4& b) { return Vec4{a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w}; }
FN Vec4 operator*(const Vec4& a, const Vec4& b) { return Vec4{a.x * b.x, a.y * b.y, a.z * b.z, a.w * b.w}; }
FN Vec4 operator/(const Vec4& a, const Vec4& b) { return Vec4{a.x / b.x, a.y / b.y, a.z / b.z, a.w / b.w}; }
FN Vec4 operator*(const Vec4& a, Float b) { return Vec4{a.x * b, a.y * b, a.z * b, a.w * b}; }
FN Vec4 operator*(Float a, const Vec4& b) { return b * a; }
FN Vec4 operator/(const Vec4& a, Float b) { return a * (Float(1.0f) / b); }
FN Vec4 sqrt(const Vec4& a) { return Vec4{sqrt(a.x), sqrt(a.y), sqrt(a.z), sqrt(a.w)}; }
FN Vec4 max(const Vec4& a, const Vec4& b) { return Vec4{max(a.x, b.x), max(a.y, b.y), max(a.z, b.z), max(a.w, b.w)}; }
FN Vec4 min(const Vec4& a, const Vec4& b) { return Vec4{min(a.x, b.x), min(a.y, b.y), min(a.z, b.z), min(a.w, b.w)}; }
FN Vec4 select(Mask m, const Vec4& a, const Vec4& b) {
    return Vec4{select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z), select(m, a.w, b.w)};
}

}  // namespace lancer::LANCER_KERNEL

#endif
