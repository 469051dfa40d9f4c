#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace onggi::device {

/// Passes the newest value from one thread to another. Neither side ever waits, whatever the
/// priorities: the writer owns one of three slots and the reader another, and they swap the third
/// with an atomic exchange. A value that is not read in time is lost.
template <class T>
class Mailbox {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// Writer's thread.
  void put(const T& value) noexcept {
    places_[mine_] = value;
    mine_ =
        between_.exchange(static_cast<std::uint8_t>(mine_ | kFresh), std::memory_order_acq_rel) &
        kPlace;
  }
  /// Reader's thread. True if `value` is new.
  bool take(T& value) noexcept {
    if ((between_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    yours_ = between_.exchange(yours_, std::memory_order_acq_rel) & kPlace;
    value = places_[yours_];
    return true;
  }

 private:
  static constexpr std::uint8_t kPlace = 3, kFresh = 4;
  std::array<T, 3> places_{};
  std::uint8_t mine_ = 0;   ///< Writer's thread only.
  std::uint8_t yours_ = 1;  ///< Reader's thread only.
  std::atomic<std::uint8_t> between_{2};
};

}  // namespace onggi::device
