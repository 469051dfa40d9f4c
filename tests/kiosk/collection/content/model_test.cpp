#include "kiosk/collection/content/model.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "kiosk/collection/content/gltf.h"
#include "kiosk/collection/decoration/unrolled.h"
#include "kiosk/collection/textures/texture_decoder.h"
#include "tests/engine/profile/shapes.h"

namespace onggi::content::model_test {
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
    ++vessels;
    if (fs::exists(pack.path() / "decoration.toml")) continue;
    // Not EXPECT_EQ: it would print half a million bytes.
    EXPECT_TRUE(make_glb(*drawing) == read(pack.path() / "vessel.glb"))
        << pack.path() << ": make it again with 'onggi vessel make profile.toml -o vessel.glb'";
  }
  EXPECT_GE(vessels, 12);
}

// The bytes of a PNG depend on who packs it; its pixels do not.
TEST(Model, every_decorated_vessel_is_what_its_decoration_makes_pixel_for_pixel) {
  int vessels = 0;
  for (const auto& pack : fs::directory_iterator("content/vessels")) {
    const fs::path file = pack.path() / "decoration.toml";
    if (!fs::exists(file)) continue;
    ++vessels;
    const auto drawing = read_drawing(pack.path() / "profile.toml");
    const auto decoration = decoration::read_decoration(file);
    ASSERT_TRUE(drawing && decoration) << file;
    const auto surface = decorated(*drawing, *decoration, file.string());
    ASSERT_TRUE(surface) << to_text(surface.error());
    const auto model = read_gltf(pack.path() / "vessel.glb");
    ASSERT_TRUE(model) << to_text(model.error());
    ASSERT_EQ(model->coloring.pictures.size(), 1u) << file;
    const textures::TexturePixels& kept = *model->coloring.pictures[0].pixels;
    const decoration::Unrolled colors = decoration::unrolled(*surface, *decoration);
    textures::TexturePixels made{colors.width, colors.height, {}};
    for (std::size_t n = 0; n < colors.rgba.size(); ++n)
      if (n % 4 != 3) made.rgb.push_back(colors.rgba[n]);
    // As the kiosk reads it. Not EXPECT_EQ: it would print a million numbers.
    EXPECT_TRUE(kept == textures::shrunk(std::move(made), 1024))
        << file
        << ": make it again with 'onggi vessel make profile.toml --decoration "
           "decoration.toml -o vessel.glb'";
    const auto skin = decoration::placed(turned(*drawing), drawing->section, *surface);
    EXPECT_EQ(model->mesh.positions, skin.mesh.positions) << file;
  }
  EXPECT_GE(vessels, 5);
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
}  // namespace onggi::content::model_test
