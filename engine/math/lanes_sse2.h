#pragma once

// Eight lanes in two registers of SSE2, which every 64-bit x86 has: see engine/math/lanes.h, which
// includes this.
#ifdef __SSE2__

#include <emmintrin.h>

namespace onggi::sse2 {

struct Float8 {
  __m128 low, high;
};
/// Eight yes or no answers: all bits of a lane, or none.
struct Mask8 {
  __m128 low, high;
};

[[gnu::always_inline]] inline Float8 all(float value) {
  return {_mm_set1_ps(value), _mm_set1_ps(value)};
}
[[gnu::always_inline]] inline Float8 load(const float* p) {
  return {_mm_loadu_ps(p), _mm_loadu_ps(p + 4)};
}
[[gnu::always_inline]] inline void store(Float8 a, float* p) {
  _mm_storeu_ps(p, a.low);
  _mm_storeu_ps(p + 4, a.high);
}
/// Towards zero; |a| below 2^31.
[[gnu::always_inline]] inline void store_whole(Float8 a, int* p) {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(p), _mm_cvttps_epi32(a.low));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(p + 4), _mm_cvttps_epi32(a.high));
}
[[gnu::always_inline]] inline Float8 operator+(Float8 a, Float8 b) {
  return {_mm_add_ps(a.low, b.low), _mm_add_ps(a.high, b.high)};
}
[[gnu::always_inline]] inline Float8 operator-(Float8 a, Float8 b) {
  return {_mm_sub_ps(a.low, b.low), _mm_sub_ps(a.high, b.high)};
}
[[gnu::always_inline]] inline Float8 operator*(Float8 a, Float8 b) {
  return {_mm_mul_ps(a.low, b.low), _mm_mul_ps(a.high, b.high)};
}
[[gnu::always_inline]] inline Float8 operator/(Float8 a, Float8 b) {
  return {_mm_div_ps(a.low, b.low), _mm_div_ps(a.high, b.high)};
}
[[gnu::always_inline]] inline Float8 sqrt(Float8 a) {
  return {_mm_sqrt_ps(a.low), _mm_sqrt_ps(a.high)};
}
[[gnu::always_inline]] inline Float8 abs(Float8 a) {
  const __m128 sign = _mm_set1_ps(-0.0f);
  return {_mm_andnot_ps(sign, a.low), _mm_andnot_ps(sign, a.high)};
}
[[gnu::always_inline]] inline Mask8 operator<(Float8 a, Float8 b) {
  return {_mm_cmplt_ps(a.low, b.low), _mm_cmplt_ps(a.high, b.high)};
}
[[gnu::always_inline]] inline Mask8 operator>(Float8 a, Float8 b) {
  return {_mm_cmpgt_ps(a.low, b.low), _mm_cmpgt_ps(a.high, b.high)};
}
[[gnu::always_inline]] inline Mask8 operator&(Mask8 a, Mask8 b) {
  return {_mm_and_ps(a.low, b.low), _mm_and_ps(a.high, b.high)};
}
[[gnu::always_inline]] inline Mask8 operator|(Mask8 a, Mask8 b) {
  return {_mm_or_ps(a.low, b.low), _mm_or_ps(a.high, b.high)};
}
/// `yes` where `mask`, else `no`.
[[gnu::always_inline]] inline Float8 select(Mask8 mask, Float8 yes, Float8 no) {
  return {_mm_or_ps(_mm_and_ps(mask.low, yes.low), _mm_andnot_ps(mask.low, no.low)),
          _mm_or_ps(_mm_and_ps(mask.high, yes.high), _mm_andnot_ps(mask.high, no.high))};
}
/// `yes` where `mask`, else 0.
[[gnu::always_inline]] inline Float8 only(Mask8 mask, Float8 yes) {
  return {_mm_and_ps(mask.low, yes.low), _mm_and_ps(mask.high, yes.high)};
}
/// The larger; `b` where either is NaN.
[[gnu::always_inline]] inline Float8 larger(Float8 a, Float8 b) {
  return {_mm_max_ps(a.low, b.low), _mm_max_ps(a.high, b.high)};
}
/// The smaller; `b` where either is NaN.
[[gnu::always_inline]] inline Float8 smaller(Float8 a, Float8 b) {
  return {_mm_min_ps(a.low, b.low), _mm_min_ps(a.high, b.high)};
}
/// How many lanes say yes. SSE2 counts no bits: a lane that says yes is -1, and four sums of two
/// are added.
[[gnu::always_inline]] inline int count(Mask8 m) {
  const __m128i pairs = _mm_add_epi32(_mm_castps_si128(m.low), _mm_castps_si128(m.high));
  const __m128i fours = _mm_add_epi32(pairs, _mm_shuffle_epi32(pairs, 0x4e));
  const __m128i eight = _mm_add_epi32(fours, _mm_shuffle_epi32(fours, 0xb1));
  return -_mm_cvtsi128_si32(eight);
}
/// Bit k says what lane k says.
[[gnu::always_inline]] inline unsigned bits(Mask8 m) {
  return static_cast<unsigned>(_mm_movemask_ps(m.low) | _mm_movemask_ps(m.high) << 4);
}
[[gnu::always_inline]] inline bool none(Mask8 m) {
  return _mm_movemask_ps(_mm_or_ps(m.low, m.high)) == 0;
}

}  // namespace onggi::sse2

#endif
