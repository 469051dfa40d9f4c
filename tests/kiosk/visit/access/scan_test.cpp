#include "kiosk/visit/access/scan.h"

#include <gtest/gtest.h>

namespace onggi::access::scan_test {
namespace {

using screens::ScreenText;

content::Language english() { return *content::Language::read("content/languages/en.toml"); }

struct Page {
  Page() {
    reading.language = &language;
    reading.scan_seconds = 1.0;
    reading.first = "c";
    //   a b
    //   c d e
    //   f
    reading.controls = {{"a", {0, 0, 10, 10}},   {"b", {20, 1, 10, 10}},  {"c", {0, 30, 10, 10}},
                        {"d", {20, 30, 10, 10}}, {"e", {40, 30, 10, 10}}, {"f", {0, 60, 10, 10}}};
  }
  /// Frames until `seconds` later.
  void wait(double seconds) {
    for (const double until = now + seconds; now < until - 1e-9; now += 0.02)
      scan.look(reading, now);
    scan.look(reading, now);
  }
  std::string shown() const {
    std::string all;
    for (const auto& id : scan.shown()) all += id;
    return all;
  }
  content::Language language = english();
  ScreenText reading;
  Scan scan;
  double now = 10;
};

TEST(Scan, StepsThroughRowsFromWhereAKeyboardWouldBeginAndRoundAgain) {
  Page p;
  p.wait(0.1);
  EXPECT_EQ(p.shown(), "cde");
  p.wait(1.2);
  EXPECT_EQ(p.shown(), "cde") << "the first stays half as long again";
  p.wait(0.3);
  EXPECT_EQ(p.shown(), "f");
  p.wait(1.0);
  EXPECT_EQ(p.shown(), "ab");
  p.wait(1.0);
  EXPECT_EQ(p.shown(), "cde");
}

TEST(Scan, APressGoesIntoTheRowAndAnotherTakesTheItemThatIsShown) {
  Page p;
  p.wait(0.1);
  EXPECT_FALSE(p.scan.press(p.reading, p.now));
  EXPECT_EQ(p.shown(), "c");
  p.wait(1.6);
  EXPECT_EQ(p.shown(), "d");
  EXPECT_EQ(p.scan.press(p.reading, p.now), std::optional<std::string>("d"));
  EXPECT_EQ(p.shown(), "cde") << "and begins anew";
}

TEST(Scan, ARowOfOneIsTakenAtOnceAndWhatIsSetLeadsOnToTheNextRow) {
  Page p;
  p.wait(1.6);
  EXPECT_EQ(p.shown(), "f");
  EXPECT_EQ(p.scan.press(p.reading, p.now), std::optional<std::string>("f"));
  p.reading.controls[2].on = true;
  p.wait(0.5);
  EXPECT_FALSE(p.scan.press(p.reading, p.now));
  p.wait(0.5);
  EXPECT_EQ(p.scan.press(p.reading, p.now), std::optional<std::string>("c"));
  EXPECT_EQ(p.shown(), "f");
}

TEST(Scan, ARowInWhichNothingIsTakenForTwoRoundsIsLeft) {
  Page p;
  p.wait(0.1);
  p.scan.press(p.reading, p.now);
  p.wait(5.9);
  EXPECT_TRUE(p.scan.in_a_row());
  p.wait(1.0);
  EXPECT_FALSE(p.scan.in_a_row());
}

TEST(Scan, ATrembleIsOnePress) {
  Page p;
  p.wait(0.1);
  p.scan.press(p.reading, p.now);
  EXPECT_FALSE(p.scan.press(p.reading, p.now + 0.15));
  EXPECT_TRUE(p.scan.press(p.reading, p.now + 0.25));
}

TEST(Scan, AnotherPageIsBegunAnewAndAPressThatComesWithItTakesNothing) {
  Page p;
  p.wait(1.6);
  p.reading.screen = screens::ScreenId::result;
  p.reading.controls = {{"x", {0, 0, 10, 10}}};
  EXPECT_FALSE(p.scan.press(p.reading, p.now)) << "what was shown has gone";
  p.wait(0.3);
  EXPECT_EQ(p.scan.press(p.reading, p.now), std::optional<std::string>("x"));
  p.reading.controls.clear();
  p.wait(2);
  EXPECT_TRUE(p.scan.shown().empty());
}

TEST(Scan, WhatComesAndGoesElsewhereTakesNobodyAway) {
  Page p;
  p.wait(0.1);
  p.scan.press(p.reading, p.now);
  p.wait(1.6);
  ASSERT_EQ(p.shown(), "d");
  p.reading.controls.erase(p.reading.controls.begin());
  p.wait(0.1);
  EXPECT_EQ(p.shown(), "d");
  EXPECT_EQ(p.scan.press(p.reading, p.now), std::optional<std::string>("d"));
}

TEST(Scan, AndTakesNoTimeFromWhatIsShown) {
  Page p;
  p.wait(1.7);
  EXPECT_EQ(p.shown(), "f");
  // News that come and go, such as a way back, while a row is shown for its second.
  for (int n = 0; n < 4; ++n) {
    p.wait(0.2);
    if (n % 2 == 0)
      p.reading.controls.push_back({"news", {0, 90, 10, 10}});
    else
      p.reading.controls.pop_back();
  }
  p.wait(0.3);
  EXPECT_NE(p.shown(), "f") << "it has had its second";
}

TEST(Scan, ThePaceIsTheVisitorsFromHalfASecondToFive) {
  for (const double pace : {0.5, 5.0}) {
    Page p;
    p.reading.scan_seconds = pace;
    p.wait(0.02);
    p.wait(1.5 * pace - 0.1);
    EXPECT_EQ(p.shown(), "cde");
    p.wait(0.2);
    EXPECT_EQ(p.shown(), "f");
    p.wait(pace - 0.3);
    EXPECT_EQ(p.shown(), "f");
    p.wait(0.3);
    EXPECT_EQ(p.shown(), "ab");
  }
}

}  // namespace
}  // namespace onggi::access::scan_test
