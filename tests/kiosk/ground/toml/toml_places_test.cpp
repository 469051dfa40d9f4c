#include "kiosk/ground/toml/toml_places.h"

#include <gtest/gtest.h>

#include "kiosk/ground/toml/texts_of.h"
#include "tests/kiosk/ground/files/scratch_folder.h"
#include "tests/kiosk/ground/toml/real_files.h"

namespace onggi::toml::toml_places_test {
namespace {

using files::test::content;

/// The bytes of the value at `path`, or "none".
std::string bytes_at(const std::string& text, const Path& path) {
  const TomlPlaces places(text);
  const TomlPlaces::Value* value = places.value(path);
  return value == nullptr ? "none" : text.substr(value->begin, value->end - value->begin);
}

TEST(toml_places, a_value_ends_before_the_comment_behind_it) {
  EXPECT_EQ(bytes_at("a = 1   # one\nb = 2", {"a"}), "1");
  EXPECT_EQ(bytes_at("a = 1   # one\nb = 2", {"b"}), "2");
  EXPECT_EQ(bytes_at("a = 1979-05-27 07:32:00  # a date\r\n", {"a"}), "1979-05-27 07:32:00");
  EXPECT_EQ(bytes_at("a = \"# no comment\" # one", {"a"}), "\"# no comment\"");
}

TEST(toml_places, a_value_of_several_lines_is_one) {
  EXPECT_EQ(bytes_at("a = [1, # ] is in a comment\n  2,\n]\nb = 3", {"a"}),
            "[1, # ] is in a comment\n  2,\n]");
  EXPECT_EQ(bytes_at("a = [1,\n 2]\nb = 3", {"b"}), "3");
  EXPECT_EQ(bytes_at("a = \"\"\"one\n[no.table]\nb = 2\"\"\"\n[c]\nd = 4", {"a"}),
            "\"\"\"one\n[no.table]\nb = 2\"\"\"");
  EXPECT_EQ(bytes_at("a = \"\"\"one\n[no.table]\nb = 2\"\"\"\n[c]\nd = 4", {"c", "d"}), "4");
}

TEST(toml_places, names_with_points_and_quotes_and_tables_in_one_line_lead_to_their_values) {
  const std::string text =
      "a.b = 1\n[t.\"x y\"]\n'c'.d = 2\n\"12-25\" = \"closed\"\nin = { e = 3, f.g = [4], h = {} "
      "}\n";
  EXPECT_EQ(bytes_at(text, {"a", "b"}), "1");
  EXPECT_EQ(bytes_at(text, {"t", "x y", "c", "d"}), "2");
  EXPECT_EQ(bytes_at(text, {"t", "x y", "12-25"}), "\"closed\"");
  EXPECT_EQ(bytes_at(text, {"t", "x y", "in", "e"}), "3");
  EXPECT_EQ(bytes_at(text, {"t", "x y", "in", "f", "g"}), "[4]");
  EXPECT_EQ(bytes_at(text, {"t", "x y", "in", "h"}), "{}");
  EXPECT_EQ(bytes_at(text, {"t", "in", "e"}), "none");
}

TEST(toml_places, an_element_of_a_list_of_tables_has_its_number) {
  const std::string text =
      "[[step]]\nid = \"a\"\n[step.words]\nen = 1\n[[step]]\nid = \"b\"\n[step.words]\nen = 2\n"
      "[other]\nlist = [{ x = 5 }, { x = 6 }]\n";
  EXPECT_EQ(TomlPlaces(text).elements({"step"}), 2u);
  EXPECT_EQ(bytes_at(text, {"step", "1", "words", "en"}), "1");
  EXPECT_EQ(bytes_at(text, {"step", "2", "words", "en"}), "2");
  EXPECT_EQ(bytes_at(text, {"step", "2", "id"}), "\"b\"");
  EXPECT_EQ(bytes_at(text, {"other", "list", "2", "x"}), "6");
  EXPECT_EQ(TomlPlaces(text).elements({"other", "list"}), 2u);
  EXPECT_EQ(TomlPlaces(text).elements({"other"}), 0u);
}

// toml++ is the second witness: it tells the line and column of every text.
TEST(toml_places, every_text_of_every_file_that_ships_begins_where_toml_says) {
  int texts = 0;
  for (const auto& file : test::real_files()) {
    const std::string text = content(file);
    const TomlPlaces places(text);
    std::vector<std::string> wheres;
    for (const TextAt& at : texts_of(file)) wheres.push_back(at.where);
    for (const TomlPlaces::Value& value : places.values()) {
      if (text[value.begin] != '"' && text[value.begin] != '\'') continue;
      const auto line_begin = text.rfind('\n', value.begin) + 1;
      std::size_t column = 1;
      for (std::size_t n = line_begin; n < value.begin; ++n)
        if ((static_cast<unsigned char>(text[n]) & 0xC0) != 0x80) ++column;
      const auto line =
          std::count(text.begin(), text.begin() + static_cast<long>(value.begin), '\n');
      const std::string where =
          file.string() + ":" + std::to_string(line + 1) + ":" + std::to_string(column);
      EXPECT_NE(std::find(wheres.begin(), wheres.end(), where), wheres.end()) << where;
      ++texts;
    }
  }
  EXPECT_GT(texts, 1000);
}

TEST(toml_places, what_is_no_toml_is_read_to_its_end) {
  for (const char* text :
       {"[", "[[", "a", "a =", "=", "a = [", "a = {", "a = \"", "]", "}", "a = [}", "[a",
        "a..b = 1", "\xEF\xBB\xBF", "a = {b", "'", "# x", "a = [[[{{{"})
    for (const TomlPlaces places(text); const TomlPlaces::Value& value : places.values()) {
      EXPECT_LE(value.begin, value.end) << text;
      EXPECT_LE(value.end, std::string_view(text).size()) << text;
    }
  const std::string deep = "a = " + std::string(100'000, '[');
  EXPECT_LE(TomlPlaces(deep).values().size(), 200u);
}

}  // namespace
}  // namespace onggi::toml::toml_places_test
