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
/// buffers. Neither side waits: without a free buffer a row stays marked in the clay and is sent
/// later. One object a scene, made and destroyed on the main thread.
class RowChannel {
 public:
  struct Row {
    int row = 0;
    clay::RowPlace place;
    bool shaped = false;       ///< It carries radii; otherwise they are unchanged.
    std::vector<float> radii;  ///< `sectors` outer, then `sectors` inner, metres.
  };

  /// Allocates up to 512 buffers for a clay of `rows` x `sectors`.
  RowChannel(int rows, int sectors);

  /// Loop thread: if the main thread has asked, copies at most `most` changed rows.
  void publish(Scene& scene, int most) noexcept;

  /// Main thread: asks for the changes since the last time.
  void ask() noexcept { asked_.store(true, std::memory_order_release); }
  /// Main thread: writes the waiting rows into `view` and returns their number, at most one for
  /// each buffer, however many come meanwhile. No allocation.
  int take_into(ClayView& view) noexcept;

 private:
  std::size_t sectors_;
  int next_ = 0;  ///< Loop thread only.
  std::vector<Row> rows_;
  moodycamel::ReaderWriterQueue<Row*> free_;
  moodycamel::ReaderWriterQueue<Row*> full_;
  std::atomic<bool> asked_{true};
};

/// Writes the rows that `scene` still has to send into `view`. The caller must hold the scene
/// alone.
void take_rest_into(ClayView& view, Scene& scene) noexcept;

}  // namespace onggi::loop
