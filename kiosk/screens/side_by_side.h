#pragma once

#include <optional>

#include "kiosk/screens/desk.h"
#include "kiosk/screens/page.h"
#include "kiosk/view/input.h"

namespace onggi::screens {

/// The vessel and the pot that answers it on one ground, at one scale and in one light, turning
/// together: by themselves, unless motion is reduced, and by a finger. With them the section
/// drawing of both. Their names stand under them, each with its kind of line.
class SideBySide {
 public:
  /// `desk`'s card and pot, which stay as they are.
  explicit SideBySide(const Desk& desk);

  void update(const Desk& desk, double dt);
  /// A finger or a mouse that is on no control turns both.
  void pointer(const view::InputEvent& event);
  /// Lays out names and drawing beside or above the words, and finds the cameras.
  void lay_out(Page& page, const Desk& desk);
  /// `pot` as it stands there, with the vessel beside it.
  view::PotView view(view::PotView pot, const Desk& desk) const;

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
  double angle_ = 0;                    ///< By which both are turned, rad.
  std::optional<float> dragged_;        ///< Where the finger was, pixels.
  float turn_ = 400;                    ///< Pixels that a finger goes for a radian, times pi.
  view::Camera vessel_at_, pot_at_;
};

}  // namespace onggi::screens
