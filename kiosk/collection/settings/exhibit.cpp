#include "kiosk/collection/settings/exhibit.h"

#include <algorithm>

#include "kiosk/collection/settings/exhibit_settings.h"
#include "kiosk/collection/settings/hours_table.h"
#include "kiosk/collection/settings/keepsake_place.h"
#include "kiosk/collection/settings/setting_readers.h"
#include "kiosk/collection/settings/text_in.h"
#include "kiosk/collection/settings/visitor_text.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::settings {
namespace {

namespace fs = std::filesystem;
using Table = toml::TomlReader::Table;

void read_title(Table& root, const std::vector<std::string>& languages,
                std::map<std::string, std::string>& out) {
  auto table = root.child("title");
  std::map<std::string, std::string> titles;
  for (const std::string& code : languages) {
    std::string text;
    if (read_visitor_text(table, code, "title." + code, bounds::kExhibitTitle, text)) {
      titles[code] = text;
    } else if (!table.has(code) && (table.present() || !out.contains(code))) {
      table.complain("", "There is no title for the language \"" + code + "\".",
                     "Write " + code + " = \"...\" below [title].");
    }
  }
  table.finish();
  if (table.present() && !titles.empty()) out = titles;
  // A language without a title shows the English one, else the first language's, so a title is
  // never empty.
  std::string other = text_in(out, "en");
  if (!out.contains("en"))
    for (auto code = languages.rbegin(); code != languages.rend(); ++code)
      if (const auto own = out.find(*code); own != out.end()) other = own->second;
  for (const std::string& code : languages) out.try_emplace(code, other);
}

void read_vessel_scenes(Table table, const fs::path& folder, Exhibit& exhibit) {
  std::error_code error;
  for (const std::string& vessel : table.keys()) {
    fs::path scene = "scenes/master.toml";
    if (!read_path(table, vessel, folder, scene)) continue;
    if (fs::is_regular_file(scene, error))
      exhibit.vessel_scenes[vessel] = scene;
    else
      table.complain(vessel, "There is no scene " + scene.string() + ".",
                     "Write " + vessel + " = \"FILE\" with one of the files in scenes/.");
  }
  table.finish();
}

/// Reads the list's settings, table by table.
void read_listed(Table& root, const fs::path& folder, const fs::path& language_folder,
                 ExhibitRead& read) {
  const std::span<const Setting> settings = exhibit_settings();
  for (std::size_t first = 0; first < settings.size();) {
    const std::string_view name = settings[first].table;
    SettingReading reading{name.empty() ? root : root.child(name), folder, language_folder, read};
    for (; first < settings.size() && settings[first].table == name; ++first)
      read_setting(settings[first], reading);
    if (!name.empty()) reading.table.finish();
  }
}

}  // namespace

ExhibitRead read_exhibit(const fs::path& file, const fs::path& language_folder) {
  ExhibitRead read;
  toml::TomlReader reader(file);
  Exhibit& exhibit = read.exhibit;
  exhibit.file = file;
  const fs::path folder = file.parent_path();

  auto root = reader.root();
  read_listed(root, folder, language_folder, read);
  // Tables whose keys are languages, vessels and days.
  read_title(root, exhibit.languages, exhibit.title);
  read_vessel_scenes(root.child("vessel_scenes"), folder, exhibit);
  read_hours(root.child("hours"), exhibit.hours);
  check_keepsake_place(root.child("keepsake"), exhibit, language_folder);
  root.finish();
  // A power cut or a full disk while an editor saves leaves an empty file. Its defaults would show
  // another museum's title, and keep visitors' pots elsewhere.
  if (reader.ok() && reader.keys_checked() == 0)
    root.complain("", "The exhibit file has no settings. It may have been cut while it was saved.",
                  "Put back a copy of it, or write at least credit = \"YOUR MUSEUM\".");

  read.problems.insert(read.problems.begin(), reader.problems().begin(), reader.problems().end());
  read.keys_checked += reader.keys_checked();
  return read;
}

}  // namespace onggi::settings
