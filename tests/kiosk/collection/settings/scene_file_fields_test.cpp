#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "kiosk/collection/settings/scene_file_fields.h"
#include "tests/kiosk/ground/fields/page_tables.h"

// What config/README.md tells of a scene's keys is what the program takes.
namespace onggi::settings::scene_file_fields_test {
namespace {

namespace fs = std::filesystem;

TEST(scene_file_fields, has_a_row_for_every_field_of_every_effect_and_part) {
  fields::test::expect_on_page(scene_fields(), "## scenes/*.toml",
                               [](const std::string& table) { return "### [" + table + "]"; });
}

TEST(scene_file_fields, have_words_for_every_number_of_the_engine) {
  fields::test::expect_whole(scene_fields());
  EXPECT_GE(scene_fields().fields.size(), 75u);
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
