#include "kiosk/lab/measure/witness_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>

namespace onggi::measure::witness_report_test {
namespace {

using ::testing::HasSubstr;

Result<WitnessReport> asked(const std::string& only, double altered = 0.0) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> nowhere(std::tmpfile(), std::fclose);
  return measure_witnesses({only, altered}, nowhere.get());
}

TEST(WitnessReport, HasTheLawsOfAFamilyOrOfAWordInTheirNames) {
  const auto family = asked("walls");
  ASSERT_TRUE(family);
  EXPECT_EQ(family->rows.size(), lab::wall_witnesses().size());
  EXPECT_EQ(family->failed(), 0u);
  const auto word = asked("held press");
  ASSERT_TRUE(word);
  ASSERT_EQ(word->rows.size(), 1u);
  EXPECT_EQ(word->rows[0].family, "contact");
}

TEST(WitnessReport, SaysWhichNameWasMeantWhereThereIsNone) {
  const auto none = asked("held pres s");
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().remedy, HasSubstr("held press"));
  EXPECT_THAT(asked("xyzzy").error().remedy, HasSubstr("without --only"));
}

TEST(WitnessReport, OfALawThatIsAlteredSaysThatItDoesNotHold) {
  const auto right = asked("held press"), altered = asked("held press", 0.05);
  ASSERT_TRUE(right && altered);
  EXPECT_THAT(text_of(*right), HasSubstr("| holds |\n\n1 of 1 laws hold. "));
  EXPECT_EQ(altered->failed(), 1u);
  EXPECT_THAT(text_of(*altered), HasSubstr("**does not hold**"));
  EXPECT_THAT(json_of(*altered).text(), HasSubstr("\"holds\": false"));
  EXPECT_THAT(json_of(*altered).text(), HasSubstr("\"failed\": 1"));
}

}  // namespace
}  // namespace onggi::measure::witness_report_test
