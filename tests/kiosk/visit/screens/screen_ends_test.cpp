#include <gtest/gtest.h>

#include <cmath>

#include "kiosk/visit/screens/comfort.h"
#include "tests/kiosk/visit/screens/visitor.h"

// What onggi check accepts in [screen], at the ends of its ranges: no visit stops there. Whether
// such a page is easy to read is not asked here.

namespace onggi::screens::screen_ends_test {
namespace {

bool finite(const view::Rect& r) {
  return std::isfinite(r.x) && std::isfinite(r.y) && std::isfinite(r.w) && std::isfinite(r.h);
}

void check_frame(const Visitor& v, const std::string& where) {
  for (const view::Item& item : v.frame.items) {
    if (const auto* text = std::get_if<view::Text>(&item)) {
      EXPECT_TRUE(finite(text->box) && text->style.px > 0) << where << ": " << text->text;
    } else if (const auto* box = std::get_if<view::Box>(&item)) {
      EXPECT_TRUE(finite(box->rect)) << where;
    } else if (const auto* picture = std::get_if<view::Picture>(&item)) {
      EXPECT_TRUE(finite(picture->box)) << where;
    }
  }
  for (const auto& [id, rect] : v.visit->controls())
    EXPECT_TRUE(finite(rect) && rect.w > 0 && rect.h > 0) << where << ": " << id;
  if (v.frame.pot)
    if (const auto at = v.frame.pot->camera.project({0, 0.1, 0})) {
      EXPECT_TRUE(std::isfinite(at->first) && std::isfinite(at->second)) << where;
    }
}

TEST(ScreenEnds, AVisitGoesThroughAtTheEndsOfEveryRangeOfTheScreenOneByOneAndTogether) {
  struct End {
    double settings::Exhibit::Screen::*value;
    double least, most;
  };
  using Screen = settings::Exhibit::Screen;
  constexpr End kEnds[] = {{&Screen::viewing_distance_mm, 200, 5000},
                           {&Screen::diagonal_mm, 100, 5000},
                           {&Screen::lower_edge_mm, 0, 1000},
                           {&Screen::scan_seconds, 0.5, 5},
                           {&Screen::force, 0, 1}};
  // Bit n of `which`: the most of end n, else its least.
  for (unsigned which = 0; which < 8; ++which)
    for (const bool all : {false, true})
      for (const auto& [width, height] : {std::pair(1280, 720), {1080, 1920}}) {
        Visitor v(3, nullptr, true);
        v.width = width;
        v.height = height;
        for (std::size_t n = 0; n < std::size(kEnds); ++n)
          v.exhibit.screen.*kEnds[n].value =
              (which >> (n % 3) & 1) != 0 ? kEnds[n].most : kEnds[n].least;
        for (const Comfort::Choice& choice : Comfort::kChoices) v.exhibit.screen.*choice.of = all;
        const std::string where = "ends " + std::to_string(which) + (all ? " with all" : "") +
                                  " at " + std::to_string(width);
        v.put_tools_to_hand();
        v.keep_today(30);
        v.show();
        check_frame(v, where);
        v.touch("attract.begin");
        v.frames(1);
        check_frame(v, where + ", the shelf");
        for (const char* next : {"choose.card.0", "choose.throw", "throw.done"}) {
          if (!v.visit->control(next)) break;
          v.touch(next);
          v.frames(1);
          check_frame(v, where + ", after " + next);
        }
        EXPECT_LE(v.most_measured, Measuring::kMostBytes + 4096) << where;
      }
}

}  // namespace
}  // namespace onggi::screens::screen_ends_test
