#include "engine/math/vectors.h"

#include <array>
#include <cstddef>

namespace onggi {
namespace {

// CMake says which kinds were compiled: ONGGI_VECTORS_AVX2 and so on, in CMakeLists.txt.
struct Here {
  std::array<Vectors, 4> kinds{};
  std::size_t count = 0;

  Here() noexcept {
#ifdef ONGGI_VECTORS_AVX2
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2")) kinds[count++] = Vectors::avx2;
#endif
#ifdef ONGGI_VECTORS_SSE2
    kinds[count++] = Vectors::sse2;
#endif
#ifdef ONGGI_VECTORS_NEON
    kinds[count++] = Vectors::neon;
#endif
#ifdef ONGGI_VECTORS_PLAIN
    kinds[count++] = Vectors::plain;
#endif
  }
};

}  // namespace

std::span<const Vectors> vectors_here() noexcept {
  static const Here here;
  return {here.kinds.data(), here.count};
}

Vectors best_vectors() noexcept { return vectors_here().front(); }

std::string_view name_of(Vectors kind) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"plain", "neon", "sse2", "avx2"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace onggi
