#pragma once

#include <array>
#include <cstdint>

namespace onggi::loop {

/// Counts durations in microseconds: exact to 32 us, then 32 steps an octave (about 3 %), up to
/// over a second. Plain counts, 2.7 kB; the same bits on every machine.
class Histogram {
 public:
  static constexpr int kBins = 32 + 15 * 32 + 1;

  Histogram() = default;
  /// From counts made elsewhere; `most` us.
  Histogram(const std::array<std::uint32_t, kBins>& counts, double most) noexcept;
  void add(double us) noexcept {
    ++counts_[static_cast<std::size_t>(bin_of(us))];
    ++total_;
    if (us > most_) most_ = us;
  }
  std::uint64_t total() const noexcept { return total_; }
  double most() const noexcept { return most_; }  ///< us
  /// The duration, us, that this share (0..1) of all did not exceed: a bin's upper end, at most
  /// most(). 0 if it is empty.
  double quantile(double share) const noexcept;
  const std::array<std::uint32_t, kBins>& counts() const noexcept { return counts_; }
  /// The counts since `earlier`, an older copy of this one. Its most() is a bin's upper end.
  Histogram since(const Histogram& earlier) const noexcept;
  /// Upper end of a bin, us.
  static double upper_end(int bin) noexcept;
  static int bin_of(double us) noexcept;

 private:
  std::array<std::uint32_t, kBins> counts_{};
  std::uint64_t total_ = 0;
  double most_ = 0.0;
};

}  // namespace onggi::loop
