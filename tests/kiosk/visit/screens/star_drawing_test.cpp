#include "kiosk/visit/screens/star_drawing.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::star_drawing_test {
namespace {

/// The stars of a frame from the left: how many outlines each has. A star has ten corners and the
/// first again.
std::vector<int> stars_in(const view::Frame& frame) {
  std::map<int, int> by_middle;
  for (const view::Item& item : frame.items)
    if (const auto* line = std::get_if<view::Line>(&item))
      if (line->points.size() == 11) ++by_middle[static_cast<int>(line->points[0].first + 0.5f)];
  std::vector<int> outlines;
  for (const auto& [x, count] : by_middle) outlines.push_back(count);
  return outlines;
}

TEST(Stars, AreFiveAndTheEarnedOnesAreFilledAndNoDotStandsForOne) {
  Visitor v;
  v.make_result();
  v.frames(1);
  const auto stars = stars_in(v.frame);
  ASSERT_EQ(stars.size(), 5u);
  int full = 0;
  for (const int outlines : stars) full += outlines > 1 ? 1 : 0;
  EXPECT_EQ(full, v.visit->score().stars);
  for (const view::Item& item : v.frame.items)
    if (const auto* box = std::get_if<view::Box>(&item)) {
      EXPECT_FALSE(box->radius > 0 && box->rect.w == 2 * box->radius);
    }
}

TEST(Stars, StandInTheGalleryUnderEachPot) {
  Visitor v;
  v.keep_today(3);
  v.show();
  v.touch("attract.gallery");
  v.frames(1);
  int full = 0;
  const auto stars = stars_in(v.frame);
  EXPECT_EQ(stars.size(), 15u);
  for (const int outlines : stars) full += outlines > 1 ? 1 : 0;
  EXPECT_EQ(full, 0 + 1 + 2);
}

}  // namespace
}  // namespace onggi::screens::star_drawing_test
