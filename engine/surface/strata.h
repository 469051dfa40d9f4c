#pragma once

#include <array>
#include <cstdint>

#include "engine/surface/grid.h"

namespace onggi::surface {

inline constexpr int kStrata = 3;
inline constexpr int kPigments = 16;
/// Codes of a thickness: 0 is none, the others are quarter octaves from 2 um to 4.1 mm.
inline constexpr int kCodes = 46;

/// Of a code 0..kCodes - 1, nm. Four codes on it is twice as much, exactly.
constexpr int thickness_of(int code) {
  constexpr std::array<int, 4> kQuarters{2000, 2378, 2828, 3364};
  return code == 0 ? 0 : kQuarters[static_cast<std::size_t>((code - 1) % 4)] << (code - 1) / 4;
}
/// The thickest code that is not thicker than `nm`.
int code_within(std::int64_t nm);

/// A layer of one pigment.
struct Stratum {
  int code = 0;
  int pigment = 0;  ///< 0..kPigments - 1; 0 where the code is.
  friend bool operator==(const Stratum&, const Stratum&) = default;
};

/// The slip on a cell: three strata in one word, 0 the top. A stratum has something only where the
/// one above it has. Six bits hold every code, so that three strata with pigments are 30 bits.
class Strata {
 public:
  Strata() = default;
  explicit Strata(std::uint32_t word) : word_(word) {}

  friend bool operator==(const Strata&, const Strata&) = default;
  std::uint32_t word() const { return word_; }
  Stratum at(int k) const {
    const std::uint32_t bits = word_ >> (10 * k);
    return {static_cast<int>(bits & 63u), static_cast<int>(bits >> 6 & 15u)};
  }
  void set(int k, Stratum stratum) {
    const auto code = static_cast<std::uint32_t>(stratum.code);
    const auto pigment = static_cast<std::uint32_t>(stratum.code == 0 ? 0 : stratum.pigment);
    word_ = (word_ & ~(1023u << (10 * k))) | (code | pigment << 6) << (10 * k);
  }
  /// Of all three, nm.
  int thickness() const {
    int sum = 0;
    for (int k = 0; k < kStrata; ++k) sum += thickness_of(at(k).code);
    return sum;
  }
  /// Moves all down by one, and leaves the top empty. The lowest is empty.
  void push() { word_ = word_ << 10 & 0x3fffffffu; }
  /// Takes the top away.
  void pop() { word_ >>= 10; }

 private:
  std::uint32_t word_ = 0;
};

}  // namespace onggi::surface
