#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kiosk/picture/view/frame.h"

namespace onggi::screens {

/// A pot that a visitor kept today, without anything about the visitor.
struct TodaysPot {
  view::PictureId picture = 0;
  std::string vessel;   ///< Id of its vessel, which may have left the shelf.
  int stars = 0;        ///< Of 5.
  std::string visit{};  ///< Its keepsake's folder.
};

/// As many are known, the newest. A picture takes 0.4 MB.
inline constexpr std::size_t kMostTodays = 120;

/// Which one of today's pots of its vessel the one in the folder `visit` is, counted from 1; 0 if
/// it is not among them, or if `todays` may lack older ones.
int number_today(const std::vector<TodaysPot>& todays, const std::string& visit);

}  // namespace onggi::screens
