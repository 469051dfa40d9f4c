#include "kiosk/store/published.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <numeric>

namespace onggi::store {
namespace {

constexpr std::int64_t kFew = PublishedStatistics::kLeast;

TEST(Published, WhatIsLeftOutIsNeverOneCountNorFewPeopleTogether) {
  EXPECT_TRUE(rc::check([] {
    const auto counts = *rc::gen::container<std::vector<std::int64_t>>(rc::gen::oneOf(
        rc::gen::inRange<std::int64_t>(0, 8), rc::gen::inRange<std::int64_t>(0, 500)));
    const auto out = left_out(counts, kFew);
    RC_ASSERT(out.size() == counts.size());
    std::int64_t hidden = 0, told = 0;
    int number = 0;
    for (std::size_t n = 0; n < counts.size(); ++n) {
      if (out[n]) {
        hidden += counts[n];
        ++number;
        RC_ASSERT(counts[n] > 0);
      } else {
        RC_ASSERT(counts[n] == 0 || counts[n] >= kFew);
        told += counts[n];
      }
    }
    // Told are the total and the lines: what is left of the total is about nobody, or about enough
    // people in more lines than one, or all that there are.
    if (number > 0 && told > 0) RC_ASSERT(number >= 2 && hidden >= kFew);
  }));
}

TEST(Published, NothingIsLeftOutWhereNothingIsSmall) {
  EXPECT_EQ(left_out({5, 0, 700}, kFew), (std::vector<bool>{false, false, false}));
  EXPECT_EQ(left_out({4, 5, 700}, kFew), (std::vector<bool>{true, true, false}));
  EXPECT_EQ(left_out({1, 1, 700, 50}, kFew), (std::vector<bool>{true, true, false, true}));
  EXPECT_EQ(left_out({2, 4, 700, 50}, kFew), (std::vector<bool>{true, true, false, false}));
}

Cell cell(const std::string& name, std::int64_t visits, std::int64_t kept, std::int64_t judged) {
  return {name,   visits,
          kept,   60.0 * static_cast<double>(visits),
          judged, 50.0 * static_cast<double>(judged)};
}

TEST(Published, OfALineThatIsLeftOutNothingIsTold) {
  Statistics s;
  s.all = cell("", 120, 60, 100);
  s.brief = 3;
  s.pots = 130;
  s.median_s = 90.0;
  s.tables = {{"vessel",
               {cell("moon_jar", 100, 50, 90), cell("tea_bowl", 17, 8, 8), cell("cup", 3, 2, 2)}}};
  const PublishedStatistics p = publish(s);
  EXPECT_EQ(p.all.visits, 120);
  EXPECT_EQ(p.all.active_min, 120.0);
  EXPECT_EQ(p.all.likeness, 50.0);
  EXPECT_FALSE(p.brief) << "three passers-by are few too";
  EXPECT_EQ(p.median_min, 1.5);
  const auto& lines = p.tables.at(0).lines;
  EXPECT_EQ(p.tables[0].left_out, 2) << "the cup, and the tea bowl, which would give it away";
  EXPECT_EQ(lines[0].visits, 100);
  EXPECT_EQ(lines[0].kept, 50);
  for (const auto& line : {lines[1], lines[2]})
    EXPECT_FALSE(line.visits || line.kept || line.active_min || line.likeness) << line.name;
}

TEST(Published, AShareThatFewHaveOrAllButAFewIsLeftOutOfALineThatIsTold) {
  Statistics s;
  s.all = cell("", 100, 98, 100);
  s.tables = {{"vessel", {cell("moon_jar", 60, 59, 60), cell("tea_bowl", 40, 39, 40)}}};
  const PublishedStatistics p = publish(s);
  EXPECT_FALSE(p.all.kept) << "98 of 100 say of two that they kept none";
  for (const auto& line : p.tables[0].lines) {
    EXPECT_TRUE(line.visits);
    EXPECT_FALSE(line.kept);
    EXPECT_TRUE(line.likeness);
  }
}

TEST(Published, OfFourVisitorsNothingIsTold) {
  Statistics s;
  s.all = cell("", 4, 0, 4);
  s.median_s = 60.0;
  s.pots = 9;
  s.tables = {{"vessel", {cell("moon_jar", 4, 0, 4)}}};
  const PublishedStatistics p = publish(s);
  EXPECT_FALSE(p.all.visits || p.all.active_min || p.all.likeness || p.pots || p.median_min);
  EXPECT_FALSE(p.tables[0].lines[0].visits);
}

}  // namespace
}  // namespace onggi::store
