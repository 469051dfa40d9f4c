#include "kiosk/keepsake/souvenir/pass.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "kiosk/keepsake/souvenir/open_passes.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"
#include "tests/kiosk/ground/files/disk.h"

// What a phone is told over a socket is tests/kiosk/keepsake/phone/server_test.cpp.

namespace onggi::souvenir::pass_test {
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
  /// As if the last change of the folder was long ago.
  void settle() const {
    fs::last_write_time(scratch_.path() / "phone",
                        fs::file_time_type::clock::now() - std::chrono::hours(1));
  }
  Passes passes_{scratch_.path()};
  OpenPasses open_{scratch_.path()};
};

TEST_F(PassTest, EveryTokenCostsTheSameWorkRightOrWrongAndHoweverNearlyRight) {
  for (int n = 0; n < 6; ++n) give();
  const Pass good = give(), expired = give(1);
  const std::int64_t now = kNow + 2 * kHour;
  settle();
  open_.find("", now);
  const OpenPasses::Work wanted{8 * kTokenLetters, 1, 0};
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
    OpenPasses::Work work;
    EXPECT_EQ(open_.find(token, now, &work).has_value(), token == good.token) << token;
    EXPECT_EQ(work, wanted) << token;
  }
}

TEST_F(PassTest, IsReadAsItWasGivenAndOneOfAnOlderOnggiTooWithoutWhatItDidNotKnow) {
  const Pass given = give();
  const auto found = open_.find(given.token, kNow);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->visit, kVisit);
  EXPECT_EQ(found->language, "ko");
  EXPECT_EQ(found->counted, given.counted);
  EXPECT_EQ(found->counted.size(), Passes::kTokenLetters);
  const std::string old(26, 'q');
  std::ofstream(scratch_.path() / "phone" / old) << kVisit << '\n'
                                                 << kNow << '\n'
                                                 << kNow + kHour << '\n';
  const auto older = open_.find(old, kNow);
  ASSERT_TRUE(older);
  EXPECT_EQ(older->language, "");
  EXPECT_EQ(older->counted, "");
  open_.note_fetched(*older, kNow);
  EXPECT_FALSE(fs::exists(passes_.fetched())) << "there is no name to count it under";
}

TEST_F(PassTest, IsGivenForATokenThatThePostcardHasAlreadyAndForNoOther) {
  const auto token = Passes::new_token();
  ASSERT_TRUE(token);
  ASSERT_TRUE(passes_.give(kVisit, kNow, 24, "en", *token));
  EXPECT_TRUE(open_.find(*token, kNow));
  for (const std::string& other : {std::string("../x"), token->substr(1), *token + "a"})
    EXPECT_FALSE(passes_.give(kVisit, kNow, 24, "en", other)) << other;
  passes_.take_back({*token, kVisit});
  EXPECT_FALSE(open_.find(*token, kNow));
}

TEST_F(PassTest, OneOfAKeepsakeThatIsStillBeingWrittenIsNotForgottenAndNotYetWhole) {
  const Pass pass = give();
  const fs::path partial = scratch_.path() / (std::string(kVisit) + kPartial);
  fs::rename(scratch_.path() / kVisit, partial);
  open_.forget_some(kNow + 60);
  ASSERT_TRUE(open_.find(pass.token, kNow));
  EXPECT_FALSE(open_.find(pass.token, kNow)->whole);
  fs::rename(partial, scratch_.path() / kVisit);
  EXPECT_TRUE(open_.find(pass.token, kNow)->whole);
  fs::remove(scratch_.path() / kVisit);
  open_.forget_some(kNow + 60);
  EXPECT_EQ(files(), 0u);
}

TEST_F(PassTest, TheFolderIsListedWhenItHasChangedAndNotForEachPhone) {
  give();
  settle();
  OpenPasses::Work work;
  const auto lists = [&](const std::string& token) {
    open_.find(token, kNow, &work);
    return work.lists;
  };
  EXPECT_EQ(lists("a"), 1u);
  for (int n = 0; n < 5; ++n) EXPECT_EQ(lists("a"), 0u);
  // Another process gives a pass and takes it back; each is seen at once, without a time between.
  for (int n = 0; n < 20; ++n) {
    const Pass pass = give();
    EXPECT_TRUE(open_.find(pass.token, kNow));
    Passes(scratch_.path()).take_back(pass);
    EXPECT_FALSE(open_.find(pass.token, kNow));
  }
  // A disk that keeps whole seconds: a change in the same one would leave no other time.
  fs::last_write_time(scratch_.path() / "phone",
                      std::chrono::ceil<std::chrono::seconds>(fs::file_time_type::clock::now()));
  for (int n = 0; n < 5; ++n) EXPECT_EQ(lists("a"), 1u);
  settle();
  EXPECT_EQ(lists("a"), 1u);
  EXPECT_EQ(lists("a"), 0u);
  open_.serve();
  settle();
  lists("a");
  open_.serve();
  EXPECT_EQ(lists("a"), 0u) << "to say again that phones are answered changes no name";
}

TEST_F(PassTest, TidyingReadsEachPassOnceAndAFewInATurnHoweverManyThereAre) {
  constexpr std::size_t kMany = 500;
  std::vector<Pass> passes{give(), give(1)};
  fs::create_directories(scratch_.path() / "2026-05-04_150000_meiping");
  while (passes.size() < kMany) {
    Pass pass = passes[passes.size() % 2];
    pass.token = *Passes::new_token();
    std::ofstream(scratch_.path() / "phone" / pass.token) << text_of(pass);
    passes.push_back(pass);
  }
  // Visits went on.
  ASSERT_TRUE(passes_.give(kVisit, kNow + kHour / 2, 24));
  ASSERT_TRUE(passes_.give(kVisit, kNow + kHour, 24));
  settle();
  for (const std::size_t lists_of_round : {1u, 0u}) {
    EXPECT_EQ(files(), kMany + 2) << "the first round learns the dates";
    std::size_t turns = 0, read = 0, lists = 0;
    for (bool more = true; more; ++turns) {
      OpenPasses::Work work;
      more = open_.forget_some(kNow + 2 * kHour, &work);
      EXPECT_LE(work.files, OpenPasses::kAtATurn);
      EXPECT_EQ(work.letters, 0u);
      read += work.files;
      lists += work.lists;
    }
    EXPECT_EQ(read, kMany + 2);
    EXPECT_EQ(lists, lists_of_round);
    EXPECT_EQ(turns, (kMany + 2 + OpenPasses::kAtATurn - 1) / OpenPasses::kAtATurn);
  }
  EXPECT_EQ(files(), kMany / 2 + 2) << "every second one was expired";
  for (std::size_t n = 0; n < kMany; ++n)
    EXPECT_EQ(open_.find(passes[n].token, kNow + 2 * kHour).has_value(), n % 2 == 0);
}

TEST_F(PassTest, AClockThatIsWrongByADayOrYearsTakesNoPassAndItsPageOpensAgain) {
  const Pass pass = give();
  ASSERT_TRUE(passes_.give(kVisit, kNow + kHour, 24));
  for (const std::int64_t wrong : {25 * kHour, -25 * kHour, 90000 * kHour, -400000 * kHour}) {
    for (int round = 0; round < 3; ++round)
      while (open_.forget_some(kNow + wrong)) {
      }
    EXPECT_FALSE(open_.find(pass.token, kNow + wrong)) << wrong;
    EXPECT_TRUE(open_.find(pass.token, kNow + kHour)) << "right again, after " << wrong;
    EXPECT_EQ(passes_.promised(kNow + wrong), std::set<std::string>{kVisit}) << wrong;
  }
}

TEST_F(PassTest, WhatWasGivenByAClockAYearAheadIsNotPromisedForYears) {
  ASSERT_TRUE(passes_.give(kVisit, kNow + 9000 * kHour, 24));
  EXPECT_TRUE(passes_.promised(kNow).empty());
}

TEST_F(PassTest, DeletingReadsNoPassThatIsKnownToBeAnotherVisits) {
  const std::string other = "2026-05-04_150000_meiping";
  fs::create_directories(scratch_.path() / other);
  for (int n = 0; n < 40; ++n) give();
  const auto mine = passes_.give(other, kNow, 24);
  ASSERT_TRUE(mine);
  while (open_.forget_some(kNow)) {
  }
  const auto late = passes_.give(other, kNow, 24);
  ASSERT_TRUE(late);
  OpenPasses::Work work;
  ASSERT_TRUE(open_.remove_all_of(*mine, &work));
  EXPECT_EQ(work.files, 2u) << "its own, and one that tidying has not met";
  EXPECT_EQ(files(), 40u);
  EXPECT_FALSE(open_.find(mine->token, kNow));
  EXPECT_FALSE(open_.find(late->token, kNow));
}

TEST_F(PassTest, WhatTheDiskCannotSayJustNowIsNotForgotten) {
  const Pass pass = give();
  const fs::path file = scratch_.path() / "phone" / pass.token;
  fs::rename(file, scratch_.path() / "aside");
  fs::create_symlink("nowhere", file);
  open_.forget_some(kNow);
  EXPECT_TRUE(fs::is_symlink(file)) << "it could not be read";
  EXPECT_FALSE(open_.find(pass.token, kNow));
  fs::remove(file);
  std::ofstream(file) << "no pass";
  open_.forget_some(kNow);
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(PassTest, TheDeskMayWriteAVisitWithASlashAndNamesNoneThatIsNotThereOrALink) {
  const std::string visit = (scratch_.path() / kVisit).string();
  for (const std::string& name : {visit, visit + "/", visit + "//", visit + "/."}) {
    const auto pass = Passes::give_at_the_desk(name, kNow, 24);
    ASSERT_TRUE(pass) << to_text(pass.error());
    EXPECT_TRUE(open_.find(pass->token, kNow)) << name;
  }
  const std::string linked = (scratch_.path() / "2026-05-04_150000_linked").string();
  fs::create_directory_symlink(scratch_.path() / kVisit, linked);
  const std::size_t before = files();
  for (const std::string& name :
       {(scratch_.path() / "2026-05-04_150000_not_there").string(), linked, linked + "/",
        scratch_.path().string(), std::string(), std::string("/")}) {
    const auto pass = Passes::give_at_the_desk(name, kNow, 24);
    ASSERT_FALSE(pass) << name;
    EXPECT_EQ(pass.error().exit_code, 2);
    EXPECT_EQ(pass.error().where, name);
  }
  EXPECT_EQ(files(), before);
}

}  // namespace
}  // namespace onggi::souvenir::pass_test
