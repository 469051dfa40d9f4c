#include "kiosk/program/console/change_on_trial.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::console::change_on_trial_test {
namespace {

TEST(ChangeOnTrial, IsKnownAfterAnotherStartAndDueThen) {
  const files::test::ScratchFolder folder;
  {
    ChangeOnTrial trial(folder / "trial");
    EXPECT_FALSE(trial.now());
    EXPECT_FALSE(trial.is_due(1'000'000));
    ASSERT_TRUE(trial.set({"00000012", 500, "credit is \"도\" now."}));
  }
  ChangeOnTrial again(folder / "trial");
  ASSERT_TRUE(again.now());
  EXPECT_EQ(again.now()->revision, "00000012");
  EXPECT_EQ(again.now()->what, "credit is \"도\" now.");
  EXPECT_FALSE(again.is_due(499));
  EXPECT_TRUE(again.is_due(500));
  again.end();
  EXPECT_FALSE(ChangeOnTrial(folder / "trial").now());
}

TEST(ChangeOnTrial, IsNoneWhereItsFileIsDamagedOrCannotBeWritten) {
  const files::test::ScratchFolder folder;
  for (const char* text : {"", "{", "[]", "{\"revision\": 5, \"until\": 5, \"what\": \"\"}",
                           "{\"revision\": \"5\", \"until\": \"5\", \"what\": \"\"}"}) {
    std::ofstream(folder / "trial") << text;
    EXPECT_FALSE(ChangeOnTrial(folder / "trial").now()) << text;
  }
  ChangeOnTrial none(folder / "no/folder/trial");
  EXPECT_FALSE(none.set({"00000012", 500, ""}));
  EXPECT_FALSE(none.now());
}

}  // namespace
}  // namespace onggi::console::change_on_trial_test
