#include <gtest/gtest.h>

#include <cstring>

#include "kiosk/content/glb.h"
#include "tests/engine/profile/shapes.h"

namespace onggi::content {
namespace {

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

}  // namespace
}  // namespace onggi::content
