#include "kiosk/visit/access/narrator.h"

#include <gtest/gtest.h>

namespace onggi::access::narrator_test {
namespace {

using screens::ScreenId;
using screens::ScreenText;

struct Listener {
  Listener() {
    reading.language = &language;
    reading.screen = ScreenId::choose;
    reading.spoken = true;
    reading.words = {"Choose a vessel", "Touch one."};
    reading.controls = {{"choose.card.0", {}, "Moon jar"}, {"choose.card.1", {}, "Meiping"}};
    reading.focus = "choose.card.0";
  }
  /// All that is said within `seconds`; the voice is quick: it has said each at once.
  std::vector<Utterance> hear(double seconds, bool quick = true) {
    std::vector<Utterance> all;
    for (const double until = now + seconds; now < until - 1e-9; now += 0.1)
      if (auto said = narrator.look(reading, {}, now)) {
        if (quick) narrator.ended(said->id);
        all.push_back(*said);
      }
    return all;
  }
  content::Language language = *content::Language::read("content/languages/en.toml");
  ScreenText reading;
  Narrator narrator;
  double now = 100;
};

TEST(Narrator, APageIsSaidOnceWhenItComesWithWhereOneIs) {
  Listener l;
  const auto said = l.hear(60);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].text.find("Choose a vessel. Touch one. Moon jar, button."), std::string::npos);
  EXPECT_TRUE(said[0].text.starts_with(l.language.say("access.begun")));
  EXPECT_EQ(said[0].language, "en");
  l.narrator.again();
  const auto again = l.hear(60);
  ASSERT_EQ(again.size(), 1u);
  EXPECT_TRUE(again[0].text.starts_with("Choose a vessel."));
}

TEST(Narrator, AControlIsSaidWhenTheKeysComeToItAndWhenItTurnsOnAndNotWhenItsNoteChanges) {
  Listener l;
  l.hear(1);
  l.reading.focus = "choose.card.1";
  auto said = l.hear(5);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].text, "Meiping, button");
  l.reading.controls[1].on = false;
  l.reading.controls[1].note = "8 mm too wide";
  said = l.hear(5);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].text, "Meiping, off, 8 mm too wide");
  l.reading.controls[1].note = "7 mm too wide";
  EXPECT_TRUE(l.hear(5).empty());
  l.reading.controls[1].on = true;
  EXPECT_EQ(l.hear(5).size(), 1u);
}

TEST(Narrator, NewsIsSaidAndNoOftenerThanEveryFourSeconds) {
  Listener l;
  l.reading.screen = ScreenId::throwing;
  l.hear(10);
  int count = 0;
  std::vector<double> at;
  for (int n = 0; n < 40; ++n) {
    l.reading.words = {"Hint " + std::string(static_cast<std::size_t>(n + 1), 'a')};
    for (const auto& said : l.hear(0.5)) {
      EXPECT_EQ(said.weight, 1);
      at.push_back(l.now);
      ++count;
    }
  }
  EXPECT_GE(count, 4);
  for (std::size_t n = 1; n < at.size(); ++n) EXPECT_GE(at[n] - at[n - 1], Narrator::kNews - 0.6);
}

TEST(Narrator, WhereThePotDiffersIsSaidWhenAskedAndWhenAStrokeIsOver) {
  Listener l;
  l.reading.screen = ScreenId::throwing;
  l.reading.differences = {"Middle: 8 mm too narrow.", "Low: 3 mm too wide."};
  l.hear(5);
  l.reading.asked = 1;
  auto said = l.hear(5);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].text, "Middle: 8 mm too narrow. Low: 3 mm too wide.");
  l.reading.working = true;
  EXPECT_TRUE(l.hear(5).empty());
  l.reading.working = false;
  EXPECT_EQ(l.hear(5).size(), 1u);
}

TEST(Narrator, WhatIsBeingSaidIsEndedByAsMuchWeightOrMoreAndNewsWaits) {
  Listener l;
  l.hear(0.1, false);  // A page, which is being said
  l.reading.focus = "choose.card.1";
  auto said = l.hear(0.2, false);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].weight, 2) << "ends the page";
  l.reading.focus = "choose.card.0";
  l.now += 4.5;
  ASSERT_EQ(l.hear(0.1, false).size(), 1u);
  l.reading.words.push_back("Your postcard is kept.");
  EXPECT_TRUE(l.hear(0.5, false).empty()) << "news ends nothing weightier";
  said = l.hear(5, false);
  ASSERT_EQ(said.size(), 1u) << "and is said after it";
  EXPECT_EQ(said[0].text, "Your postcard is kept.");
  EXPECT_EQ(said[0].weight, 1);
}

TEST(Narrator, TheWarningIsSaidOverEverythingAndCountsEveryTenSeconds) {
  Listener l;
  l.hear(1, false);
  l.reading.over = "idle";
  l.reading.controls = {{"idle.stay", {}, "I am still here"}};
  l.reading.focus = "idle.stay";
  int said = 0;
  for (int left = 25; left > 0; --left) {
    l.reading.words = {"Are you still there?", "We begin anew in " + std::to_string(left) + "."};
    for (const auto& one : l.hear(1)) {
      EXPECT_EQ(one.weight, said++ == 0 ? 3 : 1);
    }
  }
  EXPECT_EQ(said, 3) << "at once, and twice more in 25 s";
}

TEST(Narrator, NothingIsSaidInAttractOrToWhomNothingIsReadAndALeavingVisitorIsNotTalkedTo) {
  Listener l;
  l.hear(1);
  l.reading.screen = ScreenId::attract;
  const auto said = l.hear(5);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(said[0].text.empty()) << "silence, at once";
  l.reading.screen = ScreenId::choose;
  l.reading.spoken = false;
  EXPECT_TRUE(l.hear(5).empty());
  l.reading.spoken = true;
  EXPECT_TRUE(l.hear(1)[0].text.starts_with(l.language.say("access.begun"))) << "the next visitor";
}

TEST(Utterance, ASentenceWithoutAnEndingGetsOne) {
  EXPECT_EQ(joined({"Moon jar", "Is it?", "", "끝"}), "Moon jar. Is it? 끝.");
}

}  // namespace
}  // namespace onggi::access::narrator_test
