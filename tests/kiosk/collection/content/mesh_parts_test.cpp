#include "kiosk/collection/content/mesh_parts.h"

#include <gtest/gtest.h>

namespace onggi::content::mesh_parts_test {
namespace {

std::vector<MeshPart> two_parts() {
  MeshPart jar, lid;
  jar.name = "jar";
  jar.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  jar.triangles = {{0, 1, 2}, {0, 2, 3}};
  jar.colors = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {250, 251, 252}};
  lid.positions = {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  lid.triangles = {{2, 1, 0}};
  return {jar, lid};
}

TEST(MeshParts, come_back_as_they_were_told) {
  const auto back = parts_of(parts_bytes(two_parts()), "a.obj");
  ASSERT_TRUE(back) << to_text(back.error());
  ASSERT_EQ(back->size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ((*back)[i].name, two_parts()[i].name);
    EXPECT_EQ((*back)[i].positions, two_parts()[i].positions);
    EXPECT_EQ((*back)[i].triangles, two_parts()[i].triangles);
    EXPECT_EQ((*back)[i].colors, two_parts()[i].colors);
  }
}

TEST(MeshParts, an_answer_cut_short_or_too_long_is_none) {
  std::vector<std::byte> bytes = parts_bytes(two_parts());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto cut = parts_of(std::span(bytes).first(size), "a.obj");
    ASSERT_FALSE(cut) << size;
    EXPECT_EQ(cut.error().where, "a.obj");
  }
  bytes.push_back(std::byte{0});
  EXPECT_FALSE(parts_of(bytes, "a.obj"));
}

TEST(MeshParts, sizes_and_corners_that_are_not_there_are_refused_without_memory_for_them) {
  const std::vector<std::byte> good = parts_bytes(two_parts());
  for (std::size_t at = 4; at + 4 <= good.size(); at += 4) {
    std::vector<std::byte> bytes = good;
    for (std::size_t k = 0; k < 4; ++k) bytes[at + k] = std::byte{0xFF};
    const auto read = parts_of(bytes, "a.obj");
    if (!read) continue;
    for (const MeshPart& part : *read)
      for (const auto& t : part.triangles)
        for (const std::uint32_t corner : t) EXPECT_LT(corner, part.positions.size());
  }
  std::vector<MeshPart> wrong = two_parts();
  wrong[1].triangles[0][1] = 3;
  EXPECT_FALSE(parts_of(parts_bytes(wrong), "a.obj"));
  wrong = two_parts();
  wrong[0].colors.pop_back();
  EXPECT_FALSE(parts_of(parts_bytes(wrong), "a.obj")) << "a corner without its colour";
}

TEST(MeshParts, a_refusal_is_told_in_its_own_words) {
  const auto refused = parts_of(refusal_bytes("it has no faces."), "a.obj");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what, "it cannot be read: it has no faces.");
  EXPECT_FALSE(refused.error().remedy.empty());
}

}  // namespace
}  // namespace onggi::content::mesh_parts_test
