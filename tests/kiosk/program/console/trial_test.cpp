#include "kiosk/program/console/trial.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::console::trial_test {
namespace {

TEST(Trial, IsKnownAfterAnotherStartAndDueThen) {
  const files::test::ScratchFolder folder;
  {
    Trial trial(folder / "trial");
    EXPECT_FALSE(trial.now());
    EXPECT_FALSE(trial.is_due(1'000'000));
    ASSERT_TRUE(trial.set({"00000012", 500, "credit is \"도\" now."}));
  }
  Trial again(folder / "trial");
  ASSERT_TRUE(again.now());
  EXPECT_EQ(again.now()->revision, "00000012");
  EXPECT_EQ(again.now()->what, "credit is \"도\" now.");
  EXPECT_FALSE(again.is_due(499));
  EXPECT_TRUE(again.is_due(500));
  again.end();
  EXPECT_FALSE(Trial(folder / "trial").now());
}

TEST(Trial, IsNoneWhereItsFileIsDamagedOrCannotBeWritten) {
  const files::test::ScratchFolder folder;
  for (const char* text : {"", "{", "[]", "{\"revision\": 5, \"until\": 5, \"what\": \"\"}",
                           "{\"revision\": \"5\", \"until\": \"5\", \"what\": \"\"}"}) {
    std::ofstream(folder / "trial") << text;
    EXPECT_FALSE(Trial(folder / "trial").now()) << text;
  }
  Trial none(folder / "no/folder/trial");
  EXPECT_FALSE(none.set({"00000012", 500, ""}));
  EXPECT_FALSE(none.now());
}

}  // namespace
}  // namespace onggi::console::trial_test
