#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace onggi {

/// A 64-bit hash of state, in order; equal bits in, equal hash out, on every machine. Not for
/// secrets. No allocation.
class StateHash {
 public:
  void add(std::uint64_t v) {
    state_ = (state_ ^ v) * 0x9e3779b97f4a7c15ULL;  // 2^64 over the golden ratio, odd
    state_ ^= state_ >> 32;
  }
  void add(double v) { add(std::bit_cast<std::uint64_t>(v)); }
  void add(std::span<const float> values) {
    std::size_t n = 0;
    for (; n + 1 < values.size(); n += 2)
      add(std::uint64_t{std::bit_cast<std::uint32_t>(values[n])} |
          std::uint64_t{std::bit_cast<std::uint32_t>(values[n + 1])} << 32);
    if (n < values.size()) add(std::uint64_t{std::bit_cast<std::uint32_t>(values[n])});
  }
  std::uint64_t value() const {
    StateHash last = *this;
    last.add(std::uint64_t{0x6f6e676769ULL});  // so that the last value is stirred as well
    return last.state_;
  }

 private:
  std::uint64_t state_ = 0x243f6a8885a308d3ULL;  // pi's fraction
};

}  // namespace onggi
