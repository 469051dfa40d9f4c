#pragma once

#include <array>
#include <atomic>
#include <cstddef>

#include "engine/scene/coil_view.h"

namespace onggi::loop {

/// Passes the coil that lies on the rim from the loop thread to the main thread. Only a pot that is
/// built of coils has one. Neither side waits: every place is an independent number.
class CoilByAngle {
 public:
  static constexpr int kPlaces = 128;
  static constexpr int kEachTick = 8;

  /// Loop thread, once a tick: updates the next places, in turn. No allocation.
  void publish(const CoilView& coil) noexcept {
    // A ring becomes clay at once, and the rim rises: nothing may stay that lay lower.
    if (coil.centre.empty()) {
      if (!lies_) return;
      for (auto& centre : centre_) centre.store(0.0f, std::memory_order_relaxed);
      lies_ = false;
      next_ = 0;
      return;
    }
    if (next_ == 0) height_.store(coil.height, std::memory_order_relaxed);
    for (int n = 0; n < kEachTick; ++n, next_ = (next_ + 1) % kPlaces)
      centre_[static_cast<std::size_t>(next_)].store(at(coil, next_), std::memory_order_relaxed);
    lies_ = true;
  }
  /// Main thread. Allocates the first time.
  void copy_to(CoilOnRim& coil) const {
    coil.height = height_.load(std::memory_order_relaxed);
    coil.centre.resize(centre_.size());
    bool lies = false;
    for (std::size_t n = 0; n < centre_.size(); ++n) {
      coil.centre[n] = centre_[n].load(std::memory_order_relaxed);
      lies = lies || coil.centre[n] != 0.0f;
    }
    if (!lies) coil.centre.clear();
  }

 private:
  /// Of the sector in the middle of that share of a turn.
  static float at(const CoilView& coil, int place) noexcept {
    const std::size_t n = coil.centre.size();
    return n == 0 ? 0.0f
                  : coil.centre[(2 * static_cast<std::size_t>(place) + 1) * n / (2 * kPlaces)];
  }

  std::array<std::atomic<float>, kPlaces> centre_{};
  std::atomic<double> height_{0.0};
  int next_ = 0;  // loop thread's, too:
  bool lies_ = false;
};

}  // namespace onggi::loop
