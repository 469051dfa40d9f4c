#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>

#include "kiosk/collection/decoration/starts.h"
#include "kiosk/visit/decorating/example.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// A pot that is decorated, as it is seen: `angle` as in view::PotView::clay_angle.
struct SeenPot {
  const decorating::DecoratedPot& pot;
  view::Camera camera;
  double angle = 0;

  /// The pixel of a place; nothing where the pot hides it.
  std::optional<std::pair<float, float>> pixel(const decorating::Place& at) const;
  /// Where the pot faces the eye, turns round it.
  double front() const;
};

/// A ring round one place; nothing where the pot hides it.
void draw_place(Page& page, const SeenPot& seen, const decorating::Place& at);

/// A height, m along the outline, as a line round the part that faces the eye.
void draw_mark(Page& page, const SeenPot& seen, double along);

/// A translucent hand whose finger leads the tool.
void draw_finger(Page& page, const SeenPot& seen, const decorating::Example::Finger& finger);

/// Faint short strokes where the makers of the vessel began, those that the held tool could make.
/// None in a zone that was touched. True if any is there.
bool draw_starts(Page& page, const SeenPot& seen, std::span<const decoration::Start> starts);

/// What of the page the pot's outside covers, from the lip to the foot.
view::Rect seen_box(const SeenPot& seen);

/// Where such words begin, px: under the foot, or as low as the page lets them.
float word_top(const Page& page, const SeenPot& seen, const std::string& words, float px);
/// Words under the foot, where they cover nothing of a pot that has room under it: `shown` 0..1,
/// letters of `px`.
void draw_word(Page& page, const SeenPot& seen, const std::string& words, float px, float shown);

}  // namespace onggi::screens
