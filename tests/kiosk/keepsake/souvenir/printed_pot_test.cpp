#include "kiosk/keepsake/souvenir/printed_pot.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "engine/profile/mesh.h"
#include "kiosk/collection/content/glb.h"
#include "tests/engine/profile/shapes.h"
#include "tests/kiosk/keepsake/souvenir/relief_file_on_disk.h"

namespace onggi::souvenir::printed_pot_test {
namespace {

namespace fs = std::filesystem;

/// A visit's folder with a model and, where it was decorated, its relief.
class PrintedPotTest : public ::testing::Test {
 protected:
  PrintedPotTest() {
    const TriangleMesh pot = revolve(section_of(shapes::jar()), 48);
    glb_ = content::write_glb(pot, "My pot", "", {{0, {}}}, {}, 2);
    put(kPotGlb, glb_);
    plain_ = triangles();
  }
  void put(const char* name, std::span<const std::byte> bytes) {
    std::ofstream(visit_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
  std::uint32_t mark() const { return mark_of_model(glb_, glb_.size()); }
  /// The triangles of its STL, and what is told of it: "" nothing.
  std::size_t triangles() {
    const auto made = stl_of_visit(visit_);
    told_ = made && made->remark ? to_text(*made->remark) : "";
    return made ? (made->bytes.size() - 84) / 50 : 0;
  }

  files::test::ScratchFolder scratch_;
  fs::path visit_ = scratch_.path();
  std::vector<std::byte> glb_;
  std::string told_;
  std::size_t plain_ = 0;
};

TEST_F(PrintedPotTest, a_pot_that_was_not_decorated_is_its_model) {
  EXPECT_GT(triangles(), 1000u);
  EXPECT_EQ(told_, "");
  const auto none = stl_of_visit(visit_ / "no");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().exit_code, 2);
}

TEST_F(PrintedPotTest, a_decorated_pot_is_its_relief) {
  put(kRelief, test::rough_relief(mark()));
  EXPECT_EQ(triangles(), 24u * (47 * 16 + 2 * 8));
  EXPECT_EQ(told_, "");
}

TEST_F(PrintedPotTest, where_the_relief_is_damaged_anywhere_the_model_is_given_and_a_line_says_so) {
  const auto good = test::rough_relief(mark());
  for (const std::size_t at : {std::size_t{0}, std::size_t{30}, good.size() / 2, good.size() - 1}) {
    auto bad = good;
    bad[at] ^= std::byte{0x10};
    put(kRelief, bad);
    EXPECT_EQ(triangles(), plain_) << at;
    EXPECT_EQ(told_, (visit_ / kRelief).string() +
                         ": This relief of a pot is damaged.\n  Copy it from a backup, or remove "
                         "it. Until then the STL is made from pot.glb, without what was cut and "
                         "laid on.");
  }
}

TEST_F(PrintedPotTest, another_pots_relief_is_not_taken_and_a_line_says_so) {
  put(kRelief, test::rough_relief(mark() + 1));
  EXPECT_EQ(triangles(), plain_);
  EXPECT_NE(told_.find("relief.onggi: This is the relief of another pot."), std::string::npos)
      << told_;
}

TEST_F(PrintedPotTest, nobody_waits_for_a_pipe_nor_follows_a_link) {
  ASSERT_EQ(mkfifo((visit_ / kRelief).c_str(), 0600), 0);
  EXPECT_EQ(triangles(), plain_);
  EXPECT_NE(told_, "");
  fs::remove(visit_ / kRelief);
  put("elsewhere", test::rough_relief(mark()));
  fs::create_symlink(visit_ / "elsewhere", visit_ / kRelief);
  EXPECT_EQ(triangles(), plain_);
  fs::remove(visit_ / kPotGlb);
  ASSERT_EQ(mkfifo((visit_ / kPotGlb).c_str(), 0600), 0);
  EXPECT_FALSE(stl_of_visit(visit_));
}

}  // namespace
}  // namespace onggi::souvenir::printed_pot_test
