#pragma once

#include <deque>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include "kiosk/exhibit/composition/arrivals.h"
#include "kiosk/exhibit/composition/card_picture.h"
#include "kiosk/exhibit/composition/scenes.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::exhibit {

/// The shelf, during and after loading: a worker reads vessels, which appear as they come. The main
/// thread draws one picture at a time, so that the first pot turns before the last vessel is read.
class Shelf {
 public:
  /// Starts reading `path` (a shelf folder, a pack, or a single GLB/glTF) on a worker.
  /// `scenes` and `exhibit`, whose limits and translations hold, outlive it.
  Shelf(const std::filesystem::path& path, const Scenes& scenes, const settings::Exhibit& exhibit);
  ~Shelf();

  Arrivals::Progress progress() const { return arrivals_.progress(); }

  /// Moves loaded vessels to the end of cards(), which only grows, and logs what did not load. Call
  /// once a frame; `now` in seconds. Returns true when a vessel is ready or loading has finished.
  bool look(double now);
  /// True if loading has finished; problems() is then complete.
  bool complete() const { return complete_; }
  /// Waits until complete().
  void wait();
  const std::vector<screens::ShelfCard>& cards() const { return cards_; }
  const std::vector<Problem>& problems() const { return problems_; }

  /// Prepares the next missing picture, or draws the prepared one; false if none is missing.
  bool draw_next_picture(render::Renderer& renderer);

 private:
  void take(double now);

  const Scenes& scenes_;
  const settings::Exhibit& exhibit_;
  Arrivals arrivals_;
  std::future<void> reading_;
  std::deque<content::Vessel> vessels_;  // not movable: cards point at them
  std::vector<Problem> problems_;
  std::vector<screens::ShelfCard> cards_;
  CardPicture picture_;
  bool complete_ = false;
};

}  // namespace onggi::exhibit
