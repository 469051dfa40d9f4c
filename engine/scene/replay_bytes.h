#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace onggi::replay_bytes {

inline constexpr std::uint64_t kMagic = 0x59414c5049474e4fULL;  // "ONGIPLAY", little-endian
/// Version of the format and of the clay's laws: a change of either raises it.
inline constexpr std::uint32_t kVersion = 19;
inline constexpr std::uint32_t kLaws = 18;  ///< The first version with today's laws of the clay,
/// and of coils. It has swings, too: before, a paddle struck fully, and an anvil as hard or not.
inline constexpr std::uint32_t kFirstSwings = 19;
/// The first version that has columns. Before, the fields that changed stood behind each tick.
inline constexpr std::uint32_t kFirstColumns = 16;
/// Oldest version that can be read (replay_scene.h).
inline constexpr std::uint32_t kOldestVersion = 11;

/// A tick is a byte of flags for the fields that changed (0: none). Versions before kFirstColumns
/// had marks between the ticks.
enum Tag : std::uint8_t {
  kHand0 = 1u << 0,     // three doubles
  kHand1 = 1u << 1,     // three doubles
  kSwitches = 1u << 2,  // two bytes: see switches_of()
  kWheel = 1u << 3,     // a double
  kTime = 1u << 4,      // a double
  kHold0 = 1u << 5,     // a byte and four doubles: tool, handle and roll
  kHold1 = 1u << 6,     // likewise
  kSwings = 1u << 7,    // four doubles: swing and anvil of each hand; from kFirstSwings
  kFieldsBefore = kHand0 | kHand1 | kSwitches | kWheel | kTime | kHold0 | kHold1,
  kAllFields = kFieldsBefore | kSwings,
  // Marks before kFirstColumns:
  kNote = 0x80,   // a hash of the state here
  kGlaze = 0x82,  // the glaze's id: its size and its letters
  kEnd = 0x81,    // the last hash, then the checksum of everything before
};

inline constexpr std::size_t kSealBytes = 8;

void seal(std::vector<std::byte>& bytes);
/// `bytes` without their checksum; empty if the checksum is wrong.
std::span<const std::byte> unsealed(std::span<const std::byte> bytes);

/// Appends little-endian values.
class Writer {
 public:
  explicit Writer(std::vector<std::byte>& out) : out_(out) {}
  bool operator()(std::uint64_t& v) { return whole(v, 8); }
  bool operator()(std::uint32_t& v) { return whole(v, 4); }
  bool operator()(std::uint16_t& v) { return whole(v, 2); }
  bool operator()(std::uint8_t& v) { return whole(v, 1); }
  bool operator()(int& v) { return whole(static_cast<std::uint32_t>(v), 4); }
  bool operator()(bool& v) { return whole(v ? 1 : 0, 1); }
  bool operator()(double& v) { return whole(std::bit_cast<std::uint64_t>(v), 8); }
  bool text(const std::string& v, std::size_t most) {
    const std::size_t size = std::min(v.size(), most);
    whole(size, 4);
    for (std::size_t n = 0; n < size; ++n) out_.push_back(static_cast<std::byte>(v[n]));
    return true;
  }

  /// `size` zero bytes at the end, to be filled in; valid until the next value.
  std::span<std::byte> room(std::size_t size) {
    out_.resize(out_.size() + size);
    return std::span(out_).last(size);
  }

 private:
  bool whole(std::uint64_t v, int bytes) {
    for (int n = 0; n < bytes; ++n) out_.push_back(static_cast<std::byte>(v >> (8 * n)));
    return true;
  }
  std::vector<std::byte>& out_;
};

/// Reads values back. If the bytes end or are invalid, returns false and leaves the value
/// unchanged.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> in) : in_(in) {}
  bool operator()(std::uint64_t& v) { return whole(v, 8); }
  bool operator()(std::uint32_t& v) { return whole(v, 4); }
  bool operator()(std::uint16_t& v) { return whole(v, 2); }
  bool operator()(std::uint8_t& v) { return whole(v, 1); }
  bool operator()(int& v) {
    std::uint32_t bits = 0;
    if (!whole(bits, 4)) return false;
    v = static_cast<int>(bits);
    return true;
  }
  bool operator()(bool& v) {
    std::uint8_t bit = 0;
    if (!whole(bit, 1) || bit > 1) return false;
    v = bit == 1;
    return true;
  }
  bool operator()(double& v) {
    std::uint64_t bits = 0;
    if (!whole(bits, 8)) return false;
    v = std::bit_cast<double>(bits);
    return true;
  }
  bool text(std::string& v, std::size_t most) {
    std::uint32_t size = 0;
    if (!whole(size, 4) || size > most || size > left()) return false;
    v.assign(reinterpret_cast<const char*>(in_.data() + at_), size);
    at_ += size;
    return true;
  }
  bool bytes(std::span<const std::byte>& v, std::size_t size) {
    if (left() < size) return false;
    v = in_.subspan(at_, size);
    at_ += size;
    return true;
  }
  std::size_t at() const { return at_; }
  std::size_t left() const { return in_.size() - at_; }

 private:
  template <class T>
  bool whole(T& v, std::size_t bytes) {
    if (left() < bytes) return false;
    std::uint64_t sum = 0;
    for (std::size_t n = 0; n < bytes; ++n)
      sum |= std::to_integer<std::uint64_t>(in_[at_ + n]) << (8 * n);
    at_ += bytes;
    v = static_cast<T>(sum);
    return true;
  }
  std::span<const std::byte> in_;
  std::size_t at_ = 0;
};

}  // namespace onggi::replay_bytes
