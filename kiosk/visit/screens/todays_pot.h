#pragma once

#include <string>

#include "kiosk/picture/view/frame.h"

namespace onggi::screens {

/// A pot that a visitor kept today, without anything about the visitor.
struct TodaysPot {
  view::PictureId picture = 0;
  std::string vessel;  ///< Id of its vessel, which may have left the shelf.
  int stars = 0;       ///< Of 5.
};

}  // namespace onggi::screens
