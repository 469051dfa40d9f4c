#pragma once

#include <cstdint>

namespace onggi {

/// A small seeded source of numbers (SplitMix64: Steele, Lea and Flood 2014). The same seed gives
/// the same numbers everywhere. No allocation.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  /// 0 <= u < 1, evenly.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  /// low <= u < high, evenly. low < high.
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

 private:
  std::uint64_t state_;
};

}  // namespace onggi
