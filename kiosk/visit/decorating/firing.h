#pragma once

#include <cstdint>
#include <optional>

#include "engine/surface/melt.h"
#include "engine/surface/surface.h"
#include "kiosk/collection/decoration/coat_picture.h"

namespace onggi::decorating {

/// What the kiln does to a decorated pot: its slips get their fired colours, its glaze melts, and
/// the picture shows both. Main thread.
class Firing {
 public:
  /// How the pot was decorated, as far as the fire asks.
  struct Pot {
    bool polished = false;  ///< Polish is seen on bare clay only, so the kiln lays no glaze on it.
    bool glazed = false;    ///< Glaze was laid on it.
  };

  /// The glaze of `surface` begins to melt, if it has not begun; one without any has the kiln's.
  /// `surface` outlives this or the next cool(). Allocates some MB.
  void heat(const surface::Surface& surface, const Pot& pot);
  /// Before or after the fire, and whether the kiln glazes a pot on which no glaze was laid.
  void set(bool fired, bool glassy) { fired_ = fired, glassy_ = glassy; }
  bool fired() const { return fired_; }
  /// Goes on by `cells`; true once the melt has ended with this.
  bool go_on(std::int64_t cells);
  void end();
  /// True while what is fired still melts.
  bool melts() const { return fired_ && melt_ && !melt_->done(); }
  /// Tells `picture` to show the pot as it is now.
  void show(decoration::CoatPicture& picture, const Pot& pot) const;
  /// Thickness of the glaze on a cell: raw, or as it has melted; m.
  double glaze_at(const surface::Surface& surface, int j, int i, const Pot& pot) const;
  /// The surface is about to change: what melted is forgotten.
  void cool(decoration::CoatPicture& picture);

 private:
  bool molten(const Pot& pot) const;

  std::optional<surface::Melt> melt_;  ///< Of the surface as it is.
  bool fired_ = false, glassy_ = true;
};

}  // namespace onggi::decorating
