#include "kiosk/visit/screens/focus.h"

#include <gtest/gtest.h>

namespace onggi::screens {
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

TEST(Focus, LeavesARowAtItsEnd) {
  EXPECT_EQ(step_focus(kRows, "done", Direction::left), "lump");  // The one before it.
  EXPECT_EQ(step_focus({}, "done", Direction::left), "");
}

}  // namespace
}  // namespace onggi::screens
