#pragma once

#include <string>

#include "kiosk/picture/view/frame.h"

namespace onggi::screens {

/// A pot that a visitor has kept today. Nothing of who it was.
struct TodaysPot {
  view::PictureId picture = 0;
  std::string vessel;  ///< The id of the vessel that it answers; that may have left the shelf.
  int stars = 0;       ///< Of 5.
};

}  // namespace onggi::screens
