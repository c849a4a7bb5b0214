// The dialect: what hides the difference between C++ and GLSL, and between one ray and many.
//
// Kernel code is written for *one ray in each lane*. Capitalised types hold one value a lane; small ones hold one value for all of them:
//
//                            Float, Int, UInt, Mask, Vec3, Vec4        float, int, uint, bool, vec3, vec4
//   GLSL                     float, int, bool, vec3                    the same
//   C++                      float, int, bool, three floats            float, int, bool, glm::vec3
//   C++, LANCER_DOUBLE       double, int, bool, three doubles          (tests: the same formulas in double)
//   C++, LANCER_ISA=avx512f  16 floats, 16 ints, 16 bits, 48 floats    (8 lanes for avx2, 4 for sse4_2)
//
// A lane can't branch alone: `select(mask, a, b)` chooses, `some(mask)` is an ordinary condition for all lanes together. Every operation is
// the same IEEE operation in every lane and every mode, so the number of lanes never shows in a picture.
//
// Each mode has its own namespace LANCER_KERNEL; records (plain scalar structs) are shared. See docs/architecture.md.
#ifndef LANCER_KERNEL_LANGUAGE_H
#define LANCER_KERNEL_LANGUAGE_H

#ifdef __cplusplus

#include <cstdint>
#include <cstring>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#if defined(LANCER_ISA)
#define LANCER_JOIN2(a, b) a##b
#define LANCER_JOIN(a, b) LANCER_JOIN2(a, b)
#define LANCER_KERNEL LANCER_JOIN(kernel_, LANCER_ISA)
#elif defined(LANCER_DOUBLE)
#define LANCER_KERNEL kernel_double
#else
#define LANCER_KERNEL kernel
#endif

namespace lancer::kernel {
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = std::uint32_t;
}  // namespace lancer::kernel

#define NAMESPACE_BEGIN namespace lancer::LANCER_KERNEL {
#define NAMESPACE_END }
#define RECORDS_BEGIN namespace lancer::kernel {
#define RECORDS_END }

#define FN static inline
#define FN_LARGE [[maybe_unused]] static
#define IN(T) const T&
#define INOUT(T) T&
#define TABLE(T, Name) using Name = const T*;
#define AT(table, i) ((table)[i])
#define RECORD_ADDRESS(T) const T*

#include "lancer/kernel/lanes.h"

#else  // GLSL

#define NAMESPACE_BEGIN
#define NAMESPACE_END
#define RECORDS_BEGIN
#define RECORDS_END

#define FN
#define FN_LARGE
#define IN(T) const T
#define INOUT(T) inout T
#define TABLE(T, Name) \
    layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Name { T items[]; };
#define AT(table, i) ((table).items[i])

#define Float float
#define Int int
#define UInt uint
#define Mask bool
#define Vec2 vec2
#define Vec3 vec3
#define Vec4 vec4
#define LANES 1

bool some(bool m) { return m; }
bool both(bool a, bool b) { return a && b; }
bool either(bool a, bool b) { return a || b; }
bool without(bool a, bool b) { return a && !b; }
int lanes_in(bool m) { return m ? 1 : 0; }
float select(bool m, float a, float b) { return m ? a : b; }
int select(bool m, int a, int b) { return m ? a : b; }
uint select(bool m, uint a, uint b) { return m ? a : b; }
vec3 select(bool m, vec3 a, vec3 b) { return m ? a : b; }
vec4 select(bool m, vec4 a, vec4 b) { return m ? a : b; }
vec2 vec2_of(float x, float y) { return vec2(x, y); }
vec3 vec3_of(float x, float y, float z) { return vec3(x, y, z); }
vec3 vec3_all(float x) { return vec3(x); }
vec4 vec4_of(float x, float y, float z, float w) { return vec4(x, y, z, w); }
vec4 vec4_all(float x) { return vec4(x); }
vec3 broadcast(vec3 v) { return v; }
vec4 broadcast(vec4 v) { return v; }
vec3 reciprocal(vec3 v) { return vec3(1.0f / v.x, 1.0f / v.y, 1.0f / v.z); }
bool is_equal(int a, int b) { return a == b; }
bool is_above(int a, int b) { return a > b; }
int first_of(int x, bool m) { return x; }
bool lane_is_on(bool m, int lane) { return m; }
float lane_of(float x, int lane) { return x; }
int lane_of(int x, int lane) { return x; }
void set_lane(inout float x, int lane, float v) { x = v; }
void set_lane(inout int x, int lane, int v) { x = v; }
int float_bits(float x) { return floatBitsToInt(x); }
float bits_float(int x) { return intBitsToFloat(x); }
float to_float(int x) { return float(x); }
int to_int(float x) { return int(x); }
int as_signed(uint x) { return int(x); }
uint as_unsigned(int x) { return uint(x); }
int round_to_int(float x) { return int(roundEven(x)); }

#endif

#endif
