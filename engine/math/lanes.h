// Eight floats worked on together, on whatever vectors the machine has: one AVX register, two of
// SSE's or NEON's size, or plain arrays. Compiled once for each kind: include it only from files
// that hwy/foreach_target.h compiles again, and after that header. Every operation is IEEE 754's on
// each lane alone: no fused operations, no reciprocals, sums always in the same order. So the bits
// do not depend on the vectors.
#if defined(ONGGI_MATH_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ONGGI_MATH_LANES_H
#undef ONGGI_MATH_LANES_H
#else
#define ONGGI_MATH_LANES_H
#endif

#include <hwy/highway.h>

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace onggi::HWY_NAMESPACE {

inline constexpr int kLanes = 8;

#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128

/// Eight yes or no answers.
struct Mask8 {
  bool v[kLanes];
};
/// Eight floats.
struct Float8 {
  float v[kLanes];
};

#define ONGGI_EACH(Result, expression)                        \
  {                                                           \
    Result out;                                               \
    for (int k = 0; k < kLanes; ++k) out.v[k] = (expression); \
    return out;                                               \
  }
inline Float8 all(float value) ONGGI_EACH(Float8, value) inline Float8 load(const float* p)
    ONGGI_EACH(Float8, p[k]) inline void store(Float8 a, float* p) {
  for (int k = 0; k < kLanes; ++k) p[k] = a.v[k];
}
/// Towards zero; |a| below 2^31.
inline void store_whole(Float8 a, int* p) {
  for (int k = 0; k < kLanes; ++k) p[k] = static_cast<int>(a.v[k]);
}
inline Float8 operator+(Float8 a, Float8 b) ONGGI_EACH(Float8, a.v[k] + b.v[k]) inline Float8
operator-(Float8 a, Float8 b) ONGGI_EACH(Float8, a.v[k] - b.v[k]) inline Float8
operator*(Float8 a, Float8 b) ONGGI_EACH(Float8, a.v[k] * b.v[k]) inline Float8
operator/(Float8 a, Float8 b) ONGGI_EACH(Float8, a.v[k] / b.v[k]) inline Float8 sqrt(Float8 a)
    ONGGI_EACH(Float8, std::sqrt(a.v[k])) inline Float8 abs(Float8 a)
        ONGGI_EACH(Float8, std::fabs(a.v[k])) inline Mask8
        operator<(Float8 a, Float8 b) ONGGI_EACH(Mask8, a.v[k] < b.v[k]) inline Mask8
        operator>(Float8 a, Float8 b) ONGGI_EACH(Mask8, a.v[k] > b.v[k]) inline Mask8
        operator&(Mask8 a, Mask8 b) ONGGI_EACH(Mask8, a.v[k] && b.v[k]) inline Mask8
        operator|(Mask8 a, Mask8 b) ONGGI_EACH(Mask8, a.v[k] || b.v[k])
    /// `yes` where `mask`, else `no`.
    inline Float8 select(Mask8 mask, Float8 yes, Float8 no)
        ONGGI_EACH(Float8, mask.v[k] ? yes.v[k] : no.v[k])
    /// `yes` where `mask`, else 0.
    inline Float8 only(Mask8 mask, Float8 yes) ONGGI_EACH(Float8, mask.v[k] ? yes.v[k] : 0.0f)
    /// The larger; `b` where either is NaN.
    inline Float8 larger(Float8 a, Float8 b) ONGGI_EACH(Float8, a.v[k] > b.v[k] ? a.v[k] : b.v[k])
    /// The smaller; `b` where either is NaN.
    inline Float8 smaller(Float8 a, Float8 b) ONGGI_EACH(Float8, a.v[k] < b.v[k] ? a.v[k] : b.v[k])
#undef ONGGI_EACH

    /// How many lanes say yes.
    inline int count(Mask8 m) {
  int yes = 0;
  for (bool one : m.v) yes += one;
  return yes;
}
inline bool none(Mask8 m) { return count(m) == 0; }

#else

namespace hn = hwy::HWY_NAMESPACE;
using PartTag = hn::CappedTag<float, kLanes>;
using PartWhole = hn::RebindToSigned<PartTag>;

// A function of Highway on each part. HWY_MAX_BYTES is the size of this target's vectors.
#if HWY_MAX_BYTES >= 32
#define ONGGI_PARTS(type) type low
#define ONGGI_EACH1(f, a) \
  { f(a.low) }
#define ONGGI_EACH2(f, a, b) \
  { f(a.low, b.low) }
#define ONGGI_EACH3(f, a, b, c) \
  { f(a.low, b.low, c.low) }
#else
#define ONGGI_PARTS(type) type low, high
#define ONGGI_EACH1(f, a) \
  { f(a.low), f(a.high) }
#define ONGGI_EACH2(f, a, b) \
  { f(a.low, b.low), f(a.high, b.high) }
#define ONGGI_EACH3(f, a, b, c) \
  { f(a.low, b.low, c.low), f(a.high, b.high, c.high) }
#endif

struct Mask8 {
  ONGGI_PARTS(hn::Mask<PartTag>);
};
struct Float8 {
  ONGGI_PARTS(hn::Vec<PartTag>);
};

#if HWY_MAX_BYTES >= 32
HWY_INLINE Float8 all(float value) { return {hn::Set(PartTag(), value)}; }
HWY_INLINE Float8 load(const float* p) { return {hn::LoadU(PartTag(), p)}; }
HWY_INLINE void store(Float8 a, float* p) { hn::StoreU(a.low, PartTag(), p); }
HWY_INLINE void store_whole(Float8 a, int* p) {
  hn::StoreU(hn::ConvertTo(PartWhole(), a.low), PartWhole(), p);
}
HWY_INLINE bool none(Mask8 m) { return hn::AllFalse(PartTag(), m.low); }
HWY_INLINE int count(Mask8 m) { return static_cast<int>(hn::CountTrue(PartTag(), m.low)); }
#else
HWY_INLINE Float8 all(float value) {
  return {hn::Set(PartTag(), value), hn::Set(PartTag(), value)};
}
HWY_INLINE Float8 load(const float* p) {
  return {hn::LoadU(PartTag(), p), hn::LoadU(PartTag(), p + 4)};
}
HWY_INLINE void store(Float8 a, float* p) {
  hn::StoreU(a.low, PartTag(), p);
  hn::StoreU(a.high, PartTag(), p + 4);
}
HWY_INLINE void store_whole(Float8 a, int* p) {
  hn::StoreU(hn::ConvertTo(PartWhole(), a.low), PartWhole(), p);
  hn::StoreU(hn::ConvertTo(PartWhole(), a.high), PartWhole(), p + 4);
}
HWY_INLINE bool none(Mask8 m) { return hn::AllFalse(PartTag(), hn::Or(m.low, m.high)); }
HWY_INLINE int count(Mask8 m) {
  return static_cast<int>(hn::CountTrue(PartTag(), m.low) + hn::CountTrue(PartTag(), m.high));
}
#endif

HWY_INLINE Float8 operator+(Float8 a, Float8 b) { return ONGGI_EACH2(hn::Add, a, b); }
HWY_INLINE Float8 operator-(Float8 a, Float8 b) { return ONGGI_EACH2(hn::Sub, a, b); }
HWY_INLINE Float8 operator*(Float8 a, Float8 b) { return ONGGI_EACH2(hn::Mul, a, b); }
HWY_INLINE Float8 operator/(Float8 a, Float8 b) { return ONGGI_EACH2(hn::Div, a, b); }
HWY_INLINE Float8 sqrt(Float8 a) { return ONGGI_EACH1(hn::Sqrt, a); }
HWY_INLINE Float8 abs(Float8 a) { return ONGGI_EACH1(hn::Abs, a); }
HWY_INLINE Mask8 operator<(Float8 a, Float8 b) { return ONGGI_EACH2(hn::Lt, a, b); }
HWY_INLINE Mask8 operator>(Float8 a, Float8 b) { return ONGGI_EACH2(hn::Gt, a, b); }
HWY_INLINE Mask8 operator&(Mask8 a, Mask8 b) { return ONGGI_EACH2(hn::And, a, b); }
HWY_INLINE Mask8 operator|(Mask8 a, Mask8 b) { return ONGGI_EACH2(hn::Or, a, b); }
HWY_INLINE Float8 select(Mask8 mask, Float8 yes, Float8 no) {
  return ONGGI_EACH3(hn::IfThenElse, mask, yes, no);
}
HWY_INLINE Float8 only(Mask8 mask, Float8 yes) {
  return ONGGI_EACH2(hn::IfThenElseZero, mask, yes);
}
#if HWY_ARCH_X86
// x86's own maximum is `b` where either is NaN; others' is not.
HWY_INLINE Float8 larger(Float8 a, Float8 b) { return ONGGI_EACH2(hn::Max, a, b); }
HWY_INLINE Float8 smaller(Float8 a, Float8 b) { return ONGGI_EACH2(hn::Min, a, b); }
#else
HWY_INLINE Float8 larger(Float8 a, Float8 b) { return select(a > b, a, b); }
HWY_INLINE Float8 smaller(Float8 a, Float8 b) { return select(a < b, a, b); }
#endif

#undef ONGGI_PARTS
#undef ONGGI_EACH1
#undef ONGGI_EACH2
#undef ONGGI_EACH3
#endif

/// Lanes added in pairs, always the same ones.
HWY_INLINE float sum(Float8 a) {
  float v[kLanes];
  store(a, v);
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}
HWY_INLINE float largest(Float8 a) {
  float v[kLanes];
  store(a, v);
  float most = v[0];
  for (int k = 1; k < kLanes; ++k) most = v[k] > most ? v[k] : most;
  return most;
}
HWY_INLINE float smallest(Float8 a) {
  float v[kLanes];
  store(a, v);
  float least = v[0];
  for (int k = 1; k < kLanes; ++k) least = v[k] < least ? v[k] : least;
  return least;
}

}  // namespace onggi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
