#pragma once

#include <cstdint>
#include <optional>

#include "engine/clay/clay_view.h"
#include "kiosk/keepsake/souvenir/keepsake.h"
#include "kiosk/keepsake/souvenir/turning.h"
#include "kiosk/picture/render/renderer.h"

namespace onggi::exhibit {

/// Draws a pot that was kept from all round, a picture a frame of the kiosk's, so that no frame
/// takes long while its visitor looks at the postcard. The pot turns the way that its wheel did,
/// before the studio's plaster, and the last picture leads into the first. Nobody waits for it: it
/// ends without a word when the clay on the wheel becomes another. Main thread.
class TurningPot {
 public:
  static constexpr int kPictures = 40;
  static constexpr double kTurn = 4.0;  ///< s
  static constexpr int kSide = 400;     ///< Pixels.

  /// Begins anew, with the pot of `made` as `clay` has it; `ticket` is its save's. `left_handed`:
  /// so is its visitor, whose wheel turned the other way.
  void begin(int ticket, const encoding::Caption& caption, const Profile& made,
             const std::optional<view::Glazing>& glazing, const ClayView& clay, bool left_handed);
  /// One more picture of it; after the last one all of them, once.
  struct Drawn {
    int ticket = 0;
    encoding::Caption caption;
    encoding::Turning turning;
  };
  std::optional<Drawn> draw(const ClayView& clay, render::Renderer& renderer);
  bool drawing() const { return drawn_.ticket != 0; }
  void stop() { drawn_ = {}; }

 private:
  Drawn drawn_;
  view::Frame frame_;
  std::uint64_t clay_ = 0;  ///< ClayView::change() of the pot.
  double step_ = 0;         ///< From one picture to the next, rad.
};

}  // namespace onggi::exhibit
