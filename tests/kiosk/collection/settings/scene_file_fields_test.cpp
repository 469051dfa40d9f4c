#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "engine/scene/scene.h"
#include "kiosk/collection/settings/scene_file.h"

// What config/README.md tells of a scene's keys is what the program takes.
namespace onggi::settings::scene_readme_test {
namespace {

namespace fs = std::filesystem;

// The rows of config/README.md below the heading of `table`.
std::vector<std::string> rows_told(const std::string& table) {
  std::ifstream in("config/README.md");
  std::vector<std::string> rows;
  bool here = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("#")) here = line.find("[" + table + "]") != std::string::npos;
    if (here && line.starts_with("| `")) rows.push_back(line);
  }
  return rows;
}

// The last column of a row, and the numbers of the one before: where both are numbers.
std::vector<double> figures_told(std::string row) {
  std::vector<std::string> columns;
  std::istringstream in(row);
  for (std::string column; std::getline(in, column, '|');) columns.push_back(column);
  std::vector<double> out;
  if (columns.size() < 5) return out;
  const auto& range = columns[columns.size() - 2];
  const std::size_t low = range.find_last_of(',') == std::string::npos ? 0 : range.rfind(',') + 1;
  const std::size_t to = range.find(" to ", low);
  if (to == std::string::npos) return out;
  return {std::stod(range.substr(low)), std::stod(range.substr(to + 4)), std::stod(columns.back())};
}

// The row of a field, but for its words.
template <class Def>
std::string row_of(const DefField<Def>& field) {
  const std::string unit = *field.unit != '\0' ? std::string(field.unit) + ", " : "";
  return "| `" + std::string(field.key) + "` | (meaning) | " + unit + number_text(field.least) +
         " to " + number_text(field.most) + " | " + number_text(Def{}.*(field.value)) + " |";
}

template <class Def>
int expect_told() {
  for (const DefField<Def>& field : Def::fields()) {
    const std::string start = "| `" + std::string(field.key) + "` |";
    const auto rows = rows_told(Def::kName);
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const std::string& r) { return r.starts_with(start); });
    const bool right =
        row != rows.end() &&
        figures_told(*row) == std::vector<double>{field.least, field.most, Def{}.*(field.value)};
    EXPECT_TRUE(right) << "Write into config/README.md, below [" << Def::kName << "]:\n"
                       << row_of(field);
  }
  return static_cast<int>(Def::fields().size());
}

TEST(scene_readme, tells_every_figure_of_every_effect_and_part_as_it_is) {
  int told = expect_told<PaperDef>();
  SceneDef def;
  each_effect(def, [&told]<class Def>(std::optional<Def>&) { told += expect_told<Def>(); });
  // Of the clay's lengths some bound each other, and the page says so in words.
  each_part(def, [&told]<class Def>(Def&) {
    if constexpr (!std::is_same_v<Def, ClayDef>) told += expect_told<Def>();
  });
  EXPECT_GE(told, 36);
}

/// The lines `key = value` of a file, without comments.
std::vector<std::pair<std::string, std::string>> keys_of(const fs::path& file) {
  std::vector<std::pair<std::string, std::string>> found;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    line.resize(std::min(line.find('#'), line.size()));
    const std::size_t equals = line.find(" = ");
    if (equals == std::string::npos) continue;
    line.erase(line.find_last_not_of(' ') + 1);
    found.emplace_back(line.substr(0, equals), line.substr(equals + 3));
  }
  return found;
}

TEST(scene_readme, has_a_row_for_every_key_of_the_first_scene_with_its_value) {
  std::ifstream in("config/README.md");
  std::vector<std::string> rows;
  for (std::string line; std::getline(in, line);) rows.push_back(line);
  int keys = 0;
  for (const auto& [key, value] : keys_of("config/scenes/first_touch.toml")) {
    ++keys;
    if (key == "drying_time") continue;  // the one figure that is not the engine's own
    const std::string start = "| `" + key + "` |", plain = "| " + value + " |",
                      quoted = "| `" + value + "` |";
    const bool there = std::any_of(rows.begin(), rows.end(), [&](const std::string& row) {
      return row.starts_with(start) && (row.ends_with(plain) || row.ends_with(quoted));
    });
    EXPECT_TRUE(there) << key << " = " << value;
  }
  EXPECT_GE(keys, 20);
}

}  // namespace
}  // namespace onggi::settings::scene_readme_test
