#pragma once

// Eight lanes in an array, for processors whose vectors nobody wrote down, and for tests to hold
// the others to: see engine/math/lanes.h, which includes this.

namespace onggi::plain {

struct Float8 {
  float v[8];
};
/// Eight yes or no answers.
struct Mask8 {
  bool v[8];
};

template <class Result, class Lane>
[[gnu::always_inline]] inline Result each_lane(Lane lane) {
  Result out;
  for (int k = 0; k < 8; ++k) out.v[k] = lane(k);
  return out;
}

inline Float8 all(float value) {
  return each_lane<Float8>([&](int) { return value; });
}
inline Float8 load(const float* p) {
  return each_lane<Float8>([&](int k) { return p[k]; });
}
inline void store(const Float8& a, float* p) {
  for (int k = 0; k < 8; ++k) p[k] = a.v[k];
}
/// Towards zero; |a| below 2^31.
inline void store_whole(const Float8& a, int* p) {
  for (int k = 0; k < 8; ++k) p[k] = static_cast<int>(a.v[k]);
}
inline Float8 operator+(const Float8& a, const Float8& b) {
  return each_lane<Float8>([&](int k) { return a.v[k] + b.v[k]; });
}
inline Float8 operator-(const Float8& a, const Float8& b) {
  return each_lane<Float8>([&](int k) { return a.v[k] - b.v[k]; });
}
inline Float8 operator*(const Float8& a, const Float8& b) {
  return each_lane<Float8>([&](int k) { return a.v[k] * b.v[k]; });
}
inline Float8 operator/(const Float8& a, const Float8& b) {
  return each_lane<Float8>([&](int k) { return a.v[k] / b.v[k]; });
}
inline Float8 sqrt(const Float8& a) {
  return each_lane<Float8>([&](int k) { return __builtin_sqrtf(a.v[k]); });
}
inline Float8 abs(const Float8& a) {
  return each_lane<Float8>([&](int k) { return __builtin_fabsf(a.v[k]); });
}
inline Mask8 operator<(const Float8& a, const Float8& b) {
  return each_lane<Mask8>([&](int k) { return a.v[k] < b.v[k]; });
}
inline Mask8 operator>(const Float8& a, const Float8& b) {
  return each_lane<Mask8>([&](int k) { return a.v[k] > b.v[k]; });
}
inline Mask8 operator&(const Mask8& a, const Mask8& b) {
  return each_lane<Mask8>([&](int k) { return a.v[k] && b.v[k]; });
}
inline Mask8 operator|(const Mask8& a, const Mask8& b) {
  return each_lane<Mask8>([&](int k) { return a.v[k] || b.v[k]; });
}
/// `yes` where `mask`, else `no`.
inline Float8 select(const Mask8& mask, const Float8& yes, const Float8& no) {
  return each_lane<Float8>([&](int k) { return mask.v[k] ? yes.v[k] : no.v[k]; });
}
/// `yes` where `mask`, else 0.
inline Float8 only(const Mask8& mask, const Float8& yes) {
  return each_lane<Float8>([&](int k) { return mask.v[k] ? yes.v[k] : 0.0f; });
}
/// The larger; `b` where either is NaN.
inline Float8 larger(const Float8& a, const Float8& b) {
  return each_lane<Float8>([&](int k) { return a.v[k] > b.v[k] ? a.v[k] : b.v[k]; });
}
/// The smaller; `b` where either is NaN.
inline Float8 smaller(const Float8& a, const Float8& b) {
  return each_lane<Float8>([&](int k) { return a.v[k] < b.v[k] ? a.v[k] : b.v[k]; });
}
/// How many lanes say yes.
inline int count(const Mask8& m) {
  int yes = 0;
  for (const bool one : m.v) yes += one;
  return yes;
}
/// Bit k says what lane k says.
inline unsigned bits(const Mask8& m) {
  unsigned yes = 0;
  for (int k = 0; k < 8; ++k) yes |= static_cast<unsigned>(m.v[k]) << k;
  return yes;
}
inline bool none(const Mask8& m) { return count(m) == 0; }

}  // namespace onggi::plain
