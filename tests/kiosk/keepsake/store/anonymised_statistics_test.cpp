#include "kiosk/keepsake/store/anonymised_statistics.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <string_view>

namespace onggi::store::anonymised_statistics_test {
namespace {

constexpr std::int64_t kFew = AnonymisedStatistics::kLeast;

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
  const AnonymisedStatistics p = publish(s);
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
  const AnonymisedStatistics p = publish(s);
  EXPECT_FALSE(p.all.kept) << "98 of 100 say of two that they kept none";
  for (const auto& line : p.tables[0].lines) {
    EXPECT_TRUE(line.visits);
    EXPECT_FALSE(line.kept);
    EXPECT_TRUE(line.likeness);
  }
}

TEST(Published, HowManyFetchedIsToldWhereItIsAboutManyAndSoIsWhoDidNot) {
  Statistics s;
  s.all.visits = 100;
  s.all.kept = 50;
  const auto told = [&s](std::int64_t fetched) {
    s.fetched = fetched;
    return publish(s).fetched;
  };
  for (const std::int64_t many : {0, 5, 45, 50, 60}) EXPECT_EQ(told(many), many);
  for (const std::int64_t few : {1, 4, 46, 49}) EXPECT_EQ(told(few), std::nullopt) << few;
  s.all.kept = 97;
  EXPECT_EQ(told(50), std::nullopt) << "how many kept is not told either";
  s.all.kept = s.all.visits = 4;
  EXPECT_EQ(told(0), std::nullopt);
}

TEST(Published, OfFourVisitorsNothingIsTold) {
  Statistics s;
  s.all = cell("", 4, 0, 4);
  s.median_s = 60.0;
  s.pots = 9;
  s.tables = {{"vessel", {cell("moon_jar", 4, 0, 4)}}};
  const AnonymisedStatistics p = publish(s);
  EXPECT_FALSE(p.all.visits || p.all.active_min || p.all.likeness || p.pots || p.median_min);
  EXPECT_TRUE(p.tables[0].lines.empty());
  EXPECT_TRUE(p.tables[0].too_few);
}

/// Visits of a small museum: vessels, missions, months and days that few or many come to; a fault
/// now and then. "mission0" is a description, and so among the vessels too.
Statistics quiet_museum(unsigned seed) {
  std::mt19937 random(seed);
  const auto pick = [&random](unsigned most) { return static_cast<unsigned>(random()) % most; };
  Statistics s;
  const char* const names[] = {"vessel",   "mission", "left", "ended",
                               "language", "month",   "day",  "hour"};
  std::map<std::string, std::map<std::string, Cell>> tables;
  const unsigned visits = pick(pick(3) == 0 ? 200 : 40), kinds = 1 + pick(6), often = 1 + pick(8),
                 keep = pick(6);
  for (unsigned n = 0; n < visits; ++n) {
    const auto rare = [&](unsigned most) { return std::min(pick(most), pick(often)); };
    const unsigned month = rare(3);
    const std::string left = pick(12) == 0 ? "fault" : pick(2) == 0 ? "throw" : "keepsake";
    const std::string mission = pick(3) > 0 ? "" : "mission" + std::to_string(rare(3));
    const std::string of[] = {
        mission == "mission0" ? mission : "vessel" + std::to_string(rare(kinds)),
        mission,
        left,
        left == "fault"                   ? left
        : left == "throw" && pick(4) == 0 ? "idle"
                                          : "back",
        pick(9) == 0 ? "ko" : "en",
        "2026-0" + std::to_string(month + 1),
        "2026-0" + std::to_string(month + 1) + "-0" + std::to_string(1 + rare(5)),
        std::to_string(10 + rare(6))};
    const bool kept = pick(6) < keep, judged = pick(6) < 5;
    const auto count = [&](Cell& cell) {
      ++cell.visits;
      cell.kept += kept ? 1 : 0;
      cell.judged += judged ? 1 : 0;
      cell.likeness += judged ? 50.0 : 0.0;
      cell.active_s += 60.0;
    };
    count(s.all);
    for (std::size_t t = 0; t < std::size(of); ++t) count(tables[names[t]][of[t]]);
  }
  for (const char* name : names) {
    Table table{name, {}};
    for (auto& [line, cell] : tables[name]) {
      cell.name = line;
      table.cells.push_back(cell);
    }
    const std::string_view in_order = "month day hour";
    if (in_order.find(name) == std::string_view::npos)
      std::stable_sort(table.cells.begin(), table.cells.end(),
                       [](const Cell& a, const Cell& b) { return a.visits > b.visits; });
    s.tables.push_back(table);
  }
  return s;
}

/// What a reader knows of one figure: at least, at most.
struct Known {
  std::int64_t least = 0, most = 1'000'000;
  bool exact() const { return least == most; }
};

/// A reader with a pencil: figures that are parts of a whole, again and again, until nothing more
/// follows.
class Reader {
 public:
  Known& operator[](const std::string& figure) { return known_[figure]; }
  void parts(const std::string& whole, const std::vector<std::string>& of) {
    sums_.emplace_back(whole, of);
  }
  void reckon() {
    for (bool again = true; again;) {
      again = false;
      for (const auto& [whole, of] : sums_) {
        Known sum{0, 0};
        for (const std::string& part : of) {
          sum.least += known_[part].least;
          sum.most += known_[part].most;
        }
        again |= narrow(known_[whole], sum.least, sum.most);
        for (const std::string& part : of) {
          const Known& p = known_[part];
          again |= narrow(known_[part], known_[whole].least - (sum.most - p.most),
                          known_[whole].most - (sum.least - p.least));
          if (again) break;
        }
        if (again) break;
      }
    }
  }

 private:
  static bool narrow(Known& figure, std::int64_t least, std::int64_t most) {
    const Known was = figure;
    figure.least = std::max(figure.least, least);
    figure.most = std::min(figure.most, most);
    return figure.least != was.least || figure.most != was.most;
  }
  std::map<std::string, Known> known_;
  std::vector<std::pair<std::string, std::vector<std::string>>> sums_;
};

std::string whole_of(const std::string& table, const std::string& line) {
  return table == "day" ? "month " + line.substr(0, 7) : "all";
}

// Subtraction, in every table, of days from their month, and of two lines that are the same
// visits; with keepsakes likewise, of which there are no more than visits.
TEST(Published, NoFigureThatIsLeftOutCanBeReckonedFromThoseThatAreTold) {
  int left_out = 0, told = 0;
  for (unsigned seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    const Statistics s = quiet_museum(seed);
    const AnonymisedStatistics p = publish(s);
    Reader visits, kept;
    const auto know = [](Known& figure, const std::optional<std::int64_t>& value,
                         std::int64_t least) {
      figure.least = value.value_or(least);
      if (value) figure.most = *value;
    };
    know(visits["all"], p.all.visits, 1);
    know(kept["all"], p.all.kept, 0);
    std::vector<std::string> figures;
    for (const auto& table : p.tables) {
      std::map<std::string, std::vector<std::string>> wholes;
      for (const auto& line : table.lines) {
        const std::string figure = table.name + ' ' + line.name;
        figures.push_back(figure);
        know(visits[figure], line.visits, 1);
        know(kept[figure], line.kept, 0);
        wholes[whole_of(table.name, line.name)].push_back(figure);
      }
      for (const auto& [whole, of] : wholes) {
        visits.parts(whole, of);
        kept.parts(whole, of);
      }
    }
    for (Reader* reader : {&visits, &kept}) {
      reader->parts("left fault", {"ended fault"});
      reader->parts("vessel mission0", {"mission mission0"});
    }
    visits.reckon();
    for (const std::string& figure : figures)
      kept[figure].most = std::min(kept[figure].most, visits[figure].most);
    kept["all"].most = std::min(kept["all"].most, visits["all"].most);
    kept.reckon();

    for (const auto& table : p.tables)
      for (const auto& line : table.lines) {
        const std::string figure = table.name + ' ' + line.name;
        (line.visits ? told : left_out) += 1;
        if (!line.visits) {
          EXPECT_FALSE(visits[figure].exact()) << figure;
        }
        const std::string whole = whole_of(table.name, line.name);
        // What is told of the whole as "nobody" or "all" is told of each.
        const bool everybody = kept[whole].exact() && visits[whole].exact() &&
                               (kept[whole].most == 0 || kept[whole].most == visits[whole].most);
        if (!line.kept && !everybody) {
          EXPECT_FALSE(kept[figure].exact()) << figure << " kept";
        }
      }
    if (!p.all.kept) {
      EXPECT_FALSE(kept["all"].exact());
    }
    if (testing::Test::HasFailure()) break;
  }
  EXPECT_GT(left_out, 1000);
  EXPECT_GT(told, 20'000) << "the others are told";
}

// The remainder of what is told is about nobody, or about enough people.
TEST(Published, WhatIsLeftOfAWholeIsNeverAboutAFew) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const AnonymisedStatistics p = publish(quiet_museum(seed));
    std::map<std::string, const AnonymisedStatistics::Line*> wholes{{"all", &p.all}};
    for (const auto& table : p.tables)
      for (const auto& line : table.lines) wholes["month " + line.name] = &line;
    for (const auto& table : p.tables) {
      std::map<std::string, std::array<std::int64_t, 3>> told;
      for (const auto& line : table.lines) {
        auto& sums = told[whole_of(table.name, line.name)];
        sums[0] += line.visits.value_or(0);
        sums[1] += line.kept.value_or(0);
        sums[2] += line.kept ? *line.visits - *line.kept : 0;
      }
      for (const auto& [name, sums] : told) {
        const auto& whole = *wholes.at(name);
        if (!whole.visits) continue;
        const auto enough = [](std::int64_t rest) { return rest == 0 || rest >= kFew; };
        EXPECT_TRUE(enough(*whole.visits - sums[0])) << seed << ' ' << table.name << ' ' << name;
        if (!whole.kept) continue;
        EXPECT_TRUE(enough(*whole.kept - sums[1])) << seed << ' ' << table.name << ' ' << name;
        EXPECT_TRUE(enough(*whole.visits - *whole.kept - sums[2]))
            << seed << ' ' << table.name << ' ' << name;
      }
    }
  }
}

TEST(Published, WhatIsLeftOutStandsByNameAfterTheOthers) {
  Statistics s;
  s.all = cell("", 120, 60, 100);
  s.tables = {{"vessel",
               {cell("moon_jar", 100, 50, 90), cell("tea_bowl", 17, 8, 8), cell("cup", 3, 2, 2)}}};
  const AnonymisedStatistics p = publish(s);
  std::string order;
  for (const auto& line : p.tables.at(0).lines) order += line.name + ' ';
  EXPECT_EQ(order, "moon_jar cup tea_bowl ") << "most first would tell that the cup was rarer";
}

TEST(Published, AMonthIsNotItsToldDaysAndOneMore) {
  Statistics s;
  s.all = cell("", 60, 30, 40);
  s.tables = {
      {"month", {cell("2026-05", 33, 16, 20), cell("2026-06", 27, 14, 20)}},
      {"day",
       {cell("2026-05-01", 20, 10, 10), cell("2026-05-02", 10, 5, 7), cell("2026-05-03", 3, 1, 3),
        cell("2026-06-01", 25, 13, 19), cell("2026-06-02", 2, 1, 1)}}};
  const AnonymisedStatistics p = publish(s);
  EXPECT_EQ(p.tables.at(0).left_out, 0);
  const auto& days = p.tables.at(1).lines;
  EXPECT_EQ(days.at(0).visits, 20);
  for (const std::size_t n : {1u, 2u, 3u, 4u}) EXPECT_FALSE(days.at(n).visits) << days[n].name;
}

// Five vessels of one visitor each: the five of the total would tell of each.
TEST(Published, WhereEveryLineIsOneVisitorNotEvenTheLinesAreNamed) {
  Statistics s;
  s.all = cell("", 5, 0, 0);
  s.tables = {{"vessel", {}}};
  for (const char* name : {"a", "b", "c", "d", "e"})
    s.tables[0].cells.push_back(cell(name, 1, 0, 0));
  const AnonymisedStatistics p = publish(s);
  EXPECT_EQ(p.all.visits, 5);
  EXPECT_TRUE(p.tables.at(0).lines.empty());
  EXPECT_TRUE(p.tables.at(0).too_few);
}

}  // namespace
}  // namespace onggi::store::anonymised_statistics_test
