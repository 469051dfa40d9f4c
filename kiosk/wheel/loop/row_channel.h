#pragma once

#include <readerwriterqueue/readerwriterqueue.h>

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/clay/clay_view.h"
#include "engine/scene/scene.h"

namespace onggi::loop {

/// Carries changed clay rows from the loop thread to the main thread through a fixed set of
/// buffers. Neither side waits: with no buffer free a row stays marked in the clay and goes later.
/// One object a scene, made and destroyed on the main thread.
class RowChannel {
 public:
  struct Row {
    int row = 0;
    clay::RowPlace place;
    bool shaped = false;       ///< Its radii came along; else they are what they were.
    std::vector<float> radii;  ///< `sectors` outer, then `sectors` inner, metres.
  };

  /// Allocates up to 512 buffers for a clay of `rows` x `sectors`.
  RowChannel(int rows, int sectors);

  /// Loop thread: when the main thread has asked, copies at most `most` changed rows out.
  void publish(Scene& scene, int most) noexcept;

  /// Main thread: asks for what has changed since the last time.
  void ask() noexcept { asked_.store(true, std::memory_order_release); }
  /// Main thread: writes the rows that wait into `view`; gives how many. No allocation.
  int take_into(ClayView& view) noexcept;

 private:
  std::size_t sectors_;
  int next_ = 0;  ///< Loop thread's.
  std::vector<Row> rows_;
  moodycamel::ReaderWriterQueue<Row*> free_;
  moodycamel::ReaderWriterQueue<Row*> full_;
  std::atomic<bool> asked_{true};
};

/// Writes what `scene` has still to send into `view`. Whoever calls holds the scene alone.
void take_rest_into(ClayView& view, Scene& scene) noexcept;

}  // namespace onggi::loop
