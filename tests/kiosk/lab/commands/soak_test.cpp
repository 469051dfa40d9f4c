#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/kiosk/program/commands/program.h"

namespace onggi::laboratory::soak_test {
namespace {

using namespace commands;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

TEST(Soak, HalfAnHourOfTheMuseumsTakesSecondsAndTouchesNothingButItsOwnFolder) {
  const ScratchFolder folder;
  const std::string before = commands::content("config/exhibit.toml");
  ASSERT_FALSE(before.empty());
  const Outcome soak =
      onggi("soak --hours 0.5 --visits-an-hour 2 --window 320x240 --out '" +
            (folder / "soak").string() + "' --json '" + (folder / "soak.json").string() + "'");
  const std::string json = commands::content(folder / "soak.json");
  EXPECT_THAT(json, HasSubstr("\"visits\": 1,")) << soak.err;
  EXPECT_THAT(json, HasSubstr("\"kept\": 1,")) << soak.err;
  EXPECT_THAT(json, HasSubstr("\"dead_ends\": 0,")) << soak.err;
  const auto figure = [&json](const std::string& name) {
    const auto at = json.find("\"" + name + "\": ");
    return at == std::string::npos ? -1.0 : std::stod(json.substr(at + name.size() + 4));
  };
  EXPECT_NEAR(figure("hours"), 0.5, 0.02);
  EXPECT_LT(figure("minutes"), 15.0) << "the time between visits is skipped";
  EXPECT_EQ(commands::content("config/exhibit.toml"), before);
  EXPECT_TRUE(fs::exists(folder / "soak/keepsakes/onggi.sqlite"));
  int kept = 0;
  for (const auto& entry : fs::directory_iterator(folder / "soak/keepsakes"))
    kept += fs::exists(entry.path() / "pot.glb");
  EXPECT_EQ(kept, 1);
}

}  // namespace
}  // namespace onggi::laboratory::soak_test
