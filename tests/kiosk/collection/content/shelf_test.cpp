#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "engine/profile/measures.h"
#include "kiosk/collection/content/catalogue.h"
#include "kiosk/collection/content/drawing.h"
#include "kiosk/collection/content/model.h"
#include "kiosk/ground/toml/toml_reader.h"
#include "tests/kiosk/ground/files/scratch_folder.h"
#include "tests/support/open_shelf.h"

// The shelf that Onggi comes with, as the kiosk opens it. What its packs say is in
// shelf_packs_test.cpp, and that each GLB is what its drawing makes in model_test.cpp.

namespace onggi::content::shelf_test {
namespace {

namespace fs = std::filesystem;

const fs::path kShelf = "content/vessels";

const OpenedShelf& shelf() {
  static const OpenedShelf catalogue = open_shelf(kShelf);
  return catalogue;
}

double published(const std::string& id, const char* key) {
  toml::TomlReader reader(kShelf / id / "vessel.toml");
  double value = 0.0;
  reader.root().number(key, value, 1.0, 2000.0);
  return value / 1000.0;
}

TEST(Shelf, every_pack_opens_and_has_nothing_to_put_right) {
  for (const Problem& p : shelf().problems) ADD_FAILURE() << to_text(p);
  for (const Problem& p : check_shelf(kShelf).problems) ADD_FAILURE() << to_text(p);
  std::size_t folders = 0;
  for (const auto& entry : fs::directory_iterator(kShelf)) folders += entry.is_directory() ? 1 : 0;
  EXPECT_EQ(shelf().vessels.size(), folders);
}

TEST(Shelf, a_decoration_that_was_never_baked_into_the_model_is_told) {
  const files::test::ScratchFolder scratch;
  fs::copy(kShelf / "onggi", scratch.path() / "onggi", fs::copy_options::recursive);
  EXPECT_TRUE(check_shelf(scratch.path()).problems.empty());
  const auto drawing = read_drawing((kShelf / "onggi" / "profile.toml").string());
  ASSERT_TRUE(drawing);
  const std::vector<std::byte> plain = make_glb(*drawing);
  std::ofstream(scratch.path() / "onggi" / "vessel.glb", std::ios::binary)
      .write(reinterpret_cast<const char*>(plain.data()),
             static_cast<std::streamsize>(plain.size()));
  const auto problems = check_shelf(scratch.path()).problems;
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].what.find("no picture"), std::string::npos) << to_text(problems[0]);
}

TEST(Shelf, every_vessel_carries_a_label_of_its_own_in_each_language) {
  for (const Vessel& v : shelf().vessels) {
    EXPECT_GE(v.labels.size(), 5u) << v.id;
    std::set<std::string> texts;
    for (const auto& [code, label] : v.labels) {
      EXPECT_FALSE(label.text.empty()) << v.id << " " << code;
      EXPECT_TRUE(texts.insert(label.text).second) << v.id << " " << code;
      EXPECT_EQ(v.label(code).text, label.text) << v.id << " " << code;
    }
  }
}

TEST(Shelf, the_scored_profile_has_the_published_height_and_diameter) {
  for (const Vessel& v : shelf().vessels) {
    const Dimensions d = dimensions(v.extracted.profile);
    const double height = published(v.id, "true_height_mm");
    const double diameter = published(v.id, "true_diameter_mm");
    EXPECT_NEAR(d.height, height, 0.01 * height) << v.id;
    EXPECT_NEAR(d.belly, diameter, 0.01 * diameter) << v.id;
    EXPECT_EQ(v.true_height, height) << v.id;
  }
}

TEST(Shelf, every_wall_was_seen_and_none_was_inferred) {
  for (const Vessel& v : shelf().vessels) {
    EXPECT_EQ(v.extracted.profile.inner_wall, InnerWall::measured) << v.id;
    EXPECT_TRUE(v.extracted.warnings.empty()) << v.id << ": " << v.extracted.warnings[0];
    EXPECT_GT(v.extracted.symmetry, 0.99) << v.id;
  }
}

TEST(Shelf, a_finger_fits_through_every_neck_at_the_size_it_is_played) {
  // Scaled into 200 mm of height and 220 mm of width, a sphere of 8 mm radius must pass.
  for (const Vessel& v : shelf().vessels) {
    const Profile& p = v.extracted.profile;
    const double scale = std::min(0.200 / p.height(), 0.220 / (2.0 * p.max_radius()));
    for (const ProfilePoint& point : p.points) {
      if (point.height < 0.5 * p.height()) continue;
      EXPECT_GT(scale * point.inner, 0.009) << v.id << " at " << point.height;
    }
  }
}

}  // namespace
}  // namespace onggi::content::shelf_test
