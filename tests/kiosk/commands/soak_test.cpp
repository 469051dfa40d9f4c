#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "tests/kiosk/commands/program.h"

namespace onggi::commands {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

TEST(Soak, TwoVisitsInAnHourOfTheMuseumsTakeSecondsAndTouchNothingButTheirOwnFolder) {
  const TemporaryFolder folder;
  const std::string before = text_of("config/exhibit.toml");
  ASSERT_FALSE(before.empty());
  const Outcome soak =
      onggi("soak --hours 1 --visits-an-hour 2 --window 320x240 --out '" +
            (folder / "soak").string() + "' --json '" + (folder / "soak.json").string() + "'");
  const std::string json = text_of(folder / "soak.json");
  EXPECT_THAT(json, HasSubstr("\"visits\": 2,")) << soak.err;
  EXPECT_THAT(json, HasSubstr("\"kept\": 2,")) << soak.err;
  EXPECT_THAT(json, HasSubstr("\"dead_ends\": 0,")) << soak.err;
  EXPECT_EQ(text_of("config/exhibit.toml"), before);
  EXPECT_TRUE(fs::exists(folder / "soak/keepsakes/onggi.sqlite"));
  // Two days and times of the museum's, an hour's half apart.
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder / "soak/keepsakes"))
    if (fs::exists(entry.path() / "pot.glb")) names.insert(entry.path().filename().string());
  ASSERT_EQ(names.size(), 2u);
  const auto minute = [](const std::string& name) {
    return std::stoi(name.substr(11, 2)) * 60 + std::stoi(name.substr(13, 2));
  };
  EXPECT_NEAR((minute(*names.rbegin()) - minute(*names.begin()) + 1440) % 1440, 30, 4);
}

}  // namespace
}  // namespace onggi::commands
