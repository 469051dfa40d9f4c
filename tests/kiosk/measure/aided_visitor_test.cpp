#include "kiosk/measure/aided_visitor.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kiosk/measure/quiet_visit.h"

namespace onggi::measure {
namespace {

/// A pot of a whole visit without eyes, or with one switch, is worth this at the least.
constexpr double kBound = 80;
constexpr int kStrokes = 20;

const QuietVisits& visits(const std::string& language) {
  static const auto kEnglish = QuietVisits::open("config/exhibit.toml", "", "en");
  static const auto kKorean = QuietVisits::open("config/exhibit.toml", "", "ko");
  return **(language == "ko" ? kKorean : kEnglish);
}

bool says(const AidedOutcome& visit, const std::string& words) {
  return std::any_of(visit.said.begin(), visit.said.end(), [&](const access::Utterance& one) {
    return one.text.find(words) != std::string::npos;
  });
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
  EXPECT_TRUE(visit->kept);
  EXPECT_GT(visit->points, kBound);
  EXPECT_LT(visit->seconds, 300);
  EXPECT_TRUE(says(*visit, language_.say("stroke.all_near")));
  EXPECT_TRUE(says(*visit, language_.say("result.title_" + std::to_string(5))) ||
              says(*visit, language_.say("result.title_" + std::to_string(4))));
  EXPECT_TRUE(says(*visit, language_.say("keepsake.kept")));
  for (std::size_t n = 0; n < visit->said.size(); ++n) {
    const access::Utterance& one = visit->said[n];
    EXPECT_TRUE(one.text.empty() || one.language == GetParam());
    EXPECT_EQ(one.text.find('['), std::string::npos) << one.text;
    EXPECT_EQ(one.text.find('{'), std::string::npos) << one.text;
    EXPECT_TRUE(n == 0 || one.text != visit->said[n - 1].text) << "chatter: " << one.text;
  }
  EXPECT_TRUE(visit->said.back().text.empty()) << "who has left is not talked to";
}

TEST(AidedVisits, AWholeVisitIsMadeWithOneSwitch) {
  const auto& all = visits("en");
  const auto visit = all.one_switch(*all.card_of("moon_jar"), kStrokes, 0.5);
  ASSERT_TRUE(visit) << visit.error().what;
  EXPECT_TRUE(visit->kept);
  EXPECT_GT(visit->points, kBound);
  EXPECT_LT(visit->seconds, 300);
  EXPECT_LE(visit->presses, 2 * (2 * visit->strokes + 10)) << "two a choice, two choices a stroke";
}

INSTANTIATE_TEST_SUITE_P(Languages, HeardVisits, ::testing::Values("en", "ko"));

TEST(AidedVisits, ASlowSwitchHasAllTheTimeItNeeds) {
  const auto& all = visits("ko");
  const auto visit = all.one_switch(*all.card_of("moon_jar"), kStrokes, 5.0);
  ASSERT_TRUE(visit) << visit.error().what;
  EXPECT_TRUE(visit->kept);
  EXPECT_GT(visit->points, kBound);
}

}  // namespace
}  // namespace onggi::measure
