#include "kiosk/ground/toml/written_twice.h"

#include <gtest/gtest.h>

#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::toml::written_twice_test {
namespace {

Problem fault(const std::string& text) {
  const TomlReader reader = TomlReader::of_text(text, "way.toml");
  EXPECT_EQ(reader.problems().size(), 1u);
  return reader.problems().empty() ? Problem{} : reader.problems()[0];
}

TEST(WrittenTwice, a_key_tells_both_of_its_lines) {
  const Problem found = fault("a = 1\nb = 2\n# no name\na = 3\n");
  EXPECT_EQ(found.where.substr(0, 11), "way.toml:4:");
  EXPECT_EQ(found.what, "\"a\" is written twice: it stands in line 1, too.");
  EXPECT_EQ(found.remedy, "Remove one of the two.");
}

TEST(WrittenTwice, a_table_tells_both_of_its_lines) {
  const Problem found = fault("[a]\nx = 1\n[b]\nx = 1\n[a]\ny = 1\n");
  EXPECT_EQ(found.where.substr(0, 11), "way.toml:5:");
  EXPECT_EQ(found.what, "\"a\" is written twice: it stands in line 1, too.");
  EXPECT_EQ(found.remedy, "Remove one of the two.");
}

// What is left where a line [[tool]] was deleted: its keys fall into the table above.
TEST(WrittenTwice, a_forgotten_list_line_is_asked_for) {
  const char* remedy =
      "If a new part of the list begins here, write [[tool]] on a line of its own above the part's "
      "first line. Else remove one of the two.";
  Problem found = fault(
      "[[tool]]\nid = \"a\"\n[tool.name]\nen = \"A\"\n\nid = \"b\"\n[tool.name]\nen = \"B\"\n");
  EXPECT_EQ(found.where.substr(0, 11), "way.toml:7:");
  EXPECT_EQ(found.what, "\"tool.name\" is written twice: it stands in line 3, too.");
  EXPECT_EQ(found.remedy, remedy);

  found = fault("[[tool]]\nid = \"a\"\n\nid = \"b\"\n");
  EXPECT_EQ(found.what, "\"id\" is written twice: it stands in line 2, too.");
  EXPECT_EQ(found.remedy, remedy);

  found =
      fault("[name]\nen = \"way\"\nid = \"a\"\n[tool.name]\nen = \"A\"\n[[tool]]\nid = \"b\"\n");
  EXPECT_EQ(found.where.substr(0, 11), "way.toml:6:");
  EXPECT_EQ(
      found.what,
      "[[tool]] begins a part of a list, but \"tool\" is already something else: see line 4.");
  EXPECT_EQ(found.remedy, "Write [[tool]] on a line of its own above the first part, too.");
}

TEST(WrittenTwice, the_same_key_of_another_table_is_not_the_first) {
  const Problem found = fault("[[step]]\nat = 1\n[other]\nat = { x = 1, x = 2 }\n");
  EXPECT_EQ(found.what, "\"x\" is written twice.");
  EXPECT_EQ(found.remedy, "Remove one of the two.");
}

TEST(WrittenTwice, another_fault_is_none) {
  EXPECT_FALSE(written_twice("expected '=', saw 'b'", "a b\n", 1));
  EXPECT_NE(fault("a b\n").what.find("cannot be read as TOML"), std::string::npos);
}

}  // namespace
}  // namespace onggi::toml::written_twice_test
