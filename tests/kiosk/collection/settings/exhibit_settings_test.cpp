#include "kiosk/collection/settings/exhibit_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <set>
#include <sstream>

#include "kiosk/collection/settings/exhibit_fields.h"
#include "tests/kiosk/ground/fields/page_tables.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::settings::exhibit_settings_test {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using fields::test::kWrite;
using fields::test::Lines;
using fields::test::lines_of;
using fields::test::write;
using fields::test::writes;

/// The first line from `first` for which `is` holds, or the end.
template <class Is>
Lines::iterator next(Lines& lines, Lines::iterator first, Is is) {
  return std::find_if(first, lines.end(), is);
}

TEST(exhibit_settings, every_setting_stands_once_and_tables_stand_together) {
  fields::test::expect_whole(exhibit_fields());
  std::set<std::string_view> seen;
  std::string_view last = "none";
  for (const Setting& setting : exhibit_settings())
    if (setting.table != last) {
      last = setting.table;
      EXPECT_TRUE(seen.insert(last).second) << last;
    }
}

TEST(exhibit_settings, the_page_has_every_row_as_the_list_has_it) {
  fields::test::expect_on_page(exhibit_fields(), "## exhibit.toml", [](const std::string& table) {
    return table.empty() ? "## exhibit.toml" : "### [" + table + "]";
  });
}

/// The lines of the table [`name`] of a TOML file, without blank ones at its end; none if the file
/// has no such table.
std::pair<Lines::iterator, Lines::iterator> table_of(Lines& lines, std::string_view name) {
  const auto is_table = [](const std::string& l) { return l.starts_with("["); };
  auto begin = lines.begin();
  if (!name.empty()) {
    const std::string header = "[" + std::string(name) + "]";
    begin = next(lines, begin, [&](const std::string& l) { return l.starts_with(header); });
    if (begin == lines.end()) return {begin, begin};
    ++begin;
  }
  auto end = next(lines, begin, is_table);
  while (end != begin && (end - 1)->empty()) --end;
  return {begin, end};
}

// Tables of what most museums lack, such as [phone], are not in the file.
TEST(exhibit_settings, the_file_that_ships_writes_each_of_its_tables_whole) {
  const fs::path file = "config/exhibit.toml";
  const Lines before = lines_of(file);
  Lines lines = before;
  for (const Setting& setting : exhibit_settings()) {
    const auto [begin, end] = table_of(lines, setting.table);
    if (begin == end) continue;
    const std::string start = std::string(setting.key) + " = ";
    if (std::any_of(begin, end, [&](const std::string& l) { return l.starts_with(start); }))
      continue;
    EXPECT_TRUE(writes()) << "[" << setting.table << "] lacks " << setting.key << ". " << kWrite;
    lines.insert(end, start + usual_value(setting) + "  # " + std::string(setting.words));
  }
  if (writes() && lines != before) write(file, lines);
}

TEST(exhibit_settings, what_ships_is_what_holds_where_nothing_is_written) {
  const Exhibit shipped = read_exhibit("config/exhibit.toml").exhibit;
  const Exhibit none = read_exhibit("config/absent.toml").exhibit;
  for (const Setting& setting : exhibit_settings())
    EXPECT_EQ(written_value(setting, shipped), written_value(setting, none)) << setting.key;
  EXPECT_EQ(shipped.title, none.title);
  EXPECT_EQ(shipped.rubric, none.rubric);
}

/// One setting, read from a file of its own.
class OneSetting {
 public:
  explicit OneSetting(const Setting& setting) : setting_(setting) {
    fs::create_directories(folder_ / "content/vessels");
    fs::create_directories(folder_ / "config/scenes");
    std::ofstream(folder_ / "config/scenes/first_touch.toml") << "";
    std::ofstream(folder_ / "content/glazes.toml") << "";
  }
  ExhibitRead read(const std::string& value) const {
    const fs::path file = folder_ / "config/exhibit.toml";
    std::ofstream out(file);
    if (!setting_.table.empty()) out << "[" << setting_.table << "]\n";
    out << setting_.key << " = " << value << "\n";
    out.close();
    return read_exhibit(file);
  }
  void expect_taken(const std::string& value) const {
    const ExhibitRead r = read(value);
    EXPECT_THAT(r.problems, IsEmpty()) << setting_.key << " = " << value;
    EXPECT_EQ(written_value(setting_, r.exhibit), value) << setting_.key;
    EXPECT_GE(r.keys_checked, 1);
  }
  void expect_refused(const std::string& value) const {
    const ExhibitRead r = read(value);
    ASSERT_THAT(r.problems, SizeIs(1)) << setting_.key << " = " << value;
    EXPECT_NE(r.problems[0].where.find(".toml:" + std::to_string(setting_.table.empty() ? 1 : 2)),
              std::string::npos)
        << r.problems[0].where;
    EXPECT_EQ(written_value(setting_, r.exhibit), usual_value(setting_));
  }

 private:
  const Setting& setting_;
  const files::test::ScratchFolder folder_;
};

TEST(exhibit_settings, a_number_is_taken_to_both_its_ends_and_refused_beyond_them) {
  int checked = 0;
  for (const Setting& setting : exhibit_settings()) {
    const bool whole = std::holds_alternative<SettingPlace<int>>(setting.place);
    if (!whole && !std::holds_alternative<SettingPlace<double>>(setting.place)) continue;
    const OneSetting one(setting);
    for (const auto& [end, beyond] : {std::pair{setting.least, -1}, {setting.most, 1}}) {
      std::ostringstream in, out;
      in << std::setprecision(9) << end;
      out << std::setprecision(9) << end + beyond;
      one.expect_taken(in.str());
      one.expect_refused(out.str());
    }
    one.expect_refused("\"much\"");
    ++checked;
  }
  EXPECT_GE(checked, 20);
}

TEST(exhibit_settings, a_switch_is_taken_either_way_and_refused_otherwise) {
  int checked = 0;
  for (const Setting& setting : exhibit_settings()) {
    if (!std::holds_alternative<SettingPlace<bool>>(setting.place)) continue;
    const OneSetting one(setting);
    for (const char* value : {"true", "false"}) one.expect_taken(value);
    one.expect_refused("1");
    ++checked;
  }
  EXPECT_GE(checked, 10);
}

}  // namespace
}  // namespace onggi::settings::exhibit_settings_test
