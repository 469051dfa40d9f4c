#pragma once

#include "engine/math/vectors.h"

// Declares and chooses a constant that a *_lanes.cpp defines in the namespace of each kind of
// vectors (lanes.h). CMake gives the available kinds.
#ifdef ONGGI_VECTORS_AVX2
#define ONGGI_IF_AVX2(...) __VA_ARGS__
#else
#define ONGGI_IF_AVX2(...)
#endif
#ifdef ONGGI_VECTORS_SSE2
#define ONGGI_IF_SSE2(...) __VA_ARGS__
#else
#define ONGGI_IF_SSE2(...)
#endif
#ifdef ONGGI_VECTORS_NEON
#define ONGGI_IF_NEON(...) __VA_ARGS__
#else
#define ONGGI_IF_NEON(...)
#endif
#ifdef ONGGI_VECTORS_PLAIN
#define ONGGI_IF_PLAIN(...) __VA_ARGS__
#else
#define ONGGI_IF_PLAIN(...)
#endif

/// In namespace onggi: declares the constant `name` of every kind, and `choose_name(Vectors)` among
/// them.
#define ONGGI_CHOICE_OF(Type, name)                             \
  ONGGI_IF_AVX2(namespace avx2 { extern const Type name; })     \
  ONGGI_IF_SSE2(namespace sse2 { extern const Type name; })     \
  ONGGI_IF_NEON(namespace neon { extern const Type name; })     \
  ONGGI_IF_PLAIN(namespace plain { extern const Type name; })   \
  static const Type& choose_##name(Vectors kind) noexcept {     \
    switch (kind) {                                             \
      ONGGI_IF_AVX2(case Vectors::avx2 : return avx2::name;)    \
      ONGGI_IF_SSE2(case Vectors::sse2 : return sse2::name;)    \
      ONGGI_IF_NEON(case Vectors::neon : return neon::name;)    \
      ONGGI_IF_PLAIN(case Vectors::plain : return plain::name;) \
      default:                                                  \
        break;                                                  \
    }                                                           \
    __builtin_unreachable();                                    \
  }
