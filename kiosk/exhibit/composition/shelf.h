#pragma once

#include <deque>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include "kiosk/exhibit/composition/arrivals.h"
#include "kiosk/exhibit/composition/scenes.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::exhibit {

/// The shelf while it is being opened and after: vessels read on a worker and shown as they come,
/// their pictures drawn on the main thread one at a time, so that the first pot turns before the
/// last vessel is read.
class Shelf {
 public:
  /// Starts reading `path` (a shelf folder, a pack, or a single GLB/glTF) on a worker.
  /// `scenes` outlives it.
  Shelf(const std::filesystem::path& path, const Scenes& scenes,
        const settings::ReaderLimits& limits = {});
  ~Shelf();

  Arrivals::Progress progress() const { return arrivals_.progress(); }

  /// Takes what has been read into cards(), which only grows, at its end; logs what did not load.
  /// Call once a frame; `now` in seconds. True once there is a vessel, or nothing more to come.
  bool look(double now);
  /// Nothing more will come, and what was wrong is all in problems().
  bool complete() const { return complete_; }
  /// Waits until complete().
  void wait();
  const std::vector<screens::ShelfCard>& cards() const { return cards_; }
  const std::vector<Problem>& problems() const { return problems_; }

  /// Draws the next missing picture; false when none is missing.
  bool draw_next_picture(render::Renderer& renderer);
  /// As large as a card has it.
  static view::PictureId draw_picture(render::Renderer& renderer, const content::Vessel& vessel);

 private:
  void take(double now);

  const Scenes& scenes_;
  Arrivals arrivals_;
  std::future<void> reading_;
  std::deque<content::Vessel> vessels_;  // stay where they are: cards point at them
  std::vector<Problem> problems_;
  std::vector<screens::ShelfCard> cards_;
  bool complete_ = false;
};

}  // namespace onggi::exhibit
