#include "tests/pages/naive_text.h"

#include <gtest/gtest.h>

namespace onggi::pages {
namespace {

TEST(NaiveText, SaysNeverWhereNoPotBecameHandsome) {
  measure::HeadlessOutcome one;
  one.vessel = "bowl";
  one.looks = {{30, 30, 1, {0.001, 0.001}, 0.0004}};
  measure::NaiveTable table;
  table.plan.moments = {30};
  table.lines = measure::lines_of({one}, table.plan.moments);
  EXPECT_NE(text_of(table).find("never"), std::string::npos);
  one.handsome_at = 20;
  table.lines = measure::lines_of({one}, table.plan.moments);
  EXPECT_EQ(text_of(table).find("never"), std::string::npos);
  EXPECT_NE(text_of(table).find("20 s (1 of 1)"), std::string::npos) << text_of(table);
}

}  // namespace
}  // namespace onggi::pages
