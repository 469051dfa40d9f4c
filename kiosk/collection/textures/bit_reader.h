#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace onggi::textures {

/// Reads bits from the front, lowest bit of a byte first. Beyond the end it returns zeros, and
/// past() is true.
class BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint32_t bit() {
    const std::size_t byte = at_ >> 3;
    const std::uint32_t out = byte < bytes_.size() ? bytes_[byte] >> (at_ & 7) & 1u : 0u;
    ++at_;
    return out;
  }
  /// Reads `count` bits, at most 32.
  std::uint32_t bits(int count) {
    std::uint32_t out = 0;
    for (int i = 0; i < count; ++i) out |= bit() << i;
    return out;
  }
  void skip(std::size_t count) { at_ += count; }
  bool past() const { return at_ > 8 * bytes_.size(); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

}  // namespace onggi::textures
