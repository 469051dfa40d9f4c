#pragma once

// Eight lanes in one register of AVX2: see engine/math/lanes.h, which includes this.
#ifdef __AVX2__

#include <immintrin.h>

namespace onggi::avx2 {

struct Float8 {
  __m256 v;
};
/// Eight yes or no answers: all bits of a lane, or none.
struct Mask8 {
  __m256 v;
};

[[gnu::always_inline]] inline Float8 all(float value) { return {_mm256_set1_ps(value)}; }
[[gnu::always_inline]] inline Float8 load(const float* p) { return {_mm256_loadu_ps(p)}; }
[[gnu::always_inline]] inline void store(Float8 a, float* p) { _mm256_storeu_ps(p, a.v); }
/// Towards zero; |a| below 2^31.
[[gnu::always_inline]] inline void store_whole(Float8 a, int* p) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), _mm256_cvttps_epi32(a.v));
}
[[gnu::always_inline]] inline Float8 operator+(Float8 a, Float8 b) {
  return {_mm256_add_ps(a.v, b.v)};
}
[[gnu::always_inline]] inline Float8 operator-(Float8 a, Float8 b) {
  return {_mm256_sub_ps(a.v, b.v)};
}
[[gnu::always_inline]] inline Float8 operator*(Float8 a, Float8 b) {
  return {_mm256_mul_ps(a.v, b.v)};
}
[[gnu::always_inline]] inline Float8 operator/(Float8 a, Float8 b) {
  return {_mm256_div_ps(a.v, b.v)};
}
[[gnu::always_inline]] inline Float8 sqrt(Float8 a) { return {_mm256_sqrt_ps(a.v)}; }
[[gnu::always_inline]] inline Float8 abs(Float8 a) {
  return {_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v)};
}
[[gnu::always_inline]] inline Mask8 operator<(Float8 a, Float8 b) {
  return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)};
}
[[gnu::always_inline]] inline Mask8 operator>(Float8 a, Float8 b) {
  return {_mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ)};
}
[[gnu::always_inline]] inline Mask8 operator&(Mask8 a, Mask8 b) {
  return {_mm256_and_ps(a.v, b.v)};
}
[[gnu::always_inline]] inline Mask8 operator|(Mask8 a, Mask8 b) { return {_mm256_or_ps(a.v, b.v)}; }
/// `yes` where `mask`, else `no`.
[[gnu::always_inline]] inline Float8 select(Mask8 mask, Float8 yes, Float8 no) {
  return {_mm256_blendv_ps(no.v, yes.v, mask.v)};
}
/// `yes` where `mask`, else 0.
[[gnu::always_inline]] inline Float8 only(Mask8 mask, Float8 yes) {
  return {_mm256_and_ps(mask.v, yes.v)};
}
/// The larger; `b` where either is NaN.
[[gnu::always_inline]] inline Float8 larger(Float8 a, Float8 b) {
  return {_mm256_max_ps(a.v, b.v)};
}
/// The smaller; `b` where either is NaN.
[[gnu::always_inline]] inline Float8 smaller(Float8 a, Float8 b) {
  return {_mm256_min_ps(a.v, b.v)};
}
/// How many lanes say yes.
[[gnu::always_inline]] inline int count(Mask8 m) {
  return __builtin_popcount(static_cast<unsigned>(_mm256_movemask_ps(m.v)));
}
/// Bit k says what lane k says.
[[gnu::always_inline]] inline unsigned bits(Mask8 m) {
  return static_cast<unsigned>(_mm256_movemask_ps(m.v));
}
[[gnu::always_inline]] inline bool none(Mask8 m) { return _mm256_testz_ps(m.v, m.v) != 0; }

/// Of each lane the one before it; of the first, the last of `before`.
[[gnu::always_inline]] inline Float8 one_back(Float8 before, Float8 a) {
  const __m256 across = _mm256_permute2f128_ps(before.v, a.v, 0x21);
  return {_mm256_castsi256_ps(
      _mm256_alignr_epi8(_mm256_castps_si256(a.v), _mm256_castps_si256(across), 12))};
}
/// Of each lane the one after it; of the last, the first of `after`.
[[gnu::always_inline]] inline Float8 one_on(Float8 a, Float8 after) {
  const __m256 across = _mm256_permute2f128_ps(a.v, after.v, 0x21);
  return {_mm256_castsi256_ps(
      _mm256_alignr_epi8(_mm256_castps_si256(across), _mm256_castps_si256(a.v), 4))};
}

/// Lanes in pairs: k with k + 4, those with the next but one, and the last two. As everywhere else.
template <class Join>
[[gnu::always_inline]] inline float joined(Float8 a, const Join& join) {
  const __m128 four = join(_mm256_castps256_ps128(a.v), _mm256_extractf128_ps(a.v, 1));
  const __m128 two = join(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(join(two, _mm_shuffle_ps(two, two, 1)));
}
[[gnu::always_inline]] inline float sum(Float8 a) {
  return joined(a, [](__m128 b, __m128 c) { return _mm_add_ps(b, c); });
}
[[gnu::always_inline]] inline float largest(Float8 a) {
  return joined(a, [](__m128 b, __m128 c) { return _mm_max_ps(b, c); });
}
[[gnu::always_inline]] inline float smallest(Float8 a) {
  return joined(a, [](__m128 b, __m128 c) { return _mm_min_ps(b, c); });
}

}  // namespace onggi::avx2

#endif
