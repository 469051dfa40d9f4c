#pragma once

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"
#include "kiosk/visit/screens/turntable.h"

namespace onggi::screens {

/// The vessel and the pot that answers it on one ground, at one scale and in one light, turning
/// together: by themselves, unless motion is reduced, and as `table` was turned. With them the
/// section drawing of both. Their names stand under them, each with its kind of line.
class SideBySide {
 public:
  /// `desk`'s card and pot, which stay as they are.
  explicit SideBySide(const Desk& desk);

  void update(const Desk& desk, const Turntable& table, double dt);
  /// Lays out names and drawing beside or above the words, and finds the cameras.
  void lay_out(Page& page, const Desk& desk);
  /// `pot` as it stands there, with the vessel beside it.
  view::PotView view(view::PotView pot, const Desk& desk, const Turntable& table) const;
  /// Where both stand, and how far a finger goes there for half a turn, pixels.
  const view::Rect& room() const { return room_; }
  float half_turn() const { return half_turn_; }

 private:
  /// Room for both pictures and the drawing, and how many pixels a metre is there.
  struct Places {
    view::Rect vessel, pot, section;
    float names = 0;  ///< Where these begin, from the top.
    double scale = 0;
  };
  Places places(const Page& page, const Desk& desk) const;
  float names_height(const Page& page, const Desk& desk, float width) const;
  void name(Page& page, const view::Rect& over, float top, const std::string& words,
            bool pots) const;

  double height_ = 0.2, radius_ = 0.1;  ///< Of the larger of both, handles and all, m.
  double angle_ = 0;                    ///< By which both have turned by themselves, rad.
  view::Rect room_;
  float half_turn_ = 400;
  view::Camera vessel_at_, pot_at_;
};

}  // namespace onggi::screens
