#include "kiosk/ground/toml/ascii_toml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "kiosk/ground/toml/toml_reader.h"
#include "kiosk/ground/toml/toml_text.h"

namespace onggi::toml::ascii_toml_test {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

TomlReader read(const std::string& text) { return TomlReader::of_text(text, "pot.toml"); }

TEST(AsciiToml, what_toml_asks_of_every_letter_is_asked_of_ascii_alone) {
  // Each reached code of toml++ that says it cannot be reached: a value that a quote follows, and
  // an escape that is none.
  for (const std::string bad :
       {"a = 1\"ö\"\n", "a = 12'ö'\n", "a = -x\"ö\"\n", "a = 1.5mm\"ö\"\n", "a = 2026-\"é\"\n",
        "a = 07:32:00[\"ö\"\n", "a = [1-\"ö\"]\n", "a = \"\"\"\\ö\"\"\"\n",
        "a = \"\"\"x\\ ö\"\"\"\n", "a = \"\\ö\"\n", "a = 'ö\n", "a = \"ö\n"}) {
    TomlReader reader = read(bad);
    ASSERT_THAT(reader.problems(), SizeIs(1)) << bad;
    EXPECT_THAT(reader.problems()[0].where, HasSubstr("pot.toml:")) << bad;
  }
}

TEST(AsciiToml, bytes_that_are_not_utf_8_are_refused_wherever_they_stand) {
  for (const std::string bytes : {"\xE0\x81\x81", "\xF0\x80\x81\x81", "\xE0\x80\x80", "\xC0\xAF",
                                  "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF8\x88", "\xFF", "\xC3"})
    for (const std::string& text :
         {"a = \"" + bytes + "\"\n", "a = '" + bytes + "'\n", "# " + bytes + "\n",
          "a = \"\"\"x\\\n" + bytes + "\"\"\"\n", bytes + " = 1\n"}) {
      TomlReader reader = read(text);
      ASSERT_THAT(reader.problems(), SizeIs(1)) << text;
      EXPECT_EQ(reader.problems()[0].what, "The bytes here are not UTF-8.") << text;
    }
}

TEST(AsciiToml, the_first_mistake_is_told_and_places_count_letters_as_they_are_written) {
  const auto where = [](const std::string& text) {
    TomlReader reader = read(text);
    EXPECT_THAT(reader.problems(), SizeIs(1)) << text;
    return reader.problems().empty() ? "" : reader.problems()[0].where;
  };
  EXPECT_EQ(where("x = 1\na = @@\ngröße = 1\n"), "pot.toml:2:5");
  EXPECT_EQ(where("a = \"Onggi\ngröße = 1\n"), "pot.toml:1:11");
  EXPECT_EQ(where("a = [\n1,\nö]\nb = @@\n"), "pot.toml:3:1") << "an open list is no mistake";
  EXPECT_EQ(where("\xEF\xBB\xBFö = 1\n"), "pot.toml:1:1") << "a byte order mark is no letter";
  EXPECT_EQ(where("'größe \\ \"oh\"' = @@\n"), "pot.toml:1:18");
  EXPECT_EQ(where("\"größe\" = @@ # ö\n"), "pot.toml:1:11");
  EXPECT_EQ(where("a = \"\"\"ö\n  öö\"\"\" @\n"), "pot.toml:2:9");
}

TEST(AsciiToml, a_letter_outside_quotes_is_told_with_what_to_type_instead) {
  const auto remedy = [](const std::string& text) {
    TomlReader reader = read(text);
    EXPECT_THAT(reader.problems(), SizeIs(1)) << text;
    return reader.problems().empty() ? "" : reader.problems()[0].remedy;
  };
  EXPECT_THAT(remedy("a =\u00A0\"Onggi\"\n"), HasSubstr("plain space"));
  EXPECT_THAT(remedy("a\u200B = 1\n"), HasSubstr("plain space"));
  EXPECT_THAT(remedy("a = \u201COnggi\u201D\n"), HasSubstr("plain quotation marks"));
  EXPECT_THAT(remedy("a = \u201360\n"), HasSubstr("plain minus"));
  EXPECT_THAT(remedy("a = 60 µs\n"), HasSubstr("without its unit"));
}

TEST(AsciiToml, a_file_of_escapes_as_large_as_may_be_is_read) {
  std::string text = "a = \"\"\"";
  while (text.size() < kLargestToml - 100) text += "\\\"";
  TomlReader reader = read(text + "\"\"\"\n");
  std::string read;
  EXPECT_TRUE(reader.root().text("a", read));
  EXPECT_GT(read.size(), kLargestToml / 2 - 100);
  EXPECT_EQ(read.find_first_not_of('"'), std::string::npos);
}

TEST(AsciiToml, any_letters_in_any_kind_of_string_come_back_as_they_were_written) {
  static const char* const kLetters[] = {"a", " ",      "'",  "\\",   "\"", "#",
                                         "ö", "\u00A0", "あ", "🏺", ".",  "U"};
  EXPECT_TRUE(rc::check([](const std::vector<std::uint8_t>& picks) {
    std::string text, escaped, literal;
    for (const std::uint8_t pick : picks) {
      const std::string letter = kLetters[pick % std::size(kLetters)];
      text += letter;
      escaped += letter == "\\" || letter == "\"" ? "\\" + letter : letter;
      literal += letter == "'" ? "ö" : letter;  // which has no way to say an apostrophe
    }
    TomlReader reader = TomlReader::of_text("a = \"" + escaped + "\" # ö\nb = '" + literal +
                                                "'\nc = \"\"\"\n" + escaped + "\"\"\"\nd = '''\n" +
                                                literal + "'''\n\"" + escaped + "ö\" = 7\n",
                                            "pot.toml");
    RC_ASSERT(reader.problems().empty());
    std::string a, b, c, d;
    int e = 0;
    auto root = reader.root();
    RC_ASSERT(root.text("a", a));
    RC_ASSERT(root.text("b", b));
    RC_ASSERT(root.text("c", c));
    RC_ASSERT(root.text("d", d));
    RC_ASSERT(root.integer(text + "ö", e, 0, 9));
    RC_ASSERT(a == text);
    RC_ASSERT(b == literal);
    RC_ASSERT(c == text);
    RC_ASSERT(d == literal);
    RC_ASSERT(e == 7);
  }));
}

}  // namespace
}  // namespace onggi::toml::ascii_toml_test
