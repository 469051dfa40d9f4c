#pragma once

#include "kiosk/settings/exhibit.h"
#include "kiosk/view/rect.h"

namespace onggi::screens {

/// Sizes of one screen, in pixels.
struct TypeScale {
  float body = 25;     ///< em of running text.
  float lead = 33;     ///< body x 1.333
  float title = 44;    ///< x 1.333^2
  float display = 59;  ///< x 1.333^3
  float target = 37;   ///< Least side of anything that can be touched.
  float gap = 12;      ///< Between things that belong together: half of body.
  float margin = 43;   ///< Round the page: 6 % of the short side.
  float hairline = 1;
};

/// The steps of view::TypeScale (capitals of 0.7 degrees at the exhibit's viewing distance), but
/// body text is never larger than 1/28 of the short side, so that a far or small screen still holds
/// a sentence. `shrink` (0..1] is for a page whose words would not fit otherwise; margins and
/// touch targets (15 mm, never under 28 px) keep their size.
TypeScale type_scale(const settings::Exhibit::Screen& screen, int width, int height,
                     float shrink = 1.0f);

/// Where words and pot go. Landscape: words in one column, the pot's axis on the far third.
/// Portrait: the pot above on the centre line, words below. Mirrored: the column on the right.
struct Regions {
  view::Rect words, pot;
  view::Rect page;  ///< All inside the margins.
  bool portrait = false;
  bool mirrored = false;
};
Regions regions(int width, int height, float margin, bool mirrored);

}  // namespace onggi::screens
