#pragma once

#include <readerwriterqueue/readerwriterqueue.h>

#include <atomic>
#include <cstdint>
#include <vector>

#include "engine/scene/scene.h"

namespace onggi::loop {

/// Carries changed clay rows from the loop thread to the main thread through a fixed set of
/// buffers. Neither side waits: with no buffer free a row stays marked in the clay and goes later.
/// One object a scene, made and destroyed on the main thread.
class RowChannel {
 public:
  struct Row {
    int row = 0;
    double middle = 0;          ///< Height of the row's middle, metres.
    double rim = 0, floor = 0;  ///< Of the clay as the row was copied: its height, and its floor's.
    bool torn = false;          ///< Scene::torn().
    std::vector<float> radii;   ///< `sectors` outer, then `sectors` inner, metres.
  };

  /// Allocates up to 512 buffers for a clay of `rows` x `sectors`.
  RowChannel(int rows, int sectors);

  /// Loop thread: when the main thread has asked, copies at most `most` changed rows out.
  void publish(Scene& scene, int most) noexcept;

  /// Main thread: asks for what has changed since the last time.
  void ask() noexcept { asked_.store(true, std::memory_order_release); }
  /// Main thread: the next row, nullptr when none waits. Give it back when read.
  Row* take() noexcept;
  void give_back(Row* row) noexcept;

 private:
  int sectors_;
  int next_ = 0;  ///< Loop thread's.
  std::vector<Row> rows_;
  moodycamel::ReaderWriterQueue<Row*> free_;
  moodycamel::ReaderWriterQueue<Row*> full_;
  std::atomic<bool> asked_{true};
};

}  // namespace onggi::loop
