#include "kiosk/exhibit/editing/file_fields.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <sstream>

#include "kiosk/exhibit/composition/check_exhibit.h"
#include "kiosk/exhibit/editing/edit.h"
#include "kiosk/ground/toml/toml_splice.h"
#include "tests/kiosk/exhibit/editing/small_site.h"
#include "tests/kiosk/ground/fields/page_tables.h"
#include "tests/kiosk/ground/toml/real_files.h"

namespace onggi::editing::file_fields_test {
namespace {

using namespace test;
using fields::FieldKind;

/// The path without the numbers of elements.
toml::Path names_of(const toml::TomlPlaces& places, const toml::Path& path) {
  toml::Path out, so_far;
  for (const std::string& part : path) {
    if (places.elements(so_far) == 0) out.push_back(part);
    so_far.push_back(part);
  }
  return out;
}

TEST(file_fields, have_a_list_for_each_kind_that_curators_set_and_words_for_each_key) {
  EXPECT_EQ(field_lists().size(), 7u);
  std::size_t keys = 0;
  for (const fields::FieldList* list : field_lists()) {
    SCOPED_TRACE(list->file);
    fields::test::expect_whole(*list);
    keys += list->fields.size();
  }
  EXPECT_GE(keys, 200u);
}

TEST(file_fields, have_every_key_of_every_file_that_ships) {
  std::set<std::string> kinds;
  int keys = 0;
  for (const fs::path& file : toml::test::real_files()) {
    const fields::FieldList* list = fields_of(exhibit::kind_of_toml(file));
    if (list == nullptr) continue;
    kinds.insert(list->file);
    const toml::TomlPlaces places(content(file));
    for (const toml::TomlPlaces::Value& value : places.values()) {
      if (value.kind == toml::TomlPlaces::Kind::table) continue;
      EXPECT_NE(fields::find_field(*list, names_of(places, value.path)), nullptr)
          << file << " " << toml::key_text(value.path);
      ++keys;
    }
  }
  EXPECT_EQ(kinds.size(), 7u);
  EXPECT_GT(keys, 1000);
}

/// The keys that a reader asks for in a table: what it says of one that it does not know.
std::set<std::string> asked_for(const fs::path& file, const std::string& text,
                                const std::string& wrong) {
  std::set<std::string> out;
  std::ofstream(file, std::ios::binary) << text;
  const auto report = exhibit::check_path(file.string());
  if (!report) return out;
  const std::string start = "Remove it, or write one of: ";
  for (const Problem& problem : report->problems) {
    if (!problem.where.starts_with(file.string() + ":") ||
        problem.what.find(wrong) == std::string::npos || !problem.remedy.starts_with(start))
      continue;
    std::istringstream names(problem.remedy.substr(start.size()));
    for (std::string name; names >> name;) out.insert(name.substr(0, name.find_first_of(",.")));
  }
  return out;
}

struct ReadTable {
  const char* file;
  std::string table;               ///< Of the list.
  std::vector<std::string> texts;  ///< In each, the key `qqqqqqqqqqqqqqqqqqqq` is unknown.
  std::set<std::string> tables{};  ///< That are no keys.
};

// What a reader asks for, its list has, and nothing else: no key is left out, and none is made up.
TEST(file_fields, have_the_keys_that_the_readers_ask_for) {
  const SmallSite site;
  const std::string q = "qqqqqqqqqqqqqqqqqqqq = 1\n";
  const auto mission = [&](const std::string& kind) {
    return "[[mission]]\nid = \"a\"\nkind = \"" + kind + "\"\n" + q;
  };
  std::vector<ReadTable> all{
      {"config/devices/polhem.toml", "", {q}, {"force", "body", "arm"}},
      {"config/devices/polhem.toml", "force", {"[force]\n" + q}},
      {"config/devices/polhem.toml", "body", {"[body]\n" + q}},
      {"config/devices/polhem.toml", "arm", {"[arm]\n" + q}},
      {"content/glazes.toml", "glaze", {"[[glaze]]\nid = \"a\"\n" + q}, {"name", "about"}},
      {"content/lessons/a.toml", "step", {"[[step]]\nid = \"a\"\n" + q}, {"words"}},
      {"content/missions.toml",
       "mission",
       {mission("today"), mission("describe"), mission("eyes_closed"), mission("two_hands")},
       {"title", "about"}},
      {"content/vessels/moon_jar/vessel.toml", "", {q}, {"label"}},
      {"content/vessels/moon_jar/vessel.toml", "label.LANGUAGE", {"[label.en]\n" + q}}};
  for (const std::string& table : fields::test::tables_of(*fields_of(exhibit::FileKind::scene)))
    all.push_back({"config/scenes/a.toml", table, {"[" + table + "]\n" + q}});
  for (const std::string table :
       {"idle", "keepsake", "store", "screen", "sound", "access", "phone", "reader", "attract"})
    all.push_back({"config/exhibit.toml", table, {"[" + table + "]\n" + q}});
  all.push_back({"config/exhibit.toml", "hours", {"[hours]\n" + q}, {"exceptions"}});
  for (const ReadTable& one : all) {
    SCOPED_TRACE(std::string(one.file) + " [" + one.table + "]");
    const fs::path file = site / one.file;
    std::set<std::string> asked, listed;
    const fields::FieldList* list = nullptr;
    for (const std::string& text : one.texts) {
      asked.merge(asked_for(file, text, q.substr(0, 20)));
      list = fields_of(exhibit::kind_of_toml(file));
      ASSERT_NE(list, nullptr);
    }
    for (const std::string& table : one.tables) asked.erase(table);
    for (const fields::Field& field : list->fields)
      if (field.table == one.table && !field.any_key) listed.insert(field.key);
    EXPECT_EQ(asked, listed);
  }
}

/// Another legal value, as far as a list can tell; "" if none is known.
std::string legal(const fields::Field& field, const std::string& was, std::mt19937& random) {
  switch (field.kind) {
    case FieldKind::boolean:
      return was == "true" ? "false" : "true";
    case FieldKind::whole:
      return std::to_string(static_cast<long long>(
          field.least + (field.most - field.least) * static_cast<double>(random() % 1000) / 1e3));
    case FieldKind::number:
      return field.least < field.most
                 ? fields::number_words(field.least + (field.most - field.least) *
                                                          static_cast<double>(random() % 1000) /
                                                          1e3)
                 : "";
    case FieldKind::text:
      if (!field.choices.empty()) return field.choices[random() % field.choices.size()];
      return field.range.find("letters") != std::string::npos
                 ? "Ton é 흙 " + std::to_string(random())
                 : "";
    default:
      return was == "[]" ? "" : was.substr(0, was.size() - 1) + " ]";
  }
}

// Whatever the rest of the check says of a value: it is set alone and taken back to the byte, or
// nothing is changed.
TEST(file_fields, any_legal_value_is_set_alone_and_taken_back_or_leaves_its_file_alone) {
  const SmallSite site;
  std::mt19937 random(46);
  int set = 0, refused = 0;
  std::set<std::string> kinds;
  for (const auto& entry : fs::recursive_directory_iterator(site.path())) {
    const fs::path file = entry.path();
    if (file.extension() != ".toml") continue;
    const fields::FieldList* list = fields_of(exhibit::kind_of_toml(file));
    if (list == nullptr) continue;
    const std::string before = content(file);
    const toml::TomlPlaces places(before);
    for (int tries = 0; tries < 5; ++tries) {
      const auto& old = places.values()[random() % places.values().size()];
      const fields::Field* field = fields::find_field(*list, names_of(places, old.path));
      if (field == nullptr || old.kind == toml::TomlPlaces::Kind::table) continue;
      const std::string was = before.substr(old.begin, old.end - old.begin),
                        fresh = legal(*field, was, random);
      if (fresh.empty() || fresh == was) continue;
      SCOPED_TRACE(file.string() + " " + toml::key_text(old.path) + " " + fresh);
      const auto done = set_values(file, {{toml::key_text(old.path), fresh}});
      if (!done) {
        ++refused;
        EXPECT_EQ(content(file), before);
        continue;
      }
      if (done->revision.values.empty()) continue;
      ++set;
      kinds.insert(list->file);
      const std::string now = content(file);
      EXPECT_EQ(now.substr(0, old.begin), before.substr(0, old.begin));
      EXPECT_TRUE(now.ends_with(before.substr(old.end)));
      EXPECT_NE(now, before);
      const auto undone = undo(site.exhibit());
      ASSERT_TRUE(undone) << to_text(undone.error());
      EXPECT_EQ(content(file), before);
    }
  }
  EXPECT_GE(set, 15) << refused << " were refused";
  EXPECT_GE(kinds.size(), 5u);
}

}  // namespace
}  // namespace onggi::editing::file_fields_test
