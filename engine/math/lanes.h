#pragma once

#include <cmath>
#include <cstddef>

/// Eight floats worked on together, as two SSE-sized halves (the vector extension of g++ and
/// clang). Every operation is IEEE 754's on each lane alone, so the bits do not depend on the width
/// of the machine's vectors. No fused operations, no reciprocals.
namespace onggi {

inline constexpr int kLanes = 8;

namespace lanes_detail {
using F4 = float __attribute__((vector_size(16)));
using I4 = int __attribute__((vector_size(16)));

inline F4 square_root(F4 x) {
#ifdef __SSE__
  return __builtin_ia32_sqrtps(x);  // correctly rounded, as std::sqrt is
#else
  return F4{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
#endif
}
}  // namespace lanes_detail

/// Eight yes or no answers: all bits set, or none.
struct Mask8 {
  lanes_detail::I4 lo, hi;
  friend Mask8 operator&(Mask8 a, Mask8 b) { return {a.lo & b.lo, a.hi & b.hi}; }
  friend Mask8 operator|(Mask8 a, Mask8 b) { return {a.lo | b.lo, a.hi | b.hi}; }
  friend Mask8 operator~(Mask8 a) { return {~a.lo, ~a.hi}; }
};

struct Float8 {
  lanes_detail::F4 lo, hi;

  Float8() : Float8(0.0f) {}
  Float8(float all) : lo{all, all, all, all}, hi{all, all, all, all} {}  // a scalar is eight lanes
  Float8(lanes_detail::F4 low, lanes_detail::F4 high) : lo(low), hi(high) {}

  static Float8 load(const float* p) {
    Float8 v;
    __builtin_memcpy(&v.lo, p, sizeof v.lo);
    __builtin_memcpy(&v.hi, p + 4, sizeof v.hi);
    return v;
  }
  void store(float* p) const {
    __builtin_memcpy(p, &lo, sizeof lo);
    __builtin_memcpy(p + 4, &hi, sizeof hi);
  }
  float operator[](std::size_t k) const { return k < 4 ? lo[k] : hi[k - 4]; }

  friend Float8 operator+(Float8 a, Float8 b) { return {a.lo + b.lo, a.hi + b.hi}; }
  friend Float8 operator-(Float8 a, Float8 b) { return {a.lo - b.lo, a.hi - b.hi}; }
  friend Float8 operator*(Float8 a, Float8 b) { return {a.lo * b.lo, a.hi * b.hi}; }
  friend Float8 operator/(Float8 a, Float8 b) { return {a.lo / b.lo, a.hi / b.hi}; }
  friend Mask8 operator<(Float8 a, Float8 b) { return {a.lo < b.lo, a.hi < b.hi}; }
  friend Mask8 operator>(Float8 a, Float8 b) { return {a.lo > b.lo, a.hi > b.hi}; }
};

inline Mask8 select_mask(Mask8 mask, Mask8 yes, Mask8 no) { return (mask & yes) | (~mask & no); }
/// `yes` where `mask`, else `no`.
inline Float8 select(Mask8 mask, Float8 yes, Float8 no) {
  using namespace lanes_detail;
  return {(F4)((mask.lo & (I4)yes.lo) | (~mask.lo & (I4)no.lo)),
          (F4)((mask.hi & (I4)yes.hi) | (~mask.hi & (I4)no.hi))};
}
inline Float8 larger(Float8 a, Float8 b) { return select(a > b, a, b); }
inline Float8 smaller(Float8 a, Float8 b) { return select(a < b, a, b); }
inline Float8 abs(Float8 a) { return select(a < Float8(0.0f), Float8(0.0f) - a, a); }
inline Float8 sqrt(Float8 a) {
  return {lanes_detail::square_root(a.lo), lanes_detail::square_root(a.hi)};
}

inline bool any(Mask8 m) {
  long long words[2];
  const lanes_detail::I4 both = m.lo | m.hi;
  __builtin_memcpy(words, &both, sizeof words);
  return (words[0] | words[1]) != 0;
}
/// How many lanes say yes.
inline int count(Mask8 m) {
  const lanes_detail::I4 each = m.lo + m.hi;  // yes is -1
  return -(each[0] + each[1] + each[2] + each[3]);
}
/// The lanes numbered 0.. that lie below `end`.
inline Mask8 lanes_below(int end) {
  const lanes_detail::I4 low{0, 1, 2, 3};
  const lanes_detail::I4 high{4, 5, 6, 7};
  const lanes_detail::I4 limit{end, end, end, end};
  return {low < limit, high < limit};
}
/// Lanes added in pairs, always the same ones.
inline float sum(Float8 a) {
  const lanes_detail::F4 v = a.lo + a.hi;
  return (v[0] + v[2]) + (v[1] + v[3]);
}
inline float largest(Float8 a) {
  float most = a[0];
  for (std::size_t k = 1; k < kLanes; ++k) most = a[k] > most ? a[k] : most;
  return most;
}

}  // namespace onggi
