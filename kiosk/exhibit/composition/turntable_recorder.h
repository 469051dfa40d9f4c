#pragma once

#include <cstdint>
#include <optional>

#include "engine/clay/clay_view.h"
#include "kiosk/keepsake/souvenir/keepsake.h"
#include "kiosk/keepsake/souvenir/turning.h"
#include "kiosk/picture/render/renderer.h"

namespace onggi::exhibit {

/// Draws a kept pot from all sides, one picture a frame of the kiosk, so that no frame takes long
/// while the visitor looks at the postcard. The pot turns like its wheel, in front of the studio's
/// plaster, and the last picture leads into the first. It stops silently when a new pot is started.
/// Main thread.
class TurntableRecorder {
 public:
  static constexpr int kPictures = 40;
  static constexpr double kTurn = 4.0;  ///< s
  static constexpr int kSide = 400;     ///< Pixels.

  /// Starts again with the pot of `made`, whose clay is `clay`; `ticket` is its save's.
  /// `left_handed`: the wheel turned the other way.
  void begin(int ticket, const encoding::Caption& caption, const Profile& made,
             const std::optional<view::Glazing>& glazing, const ClayView& clay, bool left_handed);
  /// Draws one more picture; after the last one returns all of them, once.
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
  double step_ = 0;         ///< Between two pictures, rad.
};

}  // namespace onggi::exhibit
