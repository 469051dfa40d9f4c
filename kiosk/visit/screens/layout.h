#pragma once

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/picture/view/rect.h"

namespace onggi::screens {

/// Sizes of one screen, in pixels.
struct TypeScale {
  float body = 25;     ///< em of running text.
  float lead = 33;     ///< body x 1.333
  float title = 44;    ///< x 1.333^2
  float display = 59;  ///< x 1.333^3
  float target = 37;   ///< Smallest side of a touch target.
  float gap = 12;      ///< Between related things: half of body.
  float margin = 43;   ///< Round the page: 6 % of the short side.
  float hairline = 1;
};

/// The usable part of a screen of `width` x `height` pixels, in pixels. It is all of it, or with
/// Exhibit::Screen::low_reach the part between 380 and 1,220 mm above the floor, computed from the
/// screen's stated size and height.
view::Rect in_reach(const settings::Exhibit::Screen& screen, int width, int height);

/// What a page gives up when its words do not fit.
struct GiveWay {
  float titles = 0;    ///< 0..1: titles shrink towards body text, and gaps shrink.
  bool roomy = false;  ///< Words use some of the pot's space.
  /// 0..1: text that needs no touch moves into the free space above the visitor's reach.
  float above = 0;
  float body = 1;  ///< Only then body text is set smaller: share of its size.
};
/// give_way(step): larger steps give up more; 0 gives up nothing. `low`: the visitor reaches only a
/// part of the screen.
inline constexpr int kLastGiveWay = 20;
GiveWay give_way(int step, bool low);

/// The steps of view::TypeScale (capitals of 0.7 degrees at the exhibit's viewing distance), but
/// body text is at most 1/28 of the short side of the screen, so that a far or small screen still
/// holds a sentence. Larger text is 1.3 times body text. Margins and touch targets (15 mm, never
/// under 28 px) always keep their size.
TypeScale type_scale(const settings::Exhibit::Screen& screen, int width, int height,
                     const GiveWay& gives = {});

/// Places of words and pot. Landscape: words in one column, the pot's axis on the far third.
/// Portrait (higher than 0.8 of its width): the pot above on the centre line, words below.
/// Mirrored: the column is on the right. Roomy: words use some of the pot's space, as with larger
/// text.
struct Regions {
  view::Rect words, pot;
  view::Rect page;  ///< Everything inside the margins.
  view::Rect all;   ///< The page with its margins.
  float reach = 0;  ///< Touch targets stay below this row.
  bool portrait = false;
  bool mirrored = false;
  bool roomy = false;
};
Regions regions(const view::Rect& all, float margin, bool mirrored, bool roomy = false);

/// Moves text that needs no touch up by `share` of the free space above `r.all`. In portrait the
/// pot moves up instead, and the words get its space; its lower part stays in reach, so that
/// visitors can turn it.
void read_above(Regions& r, float margin, float share);

}  // namespace onggi::screens
