#include "kiosk/collection/content/model.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/engine/profile/shapes.h"

namespace onggi::content {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::vector<std::byte> out;
  for (std::istreambuf_iterator<char> c(in), end; c != end; ++c)
    out.push_back(static_cast<std::byte>(*c));
  return out;
}

TEST(Model, every_vessel_on_the_shelf_is_what_its_drawing_makes_byte_for_byte) {
  int vessels = 0;
  for (const auto& pack : fs::directory_iterator("content/vessels")) {
    if (!pack.is_directory()) continue;
    const auto drawing = read_drawing(pack.path() / "profile.toml");
    ASSERT_TRUE(drawing) << to_text(drawing.error());
    // Not EXPECT_EQ: it would print half a million bytes.
    EXPECT_TRUE(make_glb(*drawing) == read(pack.path() / "vessel.glb"))
        << pack.path() << ": make it again with 'onggi vessel make profile.toml -o vessel.glb'";
    ++vessels;
  }
  EXPECT_GE(vessels, 8);
}

TEST(Model, a_thinned_vessel_is_watertight_and_holds_the_same_clay) {
  for (const char* id : {"moon_jar", "tea_bowl", "meiping"}) {
    const auto drawing = read_drawing(std::string("content/vessels/") + id + "/profile.toml");
    ASSERT_TRUE(drawing) << to_text(drawing.error());
    const TriangleMesh fine = revolve(drawing->section, 96), thin = turned(*drawing);
    EXPECT_EQ(shapes::open_edges(thin), 0) << id;
    EXPECT_LT(thin.triangles.size(), 20000u) << id;
    EXPECT_NEAR(shapes::volume(thin), shapes::volume(fine), 0.01 * shapes::volume(fine)) << id;
  }
}

TEST(Model, straight_walls_lose_no_corner) {
  Drawing box;
  box.section.outline = {{0, 0}, {0.05, 0}, {0.05, 0.1}, {0.045, 0.1}, {0.045, 0.005}, {0, 0.005}};
  EXPECT_EQ(turned(box).positions.size(), revolve(box.section, 96).positions.size());
}

TEST(Model, a_drawing_without_a_section_makes_an_empty_mesh) {
  EXPECT_TRUE(turned(Drawing{}).triangles.empty());
}

}  // namespace
}  // namespace onggi::content
