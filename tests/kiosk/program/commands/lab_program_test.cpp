#include "kiosk/program/commands/lab_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace onggi::commands::lab_program_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Optional;

TEST(LabProgram, GetsTheWordsBehindLab) {
  EXPECT_THAT(words_for_laboratory({"lab", "accuracy", "--json", "a.json"}),
              Optional(ElementsAre("accuracy", "--json", "a.json")));
  EXPECT_THAT(words_for_laboratory({"lab", "accuracy", "--help"}),
              Optional(ElementsAre("accuracy", "--help")));
}

TEST(LabProgram, GetsASoakUnderItsOldName) {
  EXPECT_THAT(words_for_laboratory({"soak", "--hours", "72"}),
              Optional(ElementsAre("soak", "--hours", "72")));
}

TEST(LabProgram, GetsNothingThatAMuseumNeeds) {
  EXPECT_EQ(words_for_laboratory({}), std::nullopt);
  EXPECT_EQ(words_for_laboratory({"check"}), std::nullopt);
  EXPECT_EQ(words_for_laboratory({"lab"}), std::nullopt);
  EXPECT_EQ(words_for_laboratory({"lab", "--help"}), std::nullopt);
  EXPECT_EQ(words_for_laboratory({"visit", "lab"}), std::nullopt);
  EXPECT_EQ(words_for_laboratory({"lab", "tune", "--write", "studio.toml"}), std::nullopt);
  EXPECT_EQ(words_for_laboratory({"lab", "prices", "studio.toml"}), std::nullopt);
}

}  // namespace
}  // namespace onggi::commands::lab_program_test
