#include "kiosk/ground/toml/toml_splice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "kiosk/ground/toml/toml_reader.h"
#include "tests/kiosk/ground/files/scratch_folder.h"
#include "tests/kiosk/ground/toml/real_files.h"

namespace onggi::toml::toml_splice_test {
namespace {

using files::test::content;

/// `text` with `value` at `key`, or why not.
std::string set(const std::string& text, const std::string& key, const std::string& value) {
  const Result<Spliced> done = with_value(text, path_of(key), value, "a.toml");
  return done ? done->text : to_text(done.error());
}

TEST(toml_splice, a_value_is_replaced_and_every_other_byte_stays) {
  EXPECT_EQ(set("# top\n[idle]\nwarn_after = 60   # s\ncountdown=25\n", "idle.warn_after", "90"),
            "# top\n[idle]\nwarn_after = 90   # s\ncountdown=25\n");
  EXPECT_EQ(set("\xEF\xBB\xBF"
                "a = \"x\"\r\nb = 2\r\n",
                "a", "\"y\""),
            "\xEF\xBB\xBF"
            "a = \"y\"\r\nb = 2\r\n");
  EXPECT_EQ(set("a = [\n  1, # one\n]\nb = true", "a", "[2]"), "a = [2]\nb = true");
  EXPECT_EQ(set("a = true", "a", "false"), "a = false");
  EXPECT_EQ(set("t = { en = \"a\", ko = \"나\" }  # 말\n", "t.ko", "\"다\""),
            "t = { en = \"a\", ko = \"다\" }  # 말\n");
  EXPECT_EQ(set("a.b.c = 1\n", "a.b.c", "2"), "a.b.c = 2\n");
  EXPECT_EQ(set("[h]\n\"12-25\" = \"closed\"\n", "h.12-25", "\"10:00-12:00\""),
            "[h]\n\"12-25\" = \"10:00-12:00\"\n");
  EXPECT_EQ(set("a = '''x\ny'''\nb = 1", "a", "\"z\""), "a = \"z\"\nb = 1");
}

TEST(toml_splice, an_absent_key_stands_behind_the_last_one_of_its_table) {
  EXPECT_EQ(set("a = 1\n\n[t]\nb = 2  # two\n\n# of u\n[u]\nc = 3\n", "t.d", "4"),
            "a = 1\n\n[t]\nb = 2  # two\nd = 4\n\n# of u\n[u]\nc = 3\n");
  EXPECT_EQ(set("a = 1\n\n[t]\nb = 2\n", "d", "4"), "a = 1\nd = 4\n\n[t]\nb = 2\n");
  EXPECT_EQ(set("[t]\n\n[u]\nc = 3\n", "t.d", "4"), "[t]\nd = 4\n\n[u]\nc = 3\n");
  EXPECT_EQ(set("# of the file\n\n[t]\nb = 2\n", "d", "4"), "# of the file\nd = 4\n\n[t]\nb = 2\n");
  EXPECT_EQ(set("[t]\r\nb = 2\r\n", "t.d", "4"), "[t]\r\nb = 2\r\nd = 4\r\n");
  EXPECT_EQ(set("[t]\nb = 2", "t.d", "4"), "[t]\nb = 2\nd = 4");
  EXPECT_EQ(set("[t]", "t.d", "4"), "[t]\nd = 4");
  EXPECT_EQ(set("", "d", "4"), "d = 4\n");
  EXPECT_EQ(set("\xEF\xBB\xBF", "d", "4"),
            "\xEF\xBB\xBF"
            "d = 4\n");
  EXPECT_EQ(set("b = [\n 1,\n]\n", "d", "4"), "b = [\n 1,\n]\nd = 4\n");
}

TEST(toml_splice, an_absent_key_stands_behind_the_comment_that_shows_it) {
  EXPECT_EQ(set("[t]\na = 1\n# d = 7   # an example\nb = 2\n", "t.d", "4"),
            "[t]\na = 1\n# d = 7   # an example\nd = 4\nb = 2\n");
  EXPECT_EQ(set("[t]\na = 1\n# d = 7", "t.d", "4"), "[t]\na = 1\n# d = 7\nd = 4");
  // Another key, another table, and words in a text are no example of it.
  EXPECT_EQ(set("[t]\n# dd = 7\na = \"\"\"\n# d = 7\n\"\"\"\n[u]\n# d = 7\n", "t.d", "4"),
            "[t]\n# dd = 7\na = \"\"\"\n# d = 7\n\"\"\"\nd = 4\n[u]\n# d = 7\n");
}

TEST(toml_splice, an_absent_key_of_a_table_in_one_line_stands_in_it) {
  EXPECT_EQ(set("t = { en = \"a\" }  # c\n", "t.ko", "\"b\""),
            "t = { en = \"a\", ko = \"b\" }  # c\n");
  EXPECT_EQ(set("t = {}\n", "t.ko", "\"b\""), "t = { ko = \"b\" }\n");
  EXPECT_EQ(set("t = { a = { b = 1 } }\n", "t.a.c", "2"), "t = { a = { b = 1, c = 2 } }\n");
  EXPECT_EQ(set("t = { a = 1 }\n", "t.b.c", "2"), "t = { a = 1, b.c = 2 }\n");
}

TEST(toml_splice, an_absent_table_is_written_at_the_end) {
  EXPECT_EQ(set("a = 1\n", "t.d", "4"), "a = 1\n\n[t]\nd = 4\n");
  EXPECT_EQ(set("a = 1\r\n", "t.d", "4"), "a = 1\r\n\r\n[t]\r\nd = 4\r\n");
  EXPECT_EQ(set("a = 1", "t.u.d", "4"), "a = 1\n\n[t.u]\nd = 4");
  EXPECT_EQ(set("t.a = 1\nb = 2\n", "t.d", "4"), "t.a = 1\nt.d = 4\nb = 2\n");
}

TEST(toml_splice, an_element_of_a_list_is_meant_by_its_number) {
  const std::string text = "[[s]]\nid = \"a\"\nx = 1\n[s.words]\nen = \"A\"\n\n[[s]]\nid = \"b\"\n";
  EXPECT_EQ(set(text, "s.1.x", "9"),
            "[[s]]\nid = \"a\"\nx = 9\n[s.words]\nen = \"A\"\n\n[[s]]\nid = \"b\"\n");
  EXPECT_EQ(set(text, "s.2.x", "9"), text + "x = 9\n");
  EXPECT_EQ(set(text, "s.1.words.ko", "\"K\""),
            "[[s]]\nid = \"a\"\nx = 1\n[s.words]\nen = \"A\"\nko = \"K\"\n\n[[s]]\nid = \"b\"\n");
  EXPECT_EQ(set(text, "s.2.words.en", "\"B\""), text + "words.en = \"B\"\n");
}

/// `text` without the value at `key`, or why not.
std::string without(const std::string& text, const std::string& key) {
  const Result<Spliced> done = without_value(text, path_of(key), "a.toml");
  return done ? done->text : to_text(done.error());
}

TEST(toml_splice, a_value_is_taken_out_with_its_comment_and_an_empty_table) {
  EXPECT_EQ(without("# top\n[t]\na = 1  # one\nb = 2\n", "t.a"), "# top\n[t]\nb = 2\n");
  EXPECT_EQ(without("a = [\n 1,\n]\nb = 2", "a"), "b = 2");
  EXPECT_EQ(without("a = 1\nb = 2", "b"), "a = 1\n");
  EXPECT_EQ(without("a = 1\r\n\r\n[t]\r\nd = 4\r\n", "t.d"), "a = 1\r\n");
  EXPECT_EQ(without("a = 1\n\n[t]\n# of d\nd = 4\n[u]\ne = 5\n", "t.d"),
            "a = 1\n# of d\n[u]\ne = 5\n");
  EXPECT_EQ(without("[t]\nd = 4\n\n[t.u]\ne = 5\n", "t.d"), "\n[t.u]\ne = 5\n");
  EXPECT_EQ(without("t.a = 1\nb = 2\n", "t.a"), "b = 2\n");
  EXPECT_EQ(without("[[s]]\na = 1\n[[s]]\nb = 2\n", "s.1.a"), "[[s]]\n[[s]]\nb = 2\n");
  EXPECT_EQ(without("\xEF\xBB\xBF"
                    "a = 1\nb = 2\n",
                    "a"),
            "\xEF\xBB\xBF"
            "b = 2\n");
  EXPECT_EQ(without("a = 1\n", "b"), "a = 1\n");
  EXPECT_NE(without("t = { a = 1, b = 2 }\n", "t.a").find("cannot be taken out"),
            std::string::npos);
  EXPECT_NE(without("a = \n", "a").find("cannot be read as TOML"), std::string::npos);
}

TEST(toml_splice, what_cannot_stand_there_is_refused_in_words) {
  const auto refused = [](const char* text, const char* key, const char* value, const char* why) {
    const Result<Spliced> done = with_value(text, path_of(key), value, "a.toml");
    ASSERT_FALSE(done) << text;
    EXPECT_NE(to_text(done.error()).find(why), std::string::npos) << to_text(done.error());
    EXPECT_EQ(done.error().exit_code, 2);
  };
  refused("a = 1\n", "a.b", "2", "cannot stand in this file");
  refused("t = { a = 1 }\n", "t", "2", "is a table, not a value");
  refused("[t]\na = 1\n", "t", "2", "cannot stand in this file");
  refused("[[s]]\na = 1\n", "s.2.a", "2", "cannot stand in this file");
  refused("[[s]]\na = 1\n", "s.a", "2", "cannot stand in this file");
  refused("a = 1\n", "a", "1\nb = 2", "not a value");
  refused("a = 1\n", "a", "1 # c", "not a value");
  refused("a = 1\n", "a", "1,5", "not a value");
  refused("a = 1\n", "a", "", "not a value");
  refused("a = \n", "a", "1", "cannot be read as TOML");
  refused("a = 1\n", "", "1", "No key");
}

TEST(toml_splice, keys_are_read_and_written_as_people_type_them) {
  EXPECT_EQ(path_of("idle.warn_after"), (Path{"idle", "warn_after"}));
  EXPECT_EQ(path_of("hours.exceptions.\"12-25\""), (Path{"hours", "exceptions", "12-25"}));
  EXPECT_EQ(path_of("a.\"b c\""), (Path{"a", "b c"}));
  for (const char* wrong : {"", "a b", ".a", "a.", "[a]", "a = 1", "a\nb", "größe"})
    EXPECT_EQ(path_of(wrong), Path{}) << wrong;
  EXPECT_EQ(key_text({"a", "12-25", "b c", "q\"q"}), "a.12-25.\"b c\".\"q\\\"q\"");
}

TEST(toml_splice, a_text_is_written_so_that_it_reads_back_the_same) {
  for (const std::string& text :
       {std::string("plain"), std::string("\"quotes\" and \\"), std::string("line\nline\ttab"),
        std::string("\x01\x7F\x1B["), std::string("도자기 “빚기”"), std::string()}) {
    TomlReader reader = TomlReader::of_text("v = " + quoted_text(text), "v");
    std::string back = "not read";
    ASSERT_TRUE(reader.ok() && reader.root().text("v", back)) << text;
    EXPECT_EQ(back, text);
    EXPECT_TRUE(is_value(quoted_text(text)));
  }
}

/// Another value of the same kind.
std::string another(const std::string& value, std::mt19937& random) {
  const std::string number = std::to_string(random() % 1000);
  switch (value[0]) {
    case '"':
    case '\'':
      return quoted_text("x" + number + " \"é\"");
    case '[':
      return "[" + number + "]";
    case 't':
      return "false";
    case 'f':
      return "true";
    default:
      return number + ".5";
  }
}

// Each value of each file: changed, nothing else is; put back, the file is the same.
TEST(toml_splice, every_value_that_ships_is_set_and_put_back_to_the_byte) {
  std::mt19937 random(46);
  int values = 0;
  for (const auto& file : test::real_files()) {
    const std::string text = content(file);
    const TomlPlaces places(text);
    // Texts of languages by the hundred are all alike.
    const std::size_t step = places.values().size() / 6 + 1;
    for (std::size_t n = random() % step; n < places.values().size(); n += step) {
      const TomlPlaces::Value& old = places.values()[n];
      if (old.kind == TomlPlaces::Kind::table) continue;
      const std::string was = text.substr(old.begin, old.end - old.begin);
      const std::string fresh = another(was, random);
      const auto there = with_value(text, old.path, fresh, file.string());
      ASSERT_TRUE(there) << file << key_text(old.path) << to_text(there.error());
      EXPECT_FALSE(there->added);
      EXPECT_EQ(there->text, text.substr(0, old.begin) + fresh + text.substr(old.end))
          << file << key_text(old.path);
      const auto back = with_value(there->text, old.path, was, file.string());
      ASSERT_TRUE(back) << file << key_text(old.path);
      EXPECT_EQ(back->text, text) << file << key_text(old.path);
      ++values;
    }
  }
  EXPECT_GT(values, 150);
}

// Each value of each file: taken out, its lines are gone and no others but its table's own.
TEST(toml_splice, every_value_that_ships_is_taken_out_and_nothing_else) {
  std::mt19937 random(47);
  int values = 0;
  for (const auto& file : test::real_files()) {
    const std::string text = content(file);
    const TomlPlaces places(text);
    const std::size_t step = places.values().size() / 6 + 1;
    for (std::size_t n = random() % step; n < places.values().size(); n += step) {
      const TomlPlaces::Value& old = places.values()[n];
      const bool in_braces = std::ranges::any_of(places.values(), [&](const auto& table) {
        return &table != &old && table.begin < old.begin && old.end < table.end;
      });
      const auto gone = without_value(text, old.path, file.string());
      ASSERT_EQ(gone.has_value(), !in_braces) << file << key_text(old.path);
      if (in_braces) continue;
      const TomlPlaces left(gone->text);
      EXPECT_EQ(left.value(old.path), nullptr) << file << key_text(old.path);
      for (const TomlPlaces::Value& other : places.values())
        if (other.begin < old.begin || other.begin > old.end) {
          const TomlPlaces::Value* there = left.value(other.path);
          ASSERT_NE(there, nullptr) << file << key_text(other.path);
          EXPECT_EQ(gone->text.substr(there->begin, there->end - there->begin),
                    text.substr(other.begin, other.end - other.begin));
        }
      ++values;
    }
  }
  EXPECT_GT(values, 150);
}

// A key added to each table of each file is there, and all that was there before still is.
TEST(toml_splice, a_key_is_added_to_every_table_that_ships) {
  int tables = 0;
  for (const auto& file : test::real_files()) {
    const std::string text = content(file);
    const TomlPlaces places(text);
    for (const TomlPlaces::Header& header : places.headers()) {
      if (header.path.size() > 1 && tables % 8 != 0) {
        ++tables;  // words of elements are all alike
        continue;
      }
      Path path = header.path;
      path.push_back("added_by_the_test");
      const auto done = with_value(text, path, "46", file.string());
      ASSERT_TRUE(done) << file << key_text(path) << to_text(done.error());
      EXPECT_TRUE(done->added);
      std::string without = done->text;
      without.erase(done->at, done->is.size());
      EXPECT_EQ(without, text) << file << key_text(path);
      EXPECT_NE(TomlPlaces(done->text).value(path), nullptr) << file << key_text(path);
      ++tables;
    }
  }
  EXPECT_GT(tables, 100);
}

}  // namespace
}  // namespace onggi::toml::toml_splice_test
