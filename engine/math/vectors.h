#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace onggi {

/// The kinds of vectors that loops over eight floats (engine/math/lanes.h) are compiled for. All
/// give the same bits; only the speed differs.
enum class Vectors : std::uint8_t {
  plain,  ///< Arrays, for processors without vectors, and the reference in tests.
  neon,   ///< Of every 64-bit ARM.
  sse2,   ///< Of every 64-bit x86.
  avx2,
};

/// The kinds that this program contains and this machine can run, best first; never empty. Any
/// thread.
std::span<const Vectors> vectors_here() noexcept;
/// The first of them.
Vectors best_vectors() noexcept;

std::string_view name_of(Vectors kind) noexcept;  ///< "avx2"

}  // namespace onggi
