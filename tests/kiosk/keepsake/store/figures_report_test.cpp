#include "kiosk/keepsake/store/figures_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace onggi::store::figures_report_test {
namespace {

AnonymisedStatistics may() {
  AnonymisedStatistics s;
  s.from = "2026-05-01";
  s.to = "2026-05-31";
  s.all = {"", 120, 60, 240.04, 71.26};
  s.brief = 12;
  s.pots = 150;
  s.fetched = 33;
  s.median_min = 1.55;
  s.throwing_min = 200.0;
  s.tables = {{"vessel",
               {{"moon_jar", 100, 55, 200.0, 70.0},
                {"=HYPERLINK(\"x\"), a \"jar\"", 15, std::nullopt, 30.0, std::nullopt},
                {"cup", {}, {}, {}, {}},
                {"bowl", {}, {}, {}, {}}},
               2},
              {"left", {{"throw", 120, 60, 240.0, 71.3}}, 0}};
  return s;
}

TEST(FiguresReport, JsonTellsWhatIsToldAndNothingWhereItIsLeftOut) {
  const auto json = nlohmann::json::parse(json_of(may()).text());
  EXPECT_EQ(json.at("visits"), 120);
  EXPECT_EQ(json.at("active_minutes"), 240.0);
  EXPECT_EQ(json.at("likeness"), 71.3);
  EXPECT_EQ(json.at("least"), 5);
  EXPECT_EQ(json.at("fetched_by_phone"), 33);
  const auto& vessels = json.at("tables").at("vessel");
  ASSERT_EQ(vessels.size(), 4u);
  EXPECT_EQ(vessels[0].at("keepsakes"), 55);
  EXPECT_TRUE(vessels[1].at("keepsakes").is_null());
  for (const char* figure : {"visits", "keepsakes", "active_minutes", "likeness"})
    EXPECT_TRUE(vessels[2].at(figure).is_null()) << figure;
}

TEST(FiguresReport, NoSpreadsheetTakesACellForAFormula) {
  std::istringstream csv(csv_of(may()));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "table,name,visits,keepsakes,active_minutes,likeness,fetched_by_phone");
  std::getline(csv, line);
  EXPECT_EQ(line, "all,,120,60,240.0,71.3,33");
  std::getline(csv, line);
  EXPECT_EQ(line, "vessel,moon_jar,100,55,200.0,70.0,");
  std::getline(csv, line);
  EXPECT_EQ(line, R"(vessel,"'=HYPERLINK(""x""), a ""jar""",15,,30.0,,)");
  std::getline(csv, line);
  EXPECT_EQ(line, "vessel,cup,,,,,");
}

TEST(FiguresReport, TheWordsNameNobodyWhoIsLeftOut) {
  const std::string words = words_of(may());
  EXPECT_TRUE(words.starts_with(
      "From 2026-05-01 to 2026-05-31, 120 people played, half of them for more than 1.6 minutes.\n"
      "All together they played for 240.0 minutes, 200.0 of them at the wheel.\n"
      "They began 150 pots. They kept 60 pots. Phones opened 33 keepsakes.\n"
      "Their pots reached 71.3 of 100 points on average.\n"
      "12 more only touched the screen in passing.\n"))
      << words;
  EXPECT_NE(words.find("  2 more not shown: a line would be about fewer than 5 people.\n"),
            std::string::npos)
      << words;
  EXPECT_EQ(words.find("cup"), std::string::npos);
}

TEST(FiguresReport, ASentenceSaysWhyAFigureIsLeftOut) {
  AnonymisedStatistics some = may();
  some.fetched.reset();
  EXPECT_NE(
      words_of(some).find("They kept 60 pots. How many were opened on a phone is not shown: it "
                          "would be about fewer than 5 people.\n"),
      std::string::npos)
      << words_of(some);
  // What is left out may also be almost all: few did not.
  some.all.kept.reset();
  EXPECT_NE(words_of(some).find("How many pots they kept is not shown: fewer than 5 were kept, or "
                                "all but fewer than 5."),
            std::string::npos)
      << words_of(some);
  some.fetched = 0;
  EXPECT_EQ(words_of(some).find("phone"), std::string::npos) << "most kiosks have none";
  some.brief.reset();
  EXPECT_NE(words_of(some).find("\nFewer than 5 more only touched the screen"), std::string::npos);
  some.brief = 0;
  EXPECT_EQ(words_of(some).find("in passing"), std::string::npos);
  AnonymisedStatistics few;
  EXPECT_EQ(words_of(few), "On all days, fewer than 5 people played.\n");
  few.all.visits = 0;
  few.from = "2026-05-01";
  EXPECT_EQ(words_of(few), "From 2026-05-01 on, nobody played.\n");
}

TEST(FiguresReport, WordsStandUnderEachOtherInEveryScript) {
  AnonymisedStatistics s = may();
  s.tables = {{"vessel",
               {{"moon_jar", 100, 55, 200.0, 70.0},
                {"달항아리_조선_십팔세기_백자_큰것", 20, 5, 40.0, 70.0}},
               0},
              {"language", {}, 0, true}};
  const std::string words = words_of(s);
  EXPECT_NE(words.find("  moon_jar                     100 visits"), std::string::npos) << words;
  EXPECT_NE(words.find("  달항아리_조선_십팔세기_       20 visits"), std::string::npos) << words;
  EXPECT_NE(words.find("Language\n  Not shown: a line would be about fewer than 5 people.\n"),
            std::string::npos)
      << words;
}

}  // namespace
}  // namespace onggi::store::figures_report_test
