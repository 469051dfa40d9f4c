#include "kiosk/keepsake/souvenir/pass.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "kiosk/keepsake/souvenir/visit_folder.h"
#include "tests/kiosk/ground/files/disk.h"

// What a phone is told over a socket is tests/kiosk/keepsake/phone/server_test.cpp.

namespace onggi::souvenir {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kNow = 1'780'000'000, kHour = 3600;
constexpr const char* kVisit = "2026-05-04_141503_moon_jar";

class PassTest : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(scratch_.path() / kVisit); }
  Pass give(double hours = 24) {
    const auto pass = passes_.give(kVisit, kNow, hours, "ko");
    EXPECT_TRUE(pass) << to_text(pass.error());
    return *pass;
  }
  std::size_t files() const {
    const auto all = fs::directory_iterator(scratch_.path() / "phone");
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }
  files::test::ScratchFolder scratch_;
  Passes passes_{scratch_.path()};
};

TEST_F(PassTest, EveryTokenCostsTheSameWorkRightOrWrongAndHoweverNearlyRight) {
  for (int n = 0; n < 6; ++n) give();
  const Pass good = give(), expired = give(1);
  const std::int64_t now = kNow + 2 * kHour;
  const Passes::Work wanted{8 * Passes::kTokenLetters, 1};
  std::set<std::string> asked{"",
                              "a",
                              good.token,
                              expired.token,
                              good.token + "a",
                              std::string(26, 'a'),
                              std::string(5000, '2')};
  // Wrong in one letter, at each place, and right up to each.
  for (std::size_t n = 0; n < good.token.size(); ++n) {
    std::string near = good.token;
    near[n] = near[n] == 'b' ? 'c' : 'b';
    asked.insert(near);
    asked.insert(good.token.substr(0, n));
  }
  for (const std::string& token : asked) {
    Passes::Work work;
    EXPECT_EQ(passes_.find(token, now, &work).has_value(), token == good.token) << token;
    EXPECT_EQ(work, wanted) << token;
  }
}

TEST_F(PassTest, IsReadAsItWasGivenAndOneOfAnOlderOnggiTooWithoutWhatItDidNotKnow) {
  const Pass given = give();
  const auto found = passes_.find(given.token, kNow);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->visit, kVisit);
  EXPECT_EQ(found->language, "ko");
  EXPECT_EQ(found->counted, given.counted);
  EXPECT_EQ(found->counted.size(), Passes::kTokenLetters);
  const std::string old(26, 'q');
  std::ofstream(scratch_.path() / "phone" / old) << kVisit << '\n'
                                                 << kNow << '\n'
                                                 << kNow + kHour << '\n';
  const auto older = passes_.find(old, kNow);
  ASSERT_TRUE(older);
  EXPECT_EQ(older->language, "");
  EXPECT_EQ(older->counted, "");
  passes_.note_fetched(*older, kNow);
  EXPECT_FALSE(fs::exists(passes_.fetched())) << "there is no name to count it under";
}

TEST_F(PassTest, IsGivenForATokenThatThePostcardHasAlreadyAndForNoOther) {
  const auto token = Passes::new_token();
  ASSERT_TRUE(token);
  ASSERT_TRUE(passes_.give(kVisit, kNow, 24, "en", *token));
  EXPECT_TRUE(passes_.find(*token, kNow));
  for (const std::string& other : {std::string("../x"), token->substr(1), *token + "a"})
    EXPECT_FALSE(passes_.give(kVisit, kNow, 24, "en", other)) << other;
  passes_.take_back({*token, kVisit});
  EXPECT_FALSE(passes_.find(*token, kNow));
}

TEST_F(PassTest, OneOfAKeepsakeThatIsStillBeingWrittenIsNotForgottenAndNotYetWhole) {
  const Pass pass = give();
  const fs::path partial = scratch_.path() / (std::string(kVisit) + kPartial);
  fs::rename(scratch_.path() / kVisit, partial);
  passes_.forget(kNow + 60);
  ASSERT_TRUE(passes_.find(pass.token, kNow));
  EXPECT_FALSE(passes_.find(pass.token, kNow)->whole);
  fs::rename(partial, scratch_.path() / kVisit);
  EXPECT_TRUE(passes_.find(pass.token, kNow)->whole);
  fs::remove(scratch_.path() / kVisit);
  passes_.forget(kNow + 60);
  EXPECT_EQ(files(), 0u);
}

}  // namespace
}  // namespace onggi::souvenir
