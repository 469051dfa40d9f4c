#pragma once

// Eight lanes in two registers of NEON, which every 64-bit ARM has: see engine/math/lanes.h, which
// includes this.
#ifdef __aarch64__

#include <arm_neon.h>

namespace onggi::neon {

struct Float8 {
  float32x4_t low, high;
};
/// Eight yes or no answers: all bits of a lane, or none.
struct Mask8 {
  uint32x4_t low, high;
};

[[gnu::always_inline]] inline Float8 all(float value) {
  return {vdupq_n_f32(value), vdupq_n_f32(value)};
}
[[gnu::always_inline]] inline Float8 load(const float* p) {
  return {vld1q_f32(p), vld1q_f32(p + 4)};
}
[[gnu::always_inline]] inline void store(Float8 a, float* p) {
  vst1q_f32(p, a.low);
  vst1q_f32(p + 4, a.high);
}
/// Towards zero; |a| below 2^31.
[[gnu::always_inline]] inline void store_whole(Float8 a, int* p) {
  vst1q_s32(p, vcvtq_s32_f32(a.low));
  vst1q_s32(p + 4, vcvtq_s32_f32(a.high));
}
[[gnu::always_inline]] inline Float8 operator+(Float8 a, Float8 b) {
  return {vaddq_f32(a.low, b.low), vaddq_f32(a.high, b.high)};
}
[[gnu::always_inline]] inline Float8 operator-(Float8 a, Float8 b) {
  return {vsubq_f32(a.low, b.low), vsubq_f32(a.high, b.high)};
}
[[gnu::always_inline]] inline Float8 operator*(Float8 a, Float8 b) {
  return {vmulq_f32(a.low, b.low), vmulq_f32(a.high, b.high)};
}
[[gnu::always_inline]] inline Float8 operator/(Float8 a, Float8 b) {
  return {vdivq_f32(a.low, b.low), vdivq_f32(a.high, b.high)};
}
[[gnu::always_inline]] inline Float8 sqrt(Float8 a) {
  return {vsqrtq_f32(a.low), vsqrtq_f32(a.high)};
}
[[gnu::always_inline]] inline Float8 abs(Float8 a) { return {vabsq_f32(a.low), vabsq_f32(a.high)}; }
[[gnu::always_inline]] inline Mask8 operator<(Float8 a, Float8 b) {
  return {vcltq_f32(a.low, b.low), vcltq_f32(a.high, b.high)};
}
[[gnu::always_inline]] inline Mask8 operator>(Float8 a, Float8 b) {
  return {vcgtq_f32(a.low, b.low), vcgtq_f32(a.high, b.high)};
}
[[gnu::always_inline]] inline Mask8 operator&(Mask8 a, Mask8 b) {
  return {vandq_u32(a.low, b.low), vandq_u32(a.high, b.high)};
}
[[gnu::always_inline]] inline Mask8 operator|(Mask8 a, Mask8 b) {
  return {vorrq_u32(a.low, b.low), vorrq_u32(a.high, b.high)};
}
/// `yes` where `mask`, else `no`.
[[gnu::always_inline]] inline Float8 select(Mask8 mask, Float8 yes, Float8 no) {
  return {vbslq_f32(mask.low, yes.low, no.low), vbslq_f32(mask.high, yes.high, no.high)};
}
/// `yes` where `mask`, else 0.
[[gnu::always_inline]] inline Float8 only(Mask8 mask, Float8 yes) {
  return select(mask, yes, all(0.0f));
}
/// The larger; `b` where either is NaN, which is not what NEON's own maximum gives.
[[gnu::always_inline]] inline Float8 larger(Float8 a, Float8 b) { return select(a > b, a, b); }
/// The smaller; `b` where either is NaN.
[[gnu::always_inline]] inline Float8 smaller(Float8 a, Float8 b) { return select(a < b, a, b); }
/// How many lanes say yes.
[[gnu::always_inline]] inline int count(Mask8 m) {
  return -vaddvq_s32(vreinterpretq_s32_u32(vaddq_u32(m.low, m.high)));
}
/// Bit k says what lane k says.
[[gnu::always_inline]] inline unsigned bits(Mask8 m) {
  const uint32x4_t low{1, 2, 4, 8};
  const uint32x4_t high{16, 32, 64, 128};
  return vaddvq_u32(vorrq_u32(vandq_u32(m.low, low), vandq_u32(m.high, high)));
}
[[gnu::always_inline]] inline bool none(Mask8 m) {
  return vmaxvq_u32(vorrq_u32(m.low, m.high)) == 0;
}

}  // namespace onggi::neon

#endif
