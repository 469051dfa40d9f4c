#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "engine/lab/scene_fields.h"
#include "kiosk/collection/settings/scene_file_fields.h"
#include "tests/kiosk/ground/fields/page_tables.h"

// What config/README.md tells of a scene's keys is what the program takes.
namespace onggi::settings::scene_file_fields_test {
namespace {

namespace fs = std::filesystem;

/// True if `effect` needs `other`, or what it needs does.
bool needs(const fields::OptionalTable& effect, const std::string& other) {
  if (effect.needs.empty()) return false;
  if (effect.needs == other) return true;
  const auto* next = fields::find_table(scene_fields(), {effect.needs});
  return next != nullptr && needs(*next, other);
}

TEST(scene_file_fields, has_a_row_for_every_field_of_every_effect_and_part) {
  fields::test::expect_on_page(scene_fields(), "## scenes/*.toml",
                               [](const std::string& table) { return "### [" + table + "]"; });
}

TEST(scene_file_fields, have_words_for_every_number_of_the_engine) {
  fields::test::expect_whole(scene_fields());
  EXPECT_GE(scene_fields().fields.size(), 75u);
}

TEST(scene_file_fields, have_every_effect_of_the_engine_with_the_pages_words_and_its_needs) {
  const fields::test::Lines page = fields::test::lines_of("config/README.md");
  std::vector<std::string> names;
  for (const fields::OptionalTable& effect : scene_fields().tables) {
    names.push_back(effect.name);
    const auto at = std::find(page.begin(), page.end(), "### [" + effect.name + "]");
    ASSERT_LT(at, page.end() - 2) << effect.name;
    EXPECT_TRUE((at + 2)->starts_with(effect.words)) << effect.name << ": " << *(at + 2);
    EXPECT_FALSE(effect.gives.empty()) << effect.name;
    // The engine says the same of a scene with this effect alone.
    SceneDef alone;
    std::size_t n = 0, at_n = lab::effect_names().size();
    for (const std::string& name : lab::effect_names()) {
      if (name == effect.name) at_n = n;
      ++n;
    }
    ASSERT_LT(at_n, n) << effect.name;
    alone = lab::bare(alone);
    lab::add_effect(alone, at_n);
    for (std::size_t other = 0; other < n; ++other)
      if (other != at_n) {
        SceneDef without = alone;
        lab::remove_effect(without, other);
        EXPECT_EQ(lab::has_effect(alone, other) && !lab::has_effect(without, at_n),
                  needs(effect, lab::effect_names()[other]))
            << effect.name << " and " << lab::effect_names()[other];
      }
  }
  std::vector<std::string> engine = lab::effect_names();
  std::sort(names.begin(), names.end());
  std::sort(engine.begin(), engine.end());
  EXPECT_EQ(names, engine);
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

TEST(scene_file_fields, have_every_key_of_the_first_scene_with_its_value_as_the_default) {
  int keys = 0;
  for (const auto& written : keys_of("config/scenes/first_touch.toml")) {
    const std::string &key = written.first, &value = written.second;
    ++keys;
    if (key == "drying_time") continue;  // the one figure that is not the engine's own
    const auto& all = scene_fields().fields;
    const bool there = std::any_of(all.begin(), all.end(), [&](const fields::Field& field) {
      if (field.key != key) return false;
      const bool number =
          field.kind == fields::FieldKind::whole || field.kind == fields::FieldKind::number;
      return number ? std::stod(field.usual) == std::stod(value) : field.usual == value;
    });
    EXPECT_TRUE(there || key == "quality") << key << " = " << value;
  }
  EXPECT_GE(keys, 20);
}

}  // namespace
}  // namespace onggi::settings::scene_file_fields_test
