#include <gtest/gtest.h>

#include "kiosk/collection/content/coloring.h"
#include "kiosk/collection/content/gltf.h"
#include "tests/engine/profile/mean_shapes.h"
#include "tests/kiosk/collection/content/temporary.h"

#include <cstring>

#include "kiosk/collection/content/glb.h"
#include "tests/engine/profile/shapes.h"

namespace onggi::content::glb_test {
namespace {

class GlbFiles : public Temporary {};

std::uint32_t u32(const std::vector<std::byte>& bytes, std::size_t at) {
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

TEST(Glb, its_chunks_are_whole_and_aligned) {
  const auto glb = write_glb(revolve(section_of(shapes::jar()), 24), "Jar", "CC0");
  ASSERT_GT(glb.size(), 28u);
  EXPECT_EQ(u32(glb, 0), 0x46546C67u);
  EXPECT_EQ(u32(glb, 4), 2u);
  EXPECT_EQ(u32(glb, 8), glb.size());
  const std::uint32_t json = u32(glb, 12);
  EXPECT_EQ(json % 4, 0u);
  EXPECT_EQ(u32(glb, 20 + json) % 4, 0u);
  EXPECT_EQ(28 + json + u32(glb, 20 + json), glb.size());
}

TEST(Glb, the_same_mesh_gives_the_same_bytes) {
  const TriangleMesh mesh = revolve(section_of(shapes::bottle()), 24);
  EXPECT_EQ(write_glb(mesh, "Bottle", "CC0"), write_glb(mesh, "Bottle", "CC0"));
  EXPECT_NE(write_glb(mesh, "Bottle", "CC0"), write_glb(mesh, "Jug", "CC0"));
}

TEST(Glb, a_title_in_any_script_or_none_is_no_obstacle) {
  const TriangleMesh mesh = revolve(section_of(shapes::bowl()), 8);
  EXPECT_FALSE(write_glb(mesh, "달항아리 \"moon\" \n \xff", "").empty());
}

TEST_F(GlbFiles, colours_at_the_corners_come_back_as_the_light_they_were) {
  const TriangleMesh mesh = revolve(section_of(shapes::jar()), 24);
  std::vector<std::array<float, 3>> colors;
  for (const auto& p : mesh.positions) colors.push_back({0.5f, p[1] > 0.15f ? 0.002f : 1.0f, 0.0f});
  for (const bool normals : {true, false}) {
    TriangleMesh own = mesh;
    if (!normals) own.normals.clear();
    const auto bytes = write_glb(own, "jar", "", {.color = {1, 1, 1}}, colors);
    const auto model = read_gltf(
        write("jar.glb", std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size())));
    ASSERT_TRUE(model) << to_text(model.error());
    ASSERT_EQ(model->coloring.colors.size(), colors.size());
    const auto light = baked(model->coloring);
    for (std::size_t i = 0; i < colors.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(display_of(light[i][k]), display_of(colors[i][k])) << i;
  }
}

}  // namespace
}  // namespace onggi::content::glb_test
