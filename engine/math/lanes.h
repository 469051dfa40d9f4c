#pragma once

// Works on eight floats at once, with the vectors that this source is compiled for: one register of
// AVX2, two of SSE2 or NEON, or an array. Every operation is IEEE 754's on each lane alone: no
// fused operation, no reciprocal, sums always in the same order. The bits therefore do not depend
// on the vectors.
//
// A source named *_lanes.cpp is compiled once for each kind of vectors. CMake gives it the kind's
// name as ONGGI_LANES, and a namespace of that name (onggi::avx2) separates the copies. Code
// compiled for AVX2 may run only on processors with AVX2, so such a source must not use anything
// that other sources share: no member function, no template of the standard library (the linker
// keeps one copy of those, and might choose this one). Other sources get the kind that every
// processor of theirs has.
#if !defined(ONGGI_LANES)
#if defined(__SSE2__)
#define ONGGI_LANES sse2
#define ONGGI_LANES_SSE2
#elif defined(__aarch64__)
#define ONGGI_LANES neon
#define ONGGI_LANES_NEON
#else
#define ONGGI_LANES plain
#define ONGGI_LANES_PLAIN
#endif
#endif

#define ONGGI_INLINE [[gnu::always_inline]] inline

namespace onggi {
inline constexpr int kLanes = 8;
}

#if defined(ONGGI_LANES_AVX2)
#include "engine/math/lanes_avx2.h"
#elif defined(ONGGI_LANES_SSE2)
#include "engine/math/lanes_sse2.h"
#elif defined(ONGGI_LANES_NEON)
#include "engine/math/lanes_neon.h"
#else
#include "engine/math/lanes_plain.h"
#endif

#if !defined(ONGGI_LANES_AVX2)  // which has its own
namespace onggi::ONGGI_LANES {

/// Of each lane the one before it; of the first, the last of `before`.
ONGGI_INLINE Float8 one_back(Float8 before, Float8 a) {
  float line[kLanes + 1];
  store(before, line);
  line[0] = line[kLanes - 1];
  store(a, line + 1);
  return load(line);
}
/// Of each lane the one after it; of the last, the first of `after`.
ONGGI_INLINE Float8 one_on(Float8 a, Float8 after) {
  float line[2 * kLanes];
  store(a, line);
  store(after, line + kLanes);
  return load(line + 1);
}
/// Lanes added in pairs, always the same ones.
ONGGI_INLINE float sum(Float8 a) {
  float v[kLanes];
  store(a, v);
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}
ONGGI_INLINE float largest(Float8 a) {
  float v[kLanes];
  store(a, v);
  float most = v[0];
  for (int k = 1; k < kLanes; ++k) most = v[k] > most ? v[k] : most;
  return most;
}
ONGGI_INLINE float smallest(Float8 a) {
  float v[kLanes];
  store(a, v);
  float least = v[0];
  for (int k = 1; k < kLanes; ++k) least = v[k] < least ? v[k] : least;
  return least;
}

}  // namespace onggi::ONGGI_LANES
#endif
