#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kiosk/exhibit/editing/edit.h"
#include "tests/kiosk/exhibit/editing/small_site.h"

// Whole tables: effects of a scene, and elements of a list.
namespace onggi::editing::edit_tables_test {
namespace {

using namespace test;
using changes::Change;
using changes::kNewTable;
using ::testing::HasSubstr;

const fs::path kScene = "config/scenes/studio.toml", kMissions = "content/missions.toml";

TEST(edit_tables, an_effect_is_added_with_what_it_needs_and_undone_to_the_byte) {
  const SmallSite site;
  const std::string before = content(site / "config/scenes/first_touch.toml");
  const fs::path scene = site / "config/scenes/first_touch.toml";
  const auto alone = set_values(scene, {{"slump", kNewTable}});
  ASSERT_FALSE(alone);
  EXPECT_THAT(to_text(alone.error()), HasSubstr("slump needs volume"));
  EXPECT_EQ(content(scene), before);
  const auto done = set_values(
      scene, {{"slump", kNewTable}, {"volume", kNewTable}, {"slump.yield_stress", "7000"}});
  ASSERT_TRUE(done) << to_text(done.error());
  EXPECT_EQ(content(scene), before + "\n[slump]\nyield_stress = 7000\n\n[volume]\n");
  EXPECT_EQ(change_words(done->revision.values.at(0)), "slump was added.");
  ASSERT_TRUE(undo(site.exhibit()));
  EXPECT_EQ(content(scene), before);
}

TEST(edit_tables, an_effect_that_was_taken_out_comes_back_though_a_hand_changed_the_file) {
  const SmallSite site;
  const std::string before = content(site / kScene);
  ASSERT_TRUE(set_values(site / kScene, {{"moisture", std::nullopt}}));
  EXPECT_EQ(content(site / kScene).find("[moisture]"), std::string::npos);
  site.by_hand(kScene, "rows = 600", "rows = 500");
  const auto undone = undo(site.exhibit());
  ASSERT_TRUE(undone) << to_text(undone.error());
  EXPECT_TRUE(undone->kept_others);
  EXPECT_THAT(content(site / kScene), HasSubstr("rows = 500"));
  EXPECT_THAT(content(site / kScene),
              HasSubstr("\n\n[moisture]\nwetting_time = 1.0             # s\n"));
}

TEST(edit_tables, an_effect_that_was_added_goes_though_a_hand_changed_the_file_elsewhere) {
  const SmallSite site;
  const std::string before = content(site / kScene);
  ASSERT_TRUE(set_values(site / kScene, {{"wobble", kNewTable}, {"wobble.off_centre", "0.002"}}));
  site.by_hand(kScene, "rows = 600", "rows = 500");
  ASSERT_TRUE(undo(site.exhibit()));
  EXPECT_EQ(content(site / kScene), replaced(before, "rows = 600", "rows = 500"));

  ASSERT_TRUE(set_values(site / kScene, {{"wobble", kNewTable}}));
  site.by_hand(kScene, "[wobble]\n", "[wobble]\n\n[springback]\n");
  ASSERT_TRUE(undo(site.exhibit()));
  EXPECT_TRUE(content(site / kScene).ends_with("\n\n[springback]\n"));

  ASSERT_TRUE(set_values(site / kScene, {{"wobble", kNewTable}}));
  site.by_hand(kScene, "[wobble]\n", "[wobble]\nreach = 0.02\n");
  const std::string now = content(site / kScene);
  const auto refused = undo(site.exhibit());  // the hand's line would be lost
  ASSERT_FALSE(refused);
  EXPECT_THAT(to_text(refused.error()), HasSubstr("changed by hand"));
  EXPECT_EQ(content(site / kScene), now);
}

TEST(edit_tables, a_mission_is_added_and_taken_out) {
  const SmallSite site;
  const std::string before = content(site / kMissions);
  const auto unfinished = set_values(site / kMissions, {{"mission.cups", kNewTable}});
  ASSERT_FALSE(unfinished);
  EXPECT_EQ(content(site / kMissions), before);
  const auto done = set_values(site / kMissions, {{"mission.cups", kNewTable},
                                                  {"mission.cups.kind", "describe"},
                                                  {"mission.cups.litres", "0.2"},
                                                  {"mission.cups.title.en", "A cup"},
                                                  {"mission.cups.title.ko", "잔"},
                                                  {"mission.cups.about.en", "Of 0.2 litres."},
                                                  {"mission.cups.about.ko", "0.2리터."}});
  ASSERT_TRUE(done) << to_text(done.error());
  EXPECT_THAT(content(site / kMissions), HasSubstr("\n[[mission]]\nid = \"cups\"\n"));
  ASSERT_TRUE(set_values(site / kMissions, {{"mission.cups", std::nullopt}}));
  EXPECT_EQ(content(site / kMissions), before);
  for (int n = 0; n < 2; ++n) ASSERT_TRUE(undo(site.exhibit()));
  EXPECT_EQ(content(site / kMissions), before);
}

}  // namespace
}  // namespace onggi::editing::edit_tables_test
