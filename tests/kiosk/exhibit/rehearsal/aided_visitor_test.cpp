#include "kiosk/exhibit/rehearsal/aided_visitor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "kiosk/collection/settings/mission_file.h"
#include "kiosk/lab/measure/headless_visit.h"
#include "kiosk/visit/screens/label.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::rehearsal::aided_visitor_test {
namespace {

using measure::AidedOutcome;
using measure::HeadlessVisits;

/// A pot of a whole visit without eyes, or with one switch, is worth this at the least.
constexpr double kBound = 80;
constexpr int kStrokes = 20;

const HeadlessVisits& visits(std::string_view language) {
  static const auto kEnglish = HeadlessVisits::open("config/exhibit.toml", "", "en");
  static const auto kKorean = HeadlessVisits::open("config/exhibit.toml", "", "ko");
  return **(language == "ko" ? kKorean : kEnglish);
}

bool says(const AidedOutcome& visit, const std::string& words) {
  return std::any_of(visit.said.begin(), visit.said.end(), [&](const access::Utterance& one) {
    return one.text.find(words) != std::string::npos;
  });
}

/// What kiosk/docs/records/access.md has in its tables; --gtest_output=json shows it.
void note(const AidedOutcome& visit, const std::string& name) {
  ::testing::Test::RecordProperty(name, std::to_string(visit.points) + " points, " +
                                            std::to_string(visit.strokes) + " strokes, " +
                                            std::to_string(visit.presses) + " presses, " +
                                            std::to_string(visit.seconds) + " s");
}

/// All in one language, nothing that is no word, and nothing twice.
void check_speech(const AidedOutcome& visit, const std::string& language) {
  for (std::size_t n = 0; n < visit.said.size(); ++n) {
    const access::Utterance& one = visit.said[n];
    EXPECT_TRUE(one.text.empty() || one.language == language);
    EXPECT_EQ(one.text.find('['), std::string::npos) << one.text;
    EXPECT_EQ(one.text.find('{'), std::string::npos) << one.text;
    EXPECT_TRUE(n == 0 || one.text != visit.said[n - 1].text) << "chatter: " << one.text;
  }
}

class HeardVisits : public ::testing::TestWithParam<const char*> {
 protected:
  HeardVisits()
      : language_(
            *content::Language::read(std::string("content/languages/") + GetParam() + ".toml")) {}
  content::Language language_;
};

TEST_P(HeardVisits, AWholeVisitIsMadeByWhoHearsAndHasKeysAndSeesNothing) {
  const auto& all = visits(GetParam());
  const auto visit = all.blind(*all.card_of("moon_jar"), kStrokes);
  ASSERT_TRUE(visit) << visit.error().what;
  note(*visit, "moon_jar");
  EXPECT_TRUE(visit->kept);
  EXPECT_GT(visit->points, kBound);
  EXPECT_LT(visit->seconds, 300);
  EXPECT_TRUE(says(*visit, language_.say("stroke.all_near")));
  EXPECT_TRUE(says(*visit, language_.say("result.title_" + std::to_string(5))) ||
              says(*visit, language_.say("result.title_" + std::to_string(4))));
  EXPECT_TRUE(says(*visit, language_.say("keepsake.kept")));
  check_speech(*visit, GetParam());
  EXPECT_TRUE(visit->said.back().text.empty()) << "who has left is not talked to";
}

TEST(AidedVisits, AWholeVisitIsMadeWithOneSwitch) {
  const auto& all = visits("en");
  const auto visit = all.one_switch(*all.card_of("moon_jar"), kStrokes, 0.5);
  ASSERT_TRUE(visit) << visit.error().what;
  note(*visit, "moon_jar");
  EXPECT_TRUE(visit->kept);
  EXPECT_GT(visit->points, kBound);
  EXPECT_LT(visit->seconds, 300);
  EXPECT_LE(visit->presses, 2 * (2 * visit->strokes + 10)) << "two a choice, two choices a stroke";
}

INSTANTIATE_TEST_SUITE_P(Languages, HeardVisits, ::testing::Values("en", "ko"),
                         [](const auto& language) { return std::string(language.param); });

TEST(AidedVisits, ASlowSwitchHasAllTheTimeItNeeds) {
  const auto& all = visits("ko");
  const auto visit = all.one_switch(*all.card_of("moon_jar"), kStrokes, 5.0);
  ASSERT_TRUE(visit) << visit.error().what;
  note(*visit, "moon_jar");
  EXPECT_TRUE(visit->kept);
  EXPECT_GT(visit->points, kBound);
}

/// Those that come with onggi, each as it comes.
settings::Mission mission_of(const std::string& id) {
  for (const settings::Mission& one : settings::read_missions("content/missions.toml").missions)
    if (one.id == id) return one;
  ADD_FAILURE() << id;
  return {};
}

/// Words of a page, said at once.
bool says_together(const AidedOutcome& visit, const std::string& one, const std::string& other) {
  return std::any_of(visit.said.begin(), visit.said.end(), [&](const access::Utterance& all) {
    return all.text.find(one) != std::string::npos && all.text.find(other) != std::string::npos;
  });
}

class HeardMissions : public HeardVisits {
 protected:
  /// A whole visit without eyes, in which it is said what the mission is and what it asks for.
  AidedOutcome heard(const std::string& id) {
    const settings::Mission mission = mission_of(id);
    const auto visit = visits(GetParam()).blind(id, kStrokes);
    EXPECT_TRUE(visit) << (visit ? "" : visit.error().what);
    if (!visit) return {};
    note(*visit, id);
    EXPECT_TRUE(visit->kept);
    EXPECT_GT(visit->points, kBound);
    EXPECT_LT(visit->seconds, 300);
    EXPECT_TRUE(says(*visit, language_.say("mission.card") + ", " + mission.title_in(GetParam())));
    EXPECT_TRUE(says_together(*visit, mission.title_in(GetParam()), mission.about_in(GetParam())));
    EXPECT_TRUE(says(*visit, language_.say("keepsake.kept")));
    check_speech(*visit, GetParam());
    return *visit;
  }
};

TEST_P(HeardMissions, AJarByFiguresIsThrownByWhatIsSaidOfItAndTheResultSaysWhatItHolds) {
  const AidedOutcome visit = heard("litre_jar");
  EXPECT_EQ(visit.of, "litre_jar");
  ASSERT_FALSE(visit.asked.empty());
  EXPECT_NEAR(std::stoi(visit.asked.front().places.at("litres")), 100, 10);
  const std::string hundredths = visit.asked.front().places.at("litres");
  const std::string holds = language_.say(
      "mission.holds",
      {{"litres", screens::hundredths(std::stol(hundredths), language_)}, {"wanted", "1"}});
  EXPECT_TRUE(says_together(visit, language_.say("mission.asked"), holds)) << holds;
  EXPECT_TRUE(says(visit, language_.say("stroke.try", {{"what", language_.say("stroke.widen")},
                                                       {"where", language_.say("stroke.all")}})));
  EXPECT_FALSE(says(visit, language_.say("mission.more"))) << "that is of hands that draw";
}

TEST_P(HeardMissions, WithEyesClosedAPotIsThrownAsAnyOther) {
  EXPECT_EQ(heard("eyes_closed").of, "moon_jar");
}

TEST_P(HeardMissions, AtAWheelOfTwoItIsSaidThatBothHandsAreWhoseTheButtonsAre) {
  const std::string both = language_.say("mission.by_buttons");
  if (std::string(GetParam()) == "en") {
    EXPECT_FALSE(says(heard("todays_vessel"), both));
    return;
  }
  EXPECT_TRUE(
      says_together(heard("two_hands"), mission_of("two_hands").about_in(GetParam()), both));
}

INSTANTIATE_TEST_SUITE_P(Languages, HeardMissions, ::testing::Values("en", "ko"),
                         [](const auto& language) { return std::string(language.param); });

TEST(AidedMissions, WhatIsAdvisedStrokeByStrokeComesToTheMouthThatWasAsked) {
  const files::test::ScratchFolder folder;
  const std::string here = std::filesystem::current_path().string();
  std::ofstream(folder.path() / "missions.toml")
      << "[[mission]]\nid = \"flask\"\nkind = \"describe\"\nlitres = 1.4\nheight_mm = [120, 170]\n"
         "mouth_mm = [55, 70]\ntitle = { en = \"A flask\" }\nabout = { en = \"Narrow.\" }\n";
  std::ofstream(folder.path() / "exhibit.toml")
      << "languages = [\"en\"]\nshelf = \"" << here << "/content/vessels\"\nglazes = \"" << here
      << "/content/glazes.toml\"\nscene = \"" << here
      << "/config/scenes/first_touch.toml\"\nmissions = \"missions.toml\"\n";
  const auto all = HeadlessVisits::open((folder.path() / "exhibit.toml").string());
  ASSERT_TRUE(all) << all.error().what;
  const auto visit = (*all)->blind("flask", kStrokes);
  ASSERT_TRUE(visit) << visit.error().what;
  note(*visit, "flask");
  EXPECT_TRUE(says(*visit, "Try: Narrow, Rim."));
  EXPECT_TRUE(says(*visit, "Nearly right."));
  EXPECT_GT(visit->points, kBound);
  ASSERT_EQ(visit->asked.size(), 3u);
  EXPECT_LE(std::stoi(visit->asked.back().places.at("mm")), 72);
}

TEST(AidedMissions, EachIsDoneWithOneSwitch) {
  for (const auto& [id, language] :
       {std::pair{"litre_jar", "ko"}, {"eyes_closed", "en"}, {"two_hands", "ko"}}) {
    const auto visit = visits(language).one_switch(id, kStrokes, 0.5);
    ASSERT_TRUE(visit) << id << ": " << visit.error().what;
    note(*visit, id);
    EXPECT_TRUE(visit->kept) << id;
    EXPECT_GT(visit->points, kBound) << id;
    EXPECT_LT(visit->seconds, 300) << id;
    EXPECT_LE(visit->presses, 2 * (2 * visit->strokes + 10)) << id;
  }
  EXPECT_FALSE(visits("en").one_switch("nothing", kStrokes, 0.5)) << "that there is none is said";
}

}  // namespace
}  // namespace onggi::rehearsal::aided_visitor_test
