#pragma once

#include <atomic>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include "kiosk/content/catalogue.h"
#include "kiosk/exhibit/scenes.h"
#include "kiosk/render/renderer.h"
#include "kiosk/screens/visit.h"

namespace onggi::exhibit {

/// The shelf while it is being opened and after: vessels read on a worker, their pictures drawn on
/// the main thread a few at a time, so that the first pot turns before the last picture is made.
class Shelf {
 public:
  /// Starts reading `path` (a shelf folder, a pack, or a single GLB/glTF) on a worker.
  /// `scenes` outlives it.
  Shelf(const std::filesystem::path& path, const Scenes& scenes,
        const settings::ReaderLimits& limits = {});
  ~Shelf();

  struct Progress {
    int done = 0, total = 0;
  };
  Progress progress() const { return {done_.load(), total_.load()}; }

  /// True once the vessels are there; logs what did not load, once, and fills cards().
  bool ready();
  /// Waits for ready().
  void wait();
  const std::vector<screens::ShelfCard>& cards() const { return cards_; }
  const std::vector<Problem>& problems() const { return catalogue_.problems; }

  /// Draws the next missing picture; false when none is missing.
  bool draw_next_picture(render::Renderer& renderer);

 private:
  void fill_cards();

  const Scenes& scenes_;
  std::atomic<int> done_{0}, total_{0};
  std::future<content::Catalogue> reading_;
  content::Catalogue catalogue_;
  std::vector<screens::ShelfCard> cards_;
};

}  // namespace onggi::exhibit
