#include "kiosk/lab/measure/measurement_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace onggi::measure::measurement_folder_test {
namespace {

namespace fs = std::filesystem;

TEST(MeasurementFolder, AFolderOfItsOwnIsThereWhileItLivesAndGoneWithAllInItAfterwards) {
  fs::path was;
  {
    auto made = MeasurementFolder::make();
    ASSERT_TRUE(made);
    const MeasurementFolder mine = std::move(*made);
    was = mine.path();
    ASSERT_TRUE(fs::is_directory(was));
    EXPECT_NE(MeasurementFolder::make()->path(), was);
    std::ofstream(was / "onggi.sqlite") << "a visit";
  }
  EXPECT_FALSE(fs::exists(was));
}

TEST(MeasurementFolder, WhereNoneCanBeMadeThatIsSaidAndNothingIsCountedElsewhere) {
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("TMPDIR", "/nowhere/at/all", 1);
  const auto made = MeasurementFolder::make();
  before != nullptr ? ::setenv("TMPDIR", kept.c_str(), 1) : ::unsetenv("TMPDIR");
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().exit_code, 1);
}

}  // namespace
}  // namespace onggi::measure::measurement_folder_test
