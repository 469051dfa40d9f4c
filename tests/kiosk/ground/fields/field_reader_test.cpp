#include "kiosk/ground/fields/field_reader.h"

#include <gtest/gtest.h>

namespace onggi::fields::field_reader_test {
namespace {

const FieldList kTwo{
    "a.toml",
    {{.table = "", .key = "share", .kind = FieldKind::number, .words = "a", .most = 0.5},
     {.table = "", .key = "delay", .kind = FieldKind::whole, .words = "b", .least = 2, .most = 8}}};

TEST(field_reader, takes_what_is_within_the_fields_range_and_notes_what_is_not) {
  toml::TomlReader good = toml::TomlReader::of_text("share = 0.5\ndelay = 2\n", "a.toml");
  auto root = good.root();
  double share = 0;
  int delay = 0;
  EXPECT_TRUE(read_number(root, field_at(kTwo, "", "share"), share));
  EXPECT_TRUE(read_whole(root, field_at(kTwo, "", "delay"), delay));
  EXPECT_EQ(share, 0.5);
  EXPECT_EQ(delay, 2);
  toml::TomlReader bad = toml::TomlReader::of_text("share = 0.6\ndelay = 1\n", "a.toml");
  root = bad.root();
  EXPECT_FALSE(read_number(root, field_at(kTwo, "", "share"), share));
  EXPECT_FALSE(read_whole(root, field_at(kTwo, "", "delay"), delay));
  EXPECT_EQ(bad.problems().size(), 2u);
  EXPECT_EQ(share, 0.5);
  EXPECT_EQ(delay, 2);
}

TEST(field_reader, of_a_field_that_no_list_has_ends_the_program) {
  EXPECT_DEATH(field_at(kTwo, "", "shrae"), "");
}

}  // namespace
}  // namespace onggi::fields::field_reader_test
