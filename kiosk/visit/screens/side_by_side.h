#pragma once

#include <span>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"
#include "kiosk/visit/screens/turntable.h"

namespace onggi::screens {

/// The vessel and the visitor's pot on one ground, at one scale and in one light, turning together:
/// once by themselves, unless motion is reduced, and with `table`. Then they stand, because a
/// picture that stands is drawn in full quality. The section drawing of both is beside
/// them, and their names are below, each with its kind of line.
class SideBySide {
 public:
  /// For `desk`'s card and pot, which must not change meanwhile.
  explicit SideBySide(const Desk& desk);

  void update(const Desk& desk, const Turntable& table, double dt);
  /// Lays out names and drawing beside or above the words, and finds the cameras. `tries`: what
  /// the words ask to try; the drawing has an arrow for each.
  void lay_out(Page& page, const Desk& desk, std::span<const score::Remark> tries);
  /// Draws `pot` in its place, with the vessel beside it.
  view::PotView view(view::PotView pot, const Desk& desk, const Turntable& table) const;
  /// The area of both, and the finger's way for half a turn there, pixels.
  const view::Rect& room() const { return room_; }
  float half_turn() const { return half_turn_; }

 private:
  /// The areas of both pictures and the drawing, and its scale, pixels a metre.
  struct Places {
    view::Rect vessel, pot, section;
    float names = 0;  ///< Top of the names.
    double scale = 0;
  };
  Places places(const Page& page, const Desk& desk) const;
  float names_height(const Page& page, const Desk& desk, float width) const;
  void name(Page& page, const view::Rect& over, float top, const std::string& words,
            bool pots) const;

  double height_ = 0.2, radius_ = 0.1;  ///< Of the larger of the two, including handles, m.
  double turned_ = 0, angle_ = 0;       ///< By themselves so far, 0 to 2 pi, and as an angle, rad.
  view::Rect room_;
  float half_turn_ = 400;
  view::Camera vessel_at_, pot_at_;
};

}  // namespace onggi::screens
