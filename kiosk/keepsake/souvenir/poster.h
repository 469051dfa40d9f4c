#pragma once

#include <string>

#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/measure.h"

namespace onggi::souvenir {

/// The content of a poster for the museum's wall; words are already in its language.
struct PosterWords {
  std::string title;          ///< The exhibit's.
  std::string lead;           ///< What visitors do there.
  std::string vessel;         ///< The pictured vessel: title, culture, date.
  std::string credit;         ///< Whose vessel and picture it is; may be empty.
  std::string museum;         ///< The museum's name.
  std::string address;        ///< A web page, as a QR code; empty: none.
  std::string address_words;  ///< Words below the code.
  std::string language = "en";
  bool right_to_left = false;  ///< Words begin at the right, and the code stands at the left.
};

/// A4 upright at 300 dots an inch.
inline constexpr int kPosterWidth = 2480, kPosterHeight = 3508;
/// The pot's picture, pixels; its whole width.
inline constexpr int kPosterPotWidth = 2480, kPosterPotHeight = 2000;

/// Composes the poster from top to bottom: title, the picture `pot`, what visitors do, and at the
/// foot the small print and the code.
view::Frame compose_poster(const PosterWords& words, view::PictureId pot,
                           const view::TextMeasure& measure);

}  // namespace onggi::souvenir
