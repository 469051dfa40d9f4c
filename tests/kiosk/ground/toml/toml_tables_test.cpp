#include "kiosk/ground/toml/toml_tables.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "kiosk/ground/toml/toml_reader.h"
#include "kiosk/ground/toml/toml_text.h"

namespace onggi::toml::toml_tables_test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const Result<TableSpliced>& done) {
  return done ? done->text : to_text(done.error());
}
std::string with(const std::string& text, const Path& path) {
  return text_of(with_table(text, path, "a.toml"));
}
std::string without(const std::string& text, const Path& path) {
  return text_of(without_table(text, path, "a.toml"));
}

TEST(toml_tables, a_table_is_added_at_the_end_and_every_other_byte_stays) {
  EXPECT_EQ(with("a = 1 # one\n", {"t"}), "a = 1 # one\n\n[t]\n");
  EXPECT_EQ(with("a = 1", {"t"}), "a = 1\n\n[t]\n");
  EXPECT_EQ(with("a = 1\r\n", {"t"}), "a = 1\r\n\r\n[t]\r\n");
  EXPECT_EQ(with("", {"t"}), "[t]\n");
  EXPECT_EQ(with("[t]\nb = 2\n", {"t"}), "[t]\nb = 2\n");
  EXPECT_EQ(with("t.b = 2\n", {"t"}), "t.b = 2\n");
}

TEST(toml_tables, an_element_is_added_behind_the_others_with_its_id) {
  EXPECT_EQ(text_of(with_element("[[m]]\nid = \"a\"\n", {"m"}, "b", "a.toml")),
            "[[m]]\nid = \"a\"\n\n[[m]]\nid = \"b\"\n");
  EXPECT_EQ(text_of(with_element("", {"m"}, "b", "a.toml")), "[[m]]\nid = \"b\"\n");
}

TEST(toml_tables, a_table_goes_with_its_comment_and_what_is_within_it) {
  EXPECT_EQ(without("# file\n\n[a]\nx = 1\n\n# of t\n[t]\ny = 2 # why\n\n[t.u]\nz = 3\n\n# of b\n"
                    "[b]\nw = 4\n",
                    {"t"}),
            "# file\n\n[a]\nx = 1\n\n# of b\n[b]\nw = 4\n");
  EXPECT_EQ(without("# of the file\n[t]\ny = 2\n\n[b]\n", {"t"}), "# of the file\n[b]\n");
  EXPECT_EQ(without("[a]\nx = 1\n\n[t]\ny = 2\n", {"t"}), "[a]\nx = 1\n");
  EXPECT_EQ(without("[a]\r\nx = 1\r\n\r\n[t]\r\n", {"t"}), "[a]\r\nx = 1\r\n");
  EXPECT_EQ(without("[a]\nx = 1\n", {"t"}), "[a]\nx = 1\n");
  EXPECT_EQ(without("[t]\n# [b] is no header\ns = \"\"\"\n[b]\n# x\"\"\"\n[b]\n", {"t"}), "[b]\n");
}

TEST(toml_tables, an_element_goes_and_its_neighbours_stay) {
  const std::string three =
      "[[m]]\nid = \"a\"\n[m.w]\nen = \"A\"\n\n# second\n[[m]]\nid = \"b\"\n[m.w]\nen = \"B\"\n\n"
      "# third\n[[m]]\nid = \"c\"\n";
  EXPECT_EQ(without(three, {"m", "2"}),
            "[[m]]\nid = \"a\"\n[m.w]\nen = \"A\"\n\n# third\n[[m]]\nid = \"c\"\n");
  EXPECT_EQ(without(three, {"m", "3"}),
            "[[m]]\nid = \"a\"\n[m.w]\nen = \"A\"\n\n# second\n[[m]]\nid = \"b\"\n[m.w]\nen = "
            "\"B\"\n");
  EXPECT_EQ(without("[[m]]\nid = \"a\"\n", {"m", "1"}), "");
  EXPECT_EQ(without(three, {"m", "4"}), three);
}

TEST(toml_tables, what_cannot_be_is_refused_with_a_remedy) {
  for (const std::string& said :
       {with("t = 1\n", {"t"}), with("[[t]]\n", {"t"}), without("t = 1\n", {"t"}),
        without("t = { a = 1 }\n", {"t"}), without("t.a = 1\n", {"t"}),
        text_of(with_element("m = []\n", {"m"}, "b", "a.toml")), with("a =\n", {"t"})})
    EXPECT_TRUE(said.starts_with("a.toml")) << said;
}

TEST(toml_tables, every_table_of_the_shipped_files_can_be_taken_out_and_is_whole_again) {
  constexpr std::uintmax_t kLargest = 12000;  // bytes: the others take minutes
  int taken = 0;
  for (const char* folder : {"config", "content"})
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().extension() != ".toml" || entry.file_size() > kLargest) continue;
      const auto text = read_toml_text(entry.path());
      ASSERT_TRUE(text);
      const TomlPlaces places(*text);
      for (const TomlPlaces::Header& header : places.headers()) {
        if (header.path.empty()) continue;
        const auto out = without_table(*text, header.path, entry.path().string());
        ASSERT_TRUE(out) << to_text(out.error());
        EXPECT_LT(out->text.size(), text->size());
        EXPECT_FALSE(out->text.find("\n\n\n") != std::string::npos &&
                     text->find("\n\n\n") == std::string::npos);
        ++taken;
      }
    }
  EXPECT_GT(taken, 200);
}

}  // namespace
}  // namespace onggi::toml::toml_tables_test
