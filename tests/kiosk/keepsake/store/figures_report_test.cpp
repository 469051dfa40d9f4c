#include "kiosk/keepsake/store/figures_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace onggi::store {
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
  EXPECT_NE(words.find("120 visitors"), std::string::npos);
  EXPECT_NE(words.find("and 2 more, left out"), std::string::npos);
  EXPECT_EQ(words.find("cup"), std::string::npos);
  EXPECT_NE(words.find("; 33 keepsakes were opened on a phone."), std::string::npos) << words;
  AnonymisedStatistics some = may();
  some.fetched.reset();
  EXPECT_NE(words_of(some).find("too few to show were opened on a phone"), std::string::npos);
  some.fetched = 0;
  EXPECT_EQ(words_of(some).find("phone"), std::string::npos) << "most kiosks have none";
  AnonymisedStatistics few;
  EXPECT_NE(words_of(few).find("too few to show"), std::string::npos);
  few.all.visits = 0;
  EXPECT_NE(words_of(few).find("none"), std::string::npos);
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
  EXPECT_NE(words.find("Language\n  Left out: too few to show.\n"), std::string::npos) << words;
}

}  // namespace
}  // namespace onggi::store
