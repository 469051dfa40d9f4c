#include "kiosk/ground/toml/toml_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <regex>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::toml::toml_reader_test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class TomlReaderTest : public ::testing::Test {
 protected:
  fs::path write(const std::string& text) {
    const fs::path file = folder_ / "pot.toml";
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }
  const files::test::ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
};

TEST_F(TomlReaderTest, everything_that_is_written_rightly_is_read) {
  TomlReader reader(write(R"(
title = "달항아리"
rows = 400
height = 0.2
tall = 1
shown = true
names = ["rim", "foot"]
radii = [1, 2.5]
outer = [[30, 0, "corner"], [42.5, 12.0]]
[foot]
width = 6.0
[[part]]
name = "lid"
[[part]]
name = "body"
)"));
  ASSERT_TRUE(reader.ok());
  auto root = reader.root();
  std::string title;
  int rows = 0;
  double height = 0, tall = 0, width = 0;
  bool shown = false;
  std::vector<std::string> names;
  std::vector<double> radii;
  std::vector<OutlinePoint> outer;
  EXPECT_TRUE(root.text("title", title));
  EXPECT_TRUE(root.integer("rows", rows, 8, 20000));
  EXPECT_TRUE(root.number("height", height, 0.01, 1));
  EXPECT_TRUE(root.number("tall", tall, 0, 1)) << "a whole number is a number";
  EXPECT_TRUE(root.boolean("shown", shown));
  EXPECT_TRUE(root.texts("names", names));
  EXPECT_TRUE(root.numbers("radii", radii));
  EXPECT_TRUE(root.points("outer", outer));
  EXPECT_TRUE(root.child("foot").number("width", width, 0, 100, "mm"));
  std::vector<std::string> parts;
  for (auto& part : root.children("part")) {
    std::string name;
    EXPECT_TRUE(part.text("name", name));
    part.finish();
    parts.push_back(name);
  }
  root.child("foot").finish();
  root.finish();
  EXPECT_THAT(reader.problems(), IsEmpty());
  EXPECT_EQ(title, "달항아리");
  EXPECT_EQ(rows, 400);
  EXPECT_EQ(height, 0.2);
  EXPECT_EQ(tall, 1.0);
  EXPECT_TRUE(shown);
  EXPECT_THAT(names, ElementsAre("rim", "foot"));
  EXPECT_THAT(radii, ElementsAre(1.0, 2.5));
  EXPECT_THAT(outer, ElementsAre(OutlinePoint{30, 0, true}, OutlinePoint{42.5, 12, false}));
  EXPECT_EQ(width, 6.0);
  EXPECT_THAT(parts, ElementsAre("lid", "body"));
  EXPECT_EQ(reader.keys_checked(), 11);
  EXPECT_THAT(root.keys(), ElementsAre("title", "rows", "height", "tall", "shown", "names", "radii",
                                       "outer", "foot", "part"));
}

TEST_F(TomlReaderTest, a_wrong_type_is_told_in_plain_words_at_its_line_and_column) {
  const fs::path file = write("[idle]\nwarn_after = \"fast\"\n");
  TomlReader reader(file);
  double warn_after = 60;
  EXPECT_FALSE(reader.root().child("idle").number("warn_after", warn_after, 20, 3600, "s"));
  EXPECT_EQ(warn_after, 60) << "what was not good leaves the default alone";
  ASSERT_THAT(reader.problems(), SizeIs(1));
  EXPECT_EQ(reader.problems()[0].where, file.string() + ":2:14");
  EXPECT_EQ(reader.problems()[0].what,
            "idle.warn_after is the text \"fast\", but must be a number.");
  EXPECT_EQ(reader.problems()[0].remedy, "Write a number from 20 to 3600 s, without quotes.");
}

TEST_F(TomlReaderTest, a_range_is_told_with_its_unit) {
  TomlReader reader(write("a = 5\nb = 4000.5\nc = 99999999999\n"));
  auto root = reader.root();
  double number = 0;
  int whole = 0;
  EXPECT_FALSE(root.number("a", number, 20, 3600, "s"));
  EXPECT_FALSE(root.number("b", number, 20, 3600, "s"));
  EXPECT_FALSE(root.integer("c", whole, 8, 20000));
  ASSERT_THAT(reader.problems(), SizeIs(3));
  EXPECT_EQ(reader.problems()[0].what, "a is 5 s, but the smallest allowed value is 20 s.");
  EXPECT_EQ(reader.problems()[1].what, "b is 4000.5 s, but the largest allowed value is 3600 s.");
  EXPECT_EQ(reader.problems()[2].what, "c is 99999999999, but the largest allowed value is 20000.");
}

TEST_F(TomlReaderTest, nan_and_infinity_are_no_numbers) {
  TomlReader reader(write("a = nan\nb = inf\nc = [1.0, -inf]\n"));
  double number = 7;
  std::vector<double> numbers;
  EXPECT_FALSE(reader.root().number("a", number, 0, 1));
  EXPECT_FALSE(reader.root().number("b", number, 0, HUGE_VAL));
  EXPECT_FALSE(reader.root().numbers("c", numbers));
  EXPECT_THAT(reader.problems(), SizeIs(3));
  EXPECT_EQ(number, 7);
}

TEST_F(TomlReaderTest, a_misspelt_key_is_answered_with_the_nearest_right_one) {
  TomlReader reader(write("warn_aftr = 60\n"));
  double warn_after = 0, countdown = 0;
  auto root = reader.root();
  root.number("warn_after", warn_after, 20, 3600);
  root.number("countdown", countdown, 20, 300);
  root.finish();
  root.finish();  // says it once
  ASSERT_THAT(reader.problems(), SizeIs(1));
  EXPECT_THAT(reader.problems()[0].where, EndsWith(":1:1"));
  EXPECT_EQ(reader.problems()[0].what, "warn_aftr is not a key of this file.");
  EXPECT_EQ(reader.problems()[0].remedy, "Did you mean warn_after?");
}

TEST_F(TomlReaderTest, a_key_that_is_there_is_not_what_a_misspelt_one_means) {
  TomlReader reader(write("law = \"cut\"\n[haw]\nen = \"So.\"\n"));
  std::string law;
  auto root = reader.root();
  root.text("law", law);
  root.child("how");
  root.finish();
  ASSERT_THAT(reader.problems(), SizeIs(1));
  EXPECT_EQ(reader.problems()[0].remedy, "Did you mean how?");
}

TEST_F(TomlReaderTest, a_key_that_slipped_into_another_table_is_sent_back_to_its_own) {
  TomlReader reader(write("[idle]\nwarn_after = 60\ncredit = \"Museum\"\n"));
  std::string credit;
  double number = 0;
  auto root = reader.root();
  root.text("credit", credit);
  auto idle = root.child("idle");
  idle.number("warn_after", number, 20, 3600);
  idle.finish();
  root.finish();
  ASSERT_THAT(reader.problems(), SizeIs(1));
  EXPECT_EQ(reader.problems()[0].what, "idle.credit is not a key of this file.");
  EXPECT_EQ(reader.problems()[0].remedy, "Move it above the first [table].");
}

TEST_F(TomlReaderTest, problems_stand_in_the_order_of_the_file_however_they_were_found) {
  TomlReader reader(write("a = 1\nb = \"x\"\nwrong = 3\nd = true\n"));
  auto root = reader.root();
  double number = 0;
  root.number("d", number, 0, 1);
  root.finish();  // a, b and wrong
  root.require("e", "Write e.");
  std::vector<std::string> lines;
  for (const auto& p : reader.problems()) lines.push_back(p.where.substr(p.where.find(":")));
  EXPECT_THAT(lines, ElementsAre(":1:1", ":1:1", ":2:1", ":3:1", ":4:5"));
}

TEST_F(TomlReaderTest, each_bad_element_of_a_list_is_named_with_its_own_place) {
  TomlReader reader(
      write("outer = [\n  [30, 0],\n  [31],\n  [32, 4, \"sharp\"],\n  [33, \"x\"],\n]\n"));
  std::vector<OutlinePoint> outer;
  auto root = reader.root();
  EXPECT_FALSE(root.points("outer", outer));
  ASSERT_THAT(reader.problems(), SizeIs(3));
  EXPECT_THAT(reader.problems()[0].where, EndsWith(":3:3"));
  EXPECT_EQ(reader.problems()[0].what, "outer[1] is a list of 1, but must be a point.");
  EXPECT_THAT(reader.problems()[1].where, EndsWith(":4:11"));
  EXPECT_THAT(reader.problems()[2].where, EndsWith(":5:3"));
  root.complain_at("outer", 0, "The foot floats.", "Begin at height 0.");
  EXPECT_THAT(reader.problems()[0].where, EndsWith(":2:3"));
  EXPECT_EQ(reader.problems()[0].what, "The foot floats.");
}

TEST_F(TomlReaderTest, a_missing_key_is_named_at_its_table) {
  TomlReader reader(write("title = \"x\"\n\n[foot]\nwidth = 1\n"));
  auto foot = reader.root().child("foot");
  foot.require("height", "Write the foot's height in mm.");
  ASSERT_THAT(reader.problems(), SizeIs(1));
  EXPECT_THAT(reader.problems()[0].where, EndsWith(":3:1"));
  EXPECT_EQ(reader.problems()[0].what, "foot.height is missing.");
}

TEST_F(TomlReaderTest, an_absent_table_reads_nothing_and_is_no_fault) {
  TomlReader reader(write("title = \"x\"\n"));
  auto water = reader.root().child("water");
  double number = 3;
  EXPECT_FALSE(water.present());
  EXPECT_FALSE(water.number("drying_time", number, 0, 1));
  EXPECT_THAT(water.keys(), IsEmpty());
  water.finish();
  EXPECT_THAT(reader.problems(), IsEmpty());
  EXPECT_EQ(number, 3);
}

TEST_F(TomlReaderTest, a_value_where_a_table_belongs_is_told) {
  TomlReader reader(write("idle = 60\n"));
  EXPECT_FALSE(reader.root().child("idle").present());
  ASSERT_THAT(reader.problems(), SizeIs(1));
  EXPECT_EQ(reader.problems()[0].what, "idle is 60, but must be a table.");
}

TEST_F(TomlReaderTest, a_syntax_error_is_the_only_problem_and_shows_its_line) {
  TomlReader reader(write("credit = \"Museum\"\ntitle = Throw a pot\n"));
  EXPECT_FALSE(reader.ok());
  auto root = reader.root();
  std::string title;
  EXPECT_FALSE(root.text("title", title));
  root.require("title", "Write it.");
  root.finish();
  ASSERT_THAT(reader.problems(), SizeIs(1));
  EXPECT_THAT(reader.problems()[0].where, HasSubstr("pot.toml:2:"));
  EXPECT_THAT(reader.problems()[0].what, HasSubstr("in the line: title = Throw a pot"));
}

TEST_F(TomlReaderTest, a_byte_order_mark_and_windows_line_ends_are_read) {
  const fs::path file = write(
      "\xEF\xBB\xBF"
      "a = 1\r\nb = \"x\"\r\n");
  TomlReader reader(file);
  int a = 0;
  double b = 0;
  EXPECT_TRUE(reader.root().integer("a", a, 0, 9));
  EXPECT_FALSE(reader.root().number("b", b, 0, 9));
  ASSERT_THAT(reader.problems(), SizeIs(1));
  EXPECT_EQ(reader.problems()[0].where, file.string() + ":2:5");
}

TEST_F(TomlReaderTest, what_is_no_ordinary_file_is_refused_without_waiting) {
  const fs::path pipe = folder_ / "pipe.toml";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const fs::path& file : {pipe, folder_, folder_ / "absent.toml", fs::path("/dev/zero")}) {
    TomlReader reader(file);
    EXPECT_FALSE(reader.ok());
    ASSERT_THAT(reader.problems(), SizeIs(1)) << file;
    EXPECT_EQ(reader.problems()[0].where, file.string());
    EXPECT_FALSE(reader.problems()[0].remedy.empty());
  }
}

TEST_F(TomlReaderTest, a_file_over_four_mebibytes_is_refused) {
  TomlReader reader(write(std::string((4u << 20) + 1, '#')));
  ASSERT_THAT(reader.problems(), SizeIs(1));
  EXPECT_THAT(reader.problems()[0].what, HasSubstr("4 MiB"));
}

TEST_F(TomlReaderTest, utf_16_is_named_for_what_it_is) {
  TomlReader reader(
      write(std::string("\xFF\xFE"
                        "a\0=\0"
                        "1\0",
                        8)));
  ASSERT_THAT(reader.problems(), SizeIs(1));
  EXPECT_THAT(reader.problems()[0].what, HasSubstr("UTF-16"));
}

TEST_F(TomlReaderTest, nesting_that_would_overflow_the_stack_is_a_problem) {
  std::string dots = "a", brackets(100000, '['), tables = "a=", inner;
  for (int i = 0; i < 500000; ++i) dots += ".a";
  for (int i = 0; i < 50000; ++i) inner += "{a.b=";
  for (const std::string& text :
       {dots + " = 1\n", "[" + dots + "]\n", "x = " + brackets, tables + inner,
        "x = {a = \"\"\"b\"\"\"\", " + dots + " = 1}\n"}) {
    TomlReader reader(write(text));
    EXPECT_FALSE(reader.ok());
    ASSERT_THAT(reader.problems(), SizeIs(1));
    EXPECT_THAT(reader.problems()[0].where, HasSubstr("pot.toml:1:"));
  }
}

TEST_F(TomlReaderTest, a_table_without_a_name_is_a_problem_and_never_the_end) {
  for (const std::string text :
       {"[", "[\n", "[.]\n", "[[\n", "[!]\nk = 1\n", "[ ", "a.", "{", "a = {."}) {
    TomlReader reader(write(text));
    EXPECT_FALSE(reader.ok()) << text;
    ASSERT_THAT(reader.problems(), SizeIs(1));
    EXPECT_THAT(reader.problems()[0].where, HasSubstr("pot.toml:1:")) << text;
  }
}

TEST_F(TomlReaderTest, letters_beyond_ascii_are_welcome_in_texts_and_a_problem_outside_quotes) {
  TomlReader good(write("a = \"größe 。\"\n\"größe\" = \"\"\"one \\\n  é あ\"\"\"\n"));
  EXPECT_TRUE(good.ok());
  std::string text;
  EXPECT_TRUE(good.root().text("größe", text));
  EXPECT_EQ(text, "one é あ");
  for (const std::string bad : {"größe = 3\n", "é = 1\n", "a = é\n", "μ = 2\n", "a = 1 é\n"}) {
    TomlReader reader(write(bad));
    ASSERT_THAT(reader.problems(), SizeIs(1)) << bad;
    EXPECT_THAT(reader.problems()[0].where, HasSubstr("pot.toml:1:"));
  }
}

TEST_F(TomlReaderTest, a_letter_outside_quotes_is_told_with_its_place_and_line) {
  TomlReader reader(write("\xEF\xBB\xBF# größe\na = \"ö\" # é\nb = [\"é\", ö]\n"));
  ASSERT_THAT(reader.problems(), SizeIs(1));
  EXPECT_THAT(reader.problems()[0].where, HasSubstr("pot.toml:3:11"));
  EXPECT_THAT(reader.problems()[0].what, HasSubstr("b = [\"é\", ö]"));
  EXPECT_THAT(reader.problems()[0].remedy, HasSubstr("\"quotation marks\""));
}

TEST_F(TomlReaderTest, every_letter_may_follow_a_line_end_that_is_escaped) {
  // Each that toml++ looks up in its table of spaces, and one of 61 of all others.
  for (std::uint32_t point = 0xA0; point < 0x10FFFF; point += point < 0x4A0 ? 1 : 61) {
    if (point >= 0xD800 && point < 0xE000) continue;
    const int more = point < 0x800 ? 1 : point < 0x10000 ? 2 : 3;  // bytes after the first
    std::string letter(1, static_cast<char>(0xFF << (7 - more) | point >> 6 * more));
    for (int at = more - 1; at >= 0; --at)
      letter += static_cast<char>(0x80 | (point >> 6 * at & 0x3F));
    const std::string quoted =
        "\"\"\"\\\r\n\n \t" + letter + letter + "\\\\\n" + letter + "\"\"\"\n";
    const TomlReader reader = TomlReader::of_text("a = " + quoted + "b = 2\nb = 3\n", "pot.toml");
    ASSERT_THAT(reader.problems(), SizeIs(1));
    EXPECT_THAT(reader.problems()[0].where, HasSubstr("pot.toml:6:")) << point;
    TomlReader good = TomlReader::of_text("a = " + quoted, "pot.toml");
    std::string text;
    EXPECT_TRUE(good.root().text("a", text));
    EXPECT_EQ(text, letter + letter + "\\\n" + letter) << point;
  }
}

TEST_F(TomlReaderTest, points_in_prose_and_numbers_are_no_nesting) {
  std::string dots(400, '.');
  TomlReader reader(write("a = \"" + dots + "\"\nb = '''" + dots + "\n" + dots + "'''\n# " + dots +
                          "\nc = [" +
                          [] {
                            std::string list;
                            for (int i = 0; i < 400; ++i) list += "1.5, ";
                            return list;
                          }() +
                          "]\n"));
  EXPECT_TRUE(reader.ok()) << to_text(reader.problems().front());
}

TEST_F(TomlReaderTest, every_invalid_file_of_the_public_suite_gives_a_problem_with_a_line) {
  const fs::path suite = "../shared/malformed/toml/invalid";
  if (!fs::exists(suite)) GTEST_SKIP() << suite << " is not here";
  const std::regex with_line(R"(.*\.toml:\d+:\d+)");
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(suite)) {
    if (entry.path().extension() != ".toml") continue;
    ++files;
    TomlReader reader(entry.path());
    EXPECT_FALSE(reader.ok()) << entry.path() << " was accepted";
    if (reader.ok()) continue;
    ASSERT_THAT(reader.problems(), SizeIs(1)) << entry.path();
    const Problem& p = reader.problems()[0];
    EXPECT_TRUE(std::regex_match(p.where, with_line)) << p.where;
    EXPECT_FALSE(p.what.empty());
    EXPECT_FALSE(p.remedy.empty());
    for (const char c : p.what) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << p.where;
  }
  EXPECT_GT(files, 400);
}

TEST_F(TomlReaderTest, no_bytes_at_all_can_end_the_program) {
  EXPECT_TRUE(rc::check([this](const std::vector<std::string>& pieces) {
    static const char* const kTokens[] = {"[",  "]",    "{",      "}",   "=", ".", ",",
                                          "\"", "'",    "\"\"\"", "\n",  "a", "1", "\\",
                                          "#",  "\xff", "\xe2",   "1e9", "-"};
    std::string text;
    for (const auto& piece : pieces) {
      text += piece;
      text += kTokens[piece.size() % std::size(kTokens)];
    }
    TomlReader reader(write(text));
    RC_ASSERT(reader.ok() == reader.problems().empty());
    reader.root().finish();
  }));
}

}  // namespace
}  // namespace onggi::toml::toml_reader_test
