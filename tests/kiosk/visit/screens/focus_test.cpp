#include "kiosk/visit/screens/focus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::focus_test {
namespace {

// Two rows, as beside the pot: what is far in the row lies beside what is near above it.
const std::vector<Control> kRows = {{"water", {136, 548, 88, 35}},
                                    {"lump", {334, 548, 133, 35}},
                                    {"done", {43, 594, 80, 35}},
                                    {"show", {210, 594, 110, 35}}};

TEST(Focus, LeftAndRightKeepToTheRow) {
  EXPECT_EQ(step_focus(kRows, "show", Direction::left), "done");
  EXPECT_EQ(step_focus(kRows, "done", Direction::right), "show");
  EXPECT_EQ(step_focus(kRows, "water", Direction::right), "lump");
}

TEST(Focus, UpAndDownChangeIt) {
  EXPECT_EQ(step_focus(kRows, "show", Direction::up), "water");
  EXPECT_EQ(step_focus(kRows, "water", Direction::down), "show");
}

/// Focus on a glaze; a narrow button stands below it, and links further down.
TEST(Focus, DownGoesToWhatIsStraightBelow) {
  const std::vector<Control> kiln = {
      {"glaze", {300, 400, 160, 50}}, {"keep", {100, 470, 210, 50}}, {"back", {330, 560, 70, 30}}};
  EXPECT_EQ(step_focus(kiln, "glaze", Direction::down), "keep");
  EXPECT_EQ(step_focus(kiln, "back", Direction::up), "keep");
  // What stands beside is not below, however tall.
  const std::vector<Control> beside = {
      {"done", {40, 400, 200, 50}}, {"links", {40, 700, 200, 30}}, {"pot", {260, 100, 900, 900}}};
  EXPECT_EQ(step_focus(beside, "done", Direction::down), "links");
  EXPECT_EQ(step_focus(beside, "done", Direction::right), "pot");
}

/// How far `c` lies beyond `from` that way, edge to edge, where they overlap across it.
std::optional<float> straight(const view::Rect& from, const view::Rect& c, Direction to) {
  const bool upright = to == Direction::up || to == Direction::down;
  const bool over = upright ? c.x < from.x + from.w && from.x < c.x + c.w
                            : c.y < from.y + from.h && from.y < c.y + c.h;
  const float beyond = to == Direction::down    ? c.y - from.y - from.h
                       : to == Direction::up    ? from.y - c.y - c.h
                       : to == Direction::right ? c.x - from.x - from.w
                                                : from.x - c.x - c.w;
  return over && beyond >= 0 ? std::optional(beyond) : std::nullopt;
}

TEST(Focus, NoArrowSkipsAControlThatLiesStraightInBetween) {
  for (const auto& [w, h] : {std::pair(1920, 1080), {1080, 1920}, {1366, 768}}) {
    Visitor v(12, nullptr, true);
    v.width = w, v.height = h;
    v.put_tools_to_hand();
    v.keep_today(20);
    int tried = 0;
    walk(v, [&](const std::string& name) {
      std::vector<Control> all;
      for (const auto& [id, rect] : v.visit->controls()) all.push_back({id, rect});
      for (const Control& from : all)
        for (const auto to : {Direction::up, Direction::down, Direction::left, Direction::right}) {
          const std::string there = step_focus(all, from.id, to);
          const auto end =
              std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.id == there; });
          ASSERT_NE(end, all.end());
          for (const Control& c : all) {
            const auto beyond = straight(from.rect, c.rect, to);
            if (!beyond || c.id == from.id || c.id == there) continue;
            ++tried;
            const auto landed = straight(from.rect, end->rect, to);
            const auto past = straight(c.rect, end->rect, to);
            EXPECT_FALSE(!landed && past)
                << name << ": " << from.id << " over " << c.id << " to " << there;
            EXPECT_FALSE(landed && *landed > *beyond + (to == Direction::up || to == Direction::down
                                                            ? c.rect.h
                                                            : c.rect.w))
                << name << ": " << from.id << " over " << c.id << " to " << there;
          }
        }
    });
    EXPECT_GT(tried, 800);
  }
}

TEST(Focus, LeavesARowAtItsEnd) {
  EXPECT_EQ(step_focus(kRows, "done", Direction::left), "lump");  // The one before it.
  EXPECT_EQ(step_focus({}, "done", Direction::left), "");
}

}  // namespace
}  // namespace onggi::screens::focus_test
