#include "kiosk/ground/toml/stand_in.h"

#include <gtest/gtest.h>

#include <fstream>

#include "kiosk/ground/toml/toml_reader.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::toml::stand_in_test {
namespace {

int value_in(const std::filesystem::path& file) {
  TomlReader reader(file);
  int value = -1;
  reader.root().integer("a", value, 0, 100);
  return value;
}

TEST(stand_in, is_read_by_every_name_of_its_file_while_it_lives_and_no_longer) {
  const files::test::ScratchFolder folder;
  std::ofstream(folder / "a.toml") << "a = 1\n";
  std::ofstream(folder / "b.toml") << "a = 2\n";
  std::filesystem::create_symlink("a.toml", folder / "link.toml");
  {
    const StandIn change(folder / "a.toml", "a = 46\n");
    EXPECT_EQ(value_in(folder / "b.toml"), 2);
    EXPECT_FALSE(change.was_read());
    EXPECT_EQ(value_in(folder / "a.toml"), 46);
    EXPECT_TRUE(change.was_read());
    EXPECT_EQ(value_in(folder / "." / "link.toml"), 46);
    EXPECT_EQ(value_in(folder / "b.toml"), 2);
    EXPECT_EQ(value_in(folder / "c.toml"), -1);
  }
  EXPECT_EQ(value_in(folder / "a.toml"), 1);
}

}  // namespace
}  // namespace onggi::toml::stand_in_test
