#include "kiosk/keepsake/souvenir/small_pot.h"

#include <gtest/gtest.h>

#include "kiosk/ground/files/clock_jump.h"
#include "kiosk/keepsake/souvenir/keepsake.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::souvenir::small_pot_test {
namespace {

namespace fs = std::filesystem;
using files::test::ScratchFolder;

std::time_t at(const char* stamp) { return *files::time_of_stamp(stamp); }

void put(const fs::path& folder, const std::string& text = "moon_jar\n4\n") {
  fs::create_directories(folder);
  std::ofstream(folder / kSmall) << "a picture";
  std::ofstream(folder / kShown) << text;
}

std::vector<std::string> names(const std::vector<KeptPot>& pots) {
  std::vector<std::string> all;
  for (const KeptPot& pot : pots) all.push_back(pot.visit);
  return all;
}

TEST(SmallPot, OnlyTodaysAreThereTheNewestFirst) {
  const ScratchFolder scratch;
  for (const char* name :
       {"2026-05-03_235959_jar", "2026-05-04_000000_jar", "2026-05-04_141503_jar",
        "2026-05-04_141503_jar_2", "2026-05-05_000000_jar"})
    put(scratch.path() / name);
  using Names = std::vector<std::string>;
  const auto on = [&](const char* stamp, std::size_t most = 99) {
    return names(pots_of_today(scratch.path(), at(stamp), most));
  };
  EXPECT_EQ(on("2026-05-04_150000"),
            (Names{"2026-05-04_141503_jar_2", "2026-05-04_141503_jar", "2026-05-04_000000_jar"}));
  EXPECT_EQ(on("2026-05-04_150000", 1), Names{"2026-05-04_141503_jar_2"});
  // Midnight passes.
  EXPECT_EQ(on("2026-05-03_235959"), Names{"2026-05-03_235959_jar"});
  EXPECT_EQ(on("2026-05-05_000000"), Names{"2026-05-05_000000_jar"});
  EXPECT_EQ(on("2026-05-06_000000"), Names{});
}

TEST(SmallPot, WhatIsHalfThereOrNoneOfOursIsLeftOut) {
  const ScratchFolder scratch;
  const std::time_t now = at("2026-05-04_150000");
  const fs::path good = scratch.path() / "2026-05-04_120000_jar";
  put(good);
  put(scratch.path() / "2026-05-04_120001_jar.partial");
  put(scratch.path() / "2026-05-04_120002_no stars", "moon_jar\n");
  put(scratch.path() / "2026-05-04_120002_stars", "moon_jar\nmany\n");
  put(scratch.path() / "2026-05-04_120003_stars", "moon_jar\n6\n");
  put(scratch.path() / "2026-05-04_120004_vessel", "\n3\n");
  put(scratch.path() / "2026-05-04_120005_long", std::string(100000, 'x') + "\n3\n");
  put(scratch.path() / "2026-05-04_120006_picture");
  fs::remove(scratch.path() / "2026-05-04_120006_picture" / kSmall);
  put(scratch.path() / "elsewhere");
  fs::create_directory(scratch.path() / "2026-05-04_120007_link");
  fs::create_symlink(scratch.path() / "elsewhere" / kSmall,
                     scratch.path() / "2026-05-04_120007_link" / kSmall);
  fs::create_symlink(scratch.path() / "elsewhere" / kShown,
                     scratch.path() / "2026-05-04_120007_link" / kShown);
  const auto pots = pots_of_today(scratch.path(), now, 99);
  ASSERT_EQ(names(pots), std::vector<std::string>{good.filename()});
  EXPECT_EQ(pots[0].vessel, "moon_jar");
  EXPECT_EQ(pots[0].stars, 4);
  const auto picture = picture_of(scratch.path(), pots[0]);
  ASSERT_TRUE(picture);
  EXPECT_EQ(std::string(picture->begin(), picture->end()), "a picture");
  fs::remove_all(good);
  EXPECT_FALSE(picture_of(scratch.path(), pots[0]));
  EXPECT_TRUE(pots_of_today(scratch.path() / "no such folder", now, 99).empty());
}

TEST(SmallPot, APictureThatIsWrittenAnewHasAnotherRevision) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "2026-05-04_120000_jar";
  put(folder);
  const auto before = pots_of_today(scratch.path(), at("2026-05-04_150000"), 9);
  std::ofstream(folder / kSmall) << "another";
  const auto after = pots_of_today(scratch.path(), at("2026-05-04_150000"), 9);
  ASSERT_TRUE(before.size() == 1 && after.size() == 1);
  EXPECT_NE(before[0].revision, after[0].revision);
}

TEST(SmallPot, AKeepsakeIsFoundAsItWasKeptAndGoesWithItsFolder) {
  const ScratchFolder scratch;
  Keepsake keepsake;
  keepsake.name = "2026-05-04_141503_moon_jar";
  keepsake.postcard = {2, 2, std::vector<std::uint8_t>(16, 200)};
  keepsake.small = SmallPot{{4, 5, std::vector<std::uint8_t>(80, 90)}, "moon_jar", 3};
  const auto kept = save(keepsake, scratch.path(), {100, 0});
  ASSERT_TRUE(kept) << (kept ? "" : to_text(kept.error()));
  const std::time_t now = at("2026-05-04_150000");
  const auto pots = pots_of_today(scratch.path(), now, 9);
  ASSERT_EQ(pots.size(), 1u);
  EXPECT_EQ(pots[0].vessel, "moon_jar");
  EXPECT_EQ(pots[0].stars, 3);
  EXPECT_TRUE(picture_of(scratch.path(), pots[0]));
  // Its files are known for our own: the visit expires as every other does.
  ASSERT_TRUE(tidy(scratch.path(), {100, 30}, "", at("2026-07-04_150000")));
  EXPECT_FALSE(fs::exists(kept->folder));

  keepsake.small.reset();
  ASSERT_TRUE(save(keepsake, scratch.path(), {100, 0}));
  EXPECT_TRUE(pots_of_today(scratch.path(), now, 9).empty()) << "where a curator shows none";
}

}  // namespace
}  // namespace onggi::souvenir::small_pot_test
