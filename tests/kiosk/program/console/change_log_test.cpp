#include "kiosk/program/console/change_log.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/kiosk/ground/files/disk.h"

namespace onggi::console::change_log_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr std::int64_t kNow = 1'780'000'000, kDay = 24 * 3600;

TEST(ChangeLog, HasALineAChangeTheNewestFirst) {
  const files::test::ScratchFolder state;
  const ChangeLog log(state.path());
  EXPECT_TRUE(log.newest(10).empty());
  for (int n = 0; n < 5; ++n)
    ASSERT_TRUE(
        log.add({kNow + n, "maria", "127.0.0.1", "deleted keepsake", "pot " + std::to_string(n)}));
  EXPECT_THAT(log.newest(10), SizeIs(5));
  const auto two = log.newest(2);
  ASSERT_THAT(two, SizeIs(2));
  EXPECT_THAT(two[0], AllOf(HasSubstr("\"what\":\"pot 4\""), HasSubstr("\"who\":\"maria\"")));
  EXPECT_THAT(two[1], HasSubstr("pot 3"));
}

TEST(ChangeLog, WhateverSomebodyIsCalledALineStaysALine) {
  const files::test::ScratchFolder state;
  const ChangeLog log(state.path());
  ASSERT_TRUE(log.add({kNow, "a\"}\n{\"at\":1", "\xff", "did\nnot", "\x01"}));
  EXPECT_THAT(log.newest(10), SizeIs(1));
}

TEST(ChangeLog, ForgetsAfter400DaysAndWhatAPowerCutTore) {
  const files::test::ScratchFolder state;
  const ChangeLog log(state.path());
  for (const std::int64_t days : {401, 399, 0})
    ASSERT_TRUE(log.add({kNow - days * kDay, "maria", "a", "did", std::to_string(days)}));
  std::ofstream(state / "changes", std::ios::app) << "{\"at\":178";
  ASSERT_TRUE(log.add({kNow, "maria", "a", "did", "behind"}));
  EXPECT_THAT(log.newest(10), SizeIs(4)) << "what comes behind a torn line is whole";
  ASSERT_TRUE(log.forget(kNow));
  const auto left = log.newest(10);
  ASSERT_THAT(left, SizeIs(3));
  EXPECT_THAT(left[2], HasSubstr("399"));
}

TEST(ChangeLog, ADiskThatRefusesIsTold) {
  const ChangeLog log("/nowhere/at/all");
  const auto added = log.add({kNow, "maria", "a", "did", "x"});
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().exit_code, 1);
}

}  // namespace
}  // namespace onggi::console::change_log_test
