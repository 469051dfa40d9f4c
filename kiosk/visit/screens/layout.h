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
  float target = 37;   ///< Least side of anything that can be touched.
  float gap = 12;      ///< Between things that belong together: half of body.
  float margin = 43;   ///< Round the page: 6 % of the short side.
  float hairline = 1;
};

/// What of a screen of `width` x `height` pixels everything is set on, in pixels: all of it, or
/// with Exhibit::Screen::low_reach what lies between 380 and 1,220 mm above the floor, as the
/// screen is stated to be large and to hang.
view::Rect in_reach(const settings::Exhibit::Screen& screen, int width, int height);

/// What gives way on a page whose words would not fit as they should stand.
struct GiveWay {
  float titles = 0;    ///< 0..1: titles come nearer to body text, and things to each other.
  bool roomy = false;  ///< Words take of the pot's room.
  float above = 0;     ///< 0..1: what is only read stands in what is free above a visitor's reach.
  float body = 1;      ///< And only then what is read is set smaller: of its size.
};
/// Step by step, 0 nothing. `low`: the visitor reaches a part of the screen only.
inline constexpr int kLastGiveWay = 20;
GiveWay give_way(int step, bool low);

/// The steps of view::TypeScale (capitals of 0.7 degrees at the exhibit's viewing distance), but
/// body text is never larger than 1/28 of the short side of the screen, so that a far or small
/// screen still holds a sentence; larger text is body text by 1.3. Whatever gives way,
/// margins and touch targets (15 mm, never under 28 px) keep their size.
TypeScale type_scale(const settings::Exhibit::Screen& screen, int width, int height,
                     const GiveWay& gives = {});

/// Where words and pot go. Landscape: words in one column, the pot's axis on the far third.
/// Portrait (whatever is higher than 0.8 of its width): the pot above on the centre line, words
/// below. Mirrored: the column on the right. Roomy: words take of the pot's room, as larger text
/// does.
struct Regions {
  view::Rect words, pot;
  view::Rect page;  ///< All inside the margins.
  view::Rect all;   ///< And with them.
  float reach = 0;  ///< Nothing that is touched stands above this row.
  bool portrait = false;
  bool mirrored = false;
  bool roomy = false;
};
Regions regions(const view::Rect& all, float margin, bool mirrored, bool roomy = false);

/// What is only read goes up by `share` of what is free above `r.all`. In portrait the pot does,
/// and leaves words its room; its lower part stays in reach, for who turns it.
void read_above(Regions& r, float margin, float share);

}  // namespace onggi::screens
