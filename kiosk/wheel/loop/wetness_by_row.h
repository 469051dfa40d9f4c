#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <vector>

#include "engine/scene/scene.h"

namespace onggi::loop {

/// Passes the wetness of the clay at even heights from the loop thread to the main thread. Only a
/// pot whose rows have their own wetness has one. Neither side waits: every height is an
/// independent number.
class WetnessByRow {
 public:
  static constexpr int kHeights = 64;  ///< From foot to rim, each in the middle of its share.

  /// Loop thread, once a tick: updates one height, in turn. No allocation.
  void publish(const Scene& scene) noexcept {
    const Clay& clay = scene.clay();
    const double height = clay.rim_height() * (next_ + 0.5) / kHeights;
    const int row = std::min(clay.first_row_above(height), clay.rows() - 1);
    wet_[static_cast<std::size_t>(next_)].store(static_cast<float>(scene.wetness_of(row)),
                                                std::memory_order_relaxed);
    next_ = (next_ + 1) % kHeights;
  }
  /// Main thread: 0 dry .. 1 dripping. Allocates the first time.
  void copy_to(std::vector<float>& wet) const {
    wet.resize(wet_.size());
    for (std::size_t i = 0; i < wet_.size(); ++i) wet[i] = wet_[i].load(std::memory_order_relaxed);
  }

 private:
  std::array<std::atomic<float>, kHeights> wet_{};
  int next_ = 0;
};

}  // namespace onggi::loop
