#include "kiosk/collection/settings/exhibit.h"

#include <algorithm>

#include "kiosk/collection/settings/hours_table.h"
#include "kiosk/collection/settings/list_file.h"
#include "kiosk/collection/settings/text_in.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::settings {
namespace {

namespace fs = std::filesystem;
using Table = toml::TomlReader::Table;

constexpr std::size_t kMostLetters = 120;  // fits the postcard's credit line and a screen's title
constexpr std::size_t kMostLanguages = 12;

bool has_control_character(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) == 0x7F;
  });
}

/// Reads one line of text that visitors see.
bool read_line(Table& table, const std::string& key, const std::string& name, std::string& out) {
  std::string text;
  if (!table.text(key, text)) return false;
  std::string what;
  if (text.find_first_not_of(' ') == std::string::npos) what = name + " is empty.";
  if (has_control_character(text)) what = name + " has a line break or tab in it.";
  if (letters(text) > kMostLetters) {
    what = name + " has " + std::to_string(letters(text)) + " letters, but only " +
           std::to_string(kMostLetters) + " fit.";
  }
  if (what.empty()) {
    out = text;
    return true;
  }
  table.complain(key, what, "Write one line of 1 to " + std::to_string(kMostLetters) + " letters.");
  return false;
}

/// "en", "ko", "zh-Hant": letters, then parts of letters and digits. It becomes a file's name.
bool is_language_code(const std::string& code) {
  std::size_t part = 0, parts = 0;
  for (const char c : code) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (c == '-') {
      if (part < 2) return false;
      ++parts;
      part = 0;
    } else if (letter || (parts > 0 && c >= '0' && c <= '9')) {
      if (++part > 8) return false;
    } else {
      return false;
    }
  }
  return part >= 2;
}

void read_languages(Table& root, const fs::path& folder, std::vector<std::string>& out) {
  std::vector<std::string> codes;
  const bool written = root.texts("languages", codes);
  if (!written) codes = out;
  const std::string example = "Write language codes, the main language first: [\"en\", \"ko\"].";
  if (codes.empty()) return root.complain("languages", "languages is an empty list.", example);
  if (codes.size() > kMostLanguages) {
    return root.complain("languages", "languages has more than 12 elements.", example);
  }
  std::vector<std::string> good;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const std::string& code = codes[i];
    if (!is_language_code(code)) {
      root.complain_at("languages", i, "\"" + code + "\" is not a language code.", example);
    } else if (std::find(good.begin(), good.end(), code) != good.end()) {
      root.complain_at("languages", i, "\"" + code + "\" is named twice.", "Name it once.");
    } else {
      std::error_code error;
      const fs::path file = folder / (code + ".toml");
      if (!folder.empty() && !fs::is_regular_file(file, error)) {
        root.complain_at("languages", i, "There are no words for \"" + code + "\".",
                         "Write " + file.string() +
                             " (copy another language and translate it), or remove the language.");
      }
      good.push_back(code);
    }
  }
  if (!good.empty()) out = good;
}

void read_title(Table& root, const std::vector<std::string>& languages,
                std::map<std::string, std::string>& out) {
  auto table = root.child("title");
  std::map<std::string, std::string> titles;
  for (const std::string& code : languages) {
    std::string text;
    if (read_line(table, code, "title." + code, text)) {
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

/// Reads a path relative to `folder`; an invalid one leaves the default. True if valid.
bool read_path(Table& table, const std::string& key, const fs::path& folder, fs::path& out) {
  std::string text;
  bool good = false;
  if (table.text(key, text)) {
    if (text.empty() || has_control_character(text)) {
      table.complain(key, key + " is not a path.",
                     "Write a path, such as \"" + out.string() + "\".");
    } else if (text.starts_with("~")) {
      table.complain(key, key + " begins with ~, which only a shell understands.",
                     "Write the full path, starting with /.");
    } else {
      out = text;
      good = true;
    }
  }
  out = (folder / out).lexically_normal();
  if (!out.has_filename()) out = out.parent_path();  // "a/b/" and "a/b" are the same folder
  return good;
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

void read_shelf_and_scene(Table& root, const fs::path& folder, Exhibit& exhibit) {
  std::error_code error;
  read_path(root, "shelf", folder, exhibit.shelf);
  if (!fs::is_directory(exhibit.shelf, error)) {
    root.complain("shelf", "The shelf " + exhibit.shelf.string() + " is not a folder.",
                  "Write shelf = \"FOLDER\" with the folder that holds a folder for each vessel.");
  }
  read_path(root, "scene", folder, exhibit.scene);
  if (!fs::is_regular_file(exhibit.scene, error)) {
    root.complain("scene", "There is no scene " + exhibit.scene.string() + ".",
                  "Write scene = \"FILE\" with one of the files in scenes/.");
  }
  read_path(root, "glazes", folder, exhibit.glazes);
  if (!fs::is_regular_file(exhibit.glazes, error)) {
    root.complain("glazes", "There is no glaze file " + exhibit.glazes.string() + ".",
                  "Write glazes = \"FILE\" with a file such as content/glazes.toml.");
  }
}

/// If the key is absent, the default lesson is used when its file exists.
void read_lesson_of(Table& root, const fs::path& folder, Exhibit& exhibit) {
  const bool named = root.has("lesson");
  fs::path lesson = "../content/lessons/first_minute.toml";
  read_path(root, "lesson", folder, lesson);
  std::error_code error;
  if (fs::is_regular_file(lesson, error))
    exhibit.lesson = lesson;
  else if (named)
    root.complain(
        "lesson", "There is no lesson " + lesson.string() + ".",
        "Write lesson = \"FILE\" with a file such as content/lessons/first_minute.toml. For "
        "no lesson, use a file without steps.");
}

/// If the key is absent, the default missions are used when their file exists.
void read_missions_of(Table& root, const fs::path& folder, Exhibit& exhibit) {
  const bool named = root.has("missions");
  fs::path missions = "../content/missions.toml";
  read_path(root, "missions", folder, missions);
  std::error_code error;
  if (fs::is_regular_file(missions, error))
    exhibit.missions = missions;
  else if (named)
    root.complain("missions", "There is no mission file " + missions.string() + ".",
                  "Write missions = \"FILE\" with a file such as content/missions.toml, or remove "
                  "the key.");
}

/// Reads the rubric; without the key and without the file the defaults apply.
void read_rubric_of(Table& root, const fs::path& folder, ExhibitRead& read) {
  const bool named = root.has("rubric");
  read_path(root, "rubric", folder, read.exhibit.rubric_file);
  std::error_code error;
  if (!fs::is_regular_file(read.exhibit.rubric_file, error)) {
    if (named)
      root.complain("rubric", "There is no rubric " + read.exhibit.rubric_file.string() + ".",
                    "Write rubric = \"FILE\", or remove the key to use the built-in rubric.");
    return;
  }
  RubricRead rubric = read_rubric(read.exhibit.rubric_file);
  read.exhibit.rubric = rubric.rubric;
  read.keys_checked += rubric.keys_checked;
  read.problems = std::move(rubric.problems);
}

void read_attract(Table table, std::vector<std::string>& scripts) {
  constexpr std::size_t kMostScripts = 32;
  std::vector<std::string> names;
  if (table.texts("scripts", names)) {
    if (names.empty() || names.size() > kMostScripts)
      table.complain("scripts", "scripts is empty, or it has more than 32 elements.",
                     "Write what attract mode shows, pot by pot: scripts = [\"follow\"].");
    else
      scripts = names;
  }
  table.finish();
}

void read_idle(Table table, Exhibit::Idle& idle) {
  table.number("warn_after", idle.warn_after, 20, 3600, "s");
  table.number("countdown", idle.countdown, 20, 300, "s");
  table.number("result_after", idle.result_after, 20, 3600, "s");
  table.finish();
}

void read_keepsake(Table table, const fs::path& folder, Exhibit::Keepsake& keepsake) {
  read_path(table, "folder", folder, keepsake.folder);
  std::error_code error;
  if (fs::exists(keepsake.folder, error) && !fs::is_directory(keepsake.folder, error)) {
    table.complain("folder", keepsake.folder.string() + " is a file, not a folder.",
                   "Name another folder, or move the file away.");
  }
  table.integer("quota_mb", keepsake.quota_mb, 10, 1000000, "MB");
  table.integer("days", keepsake.days, 0, 3650, "days");
  table.boolean("gallery", keepsake.gallery);
  table.boolean("turning", keepsake.turning);
  table.finish();
}

void read_sound(Table table, Exhibit::Sound& sound) {
  table.number("volume", sound.volume, 0, 1);
  table.finish();
}

void read_access(Table table, Exhibit::Access& access) {
  double hold = access.hold_to_speak;
  if (table.number("hold_to_speak", hold, 0, 10, "s")) {
    if (hold > 0 && hold < 1)
      table.complain("hold_to_speak", "Under 1 s every normal touch would start speech.",
                     "Write 1 to 10 s, or 0 to turn this gesture off.");
    else
      access.hold_to_speak = hold;
  }
  table.finish();
}

void read_store(Table table, Exhibit::Store& store) {
  table.boolean("count", store.count);
  table.integer("months", store.months, 1, 240, "months");
  table.finish();
}

void read_network(Table& table, Exhibit::Phone& phone) {
  constexpr std::size_t kLongest = 32, kShort = 8, kLong = 63;  // IEEE 802.11; WPA2
  std::string network, password;
  if (table.text("network", network)) {
    if (network.size() > kLongest || has_control_character(network))
      table.complain(
          "network", "\"" + network + "\" is not a valid network name.",
          "Write the name from hostapd.conf, 1 to 32 Latin letters, or fewer in other scripts.");
    else
      phone.network = network;
  }
  if (table.text("password", password)) {
    const bool printable =
        std::all_of(password.begin(), password.end(), [](char c) { return c >= ' ' && c <= '~'; });
    if (!password.empty() && (password.size() < kShort || password.size() > kLong || !printable))
      table.complain("password", "This is not a valid WPA2 password.",
                     "Write the password from hostapd.conf, 8 to 63 Latin letters and digits.");
    else
      phone.password = password;
  }
  if (!phone.network.empty() && phone.address.empty())
    table.complain("network", "There is a network for phones, but no address.",
                   "Write the kiosk's address: address = \"http://192.168.4.1\".");
}

void read_phone(Table table, Exhibit::Phone& phone) {
  // Short enough for a code that a phone reads off the screen.
  constexpr std::size_t kLongest = 100;
  std::string address;
  if (table.text("address", address) && !address.empty()) {
    while (address.ends_with("/")) address.pop_back();
    const bool web = address.starts_with("http://") || address.starts_with("https://");
    if (!web || address.size() > kLongest || has_control_character(address) ||
        address.find(' ') != std::string::npos || address.ends_with(":"))
      table.complain("address", "\"" + address + "\" is not an address that a phone can open.",
                     "Write one such as \"http://192.168.4.1:8080\", at most 100 letters.");
    else
      phone.address = address;
  }
  table.number("hours", phone.hours, 1, 720, "hours");
  read_network(table, phone);
  table.finish();
}

void read_screen(Table table, Exhibit::Screen& screen) {
  table.number("viewing_distance_mm", screen.viewing_distance_mm, 200, 5000, "mm");
  table.number("diagonal_mm", screen.diagonal_mm, 100, 5000, "mm");
  table.number("lower_edge_mm", screen.lower_edge_mm, 0, 1000, "mm");
  table.boolean("reduced_motion", screen.reduced_motion);
  table.boolean("left_handed", screen.left_handed);
  table.boolean("high_contrast", screen.high_contrast);
  table.boolean("larger_text", screen.larger_text);
  table.boolean("low_reach", screen.low_reach);
  table.boolean("spoken", screen.spoken);
  table.boolean("one_switch", screen.one_switch);
  table.number("scan_seconds", screen.scan_seconds, 0.5, 5, "s");
  table.boolean("silent", screen.silent);
  table.number("force", screen.force, 0, 1);
  table.finish();
}

void read_reader(Table table, ReaderLimits& limits) {
  table.integer("file_mb", limits.file_mb, 1, 4096, "MiB");
  table.integer("json_mb", limits.json_mb, 1, 1024, "MiB");
  table.integer("json_depth", limits.json_depth, 8, 256);
  table.integer("json_values", limits.json_values, 1000, 100'000'000);
  table.integer("vertices", limits.vertices, 1000, 100'000'000);
  table.integer("triangles", limits.triangles, 1000, 100'000'000);
  table.integer("vessels_in_a_file", limits.vessels_in_a_file, 1, 1000);
  table.integer("texture_px", limits.texture_px, 0, 16384, "pixels");
  table.finish();
}

}  // namespace

ExhibitRead read_exhibit(const fs::path& file, const fs::path& language_folder) {
  ExhibitRead read;
  toml::TomlReader reader(file);
  Exhibit& exhibit = read.exhibit;
  exhibit.file = file;
  const fs::path folder = file.parent_path();

  auto root = reader.root();
  read_line(root, "credit", "credit", exhibit.credit);
  read_languages(root, language_folder, exhibit.languages);
  read_title(root, exhibit.languages, exhibit.title);
  read_shelf_and_scene(root, folder, exhibit);
  read_vessel_scenes(root.child("vessel_scenes"), folder, exhibit);
  read_lesson_of(root, folder, exhibit);
  read_missions_of(root, folder, exhibit);
  read_rubric_of(root, folder, read);
  read_attract(root.child("attract"), exhibit.attract_scripts);
  read_idle(root.child("idle"), exhibit.idle);
  read_keepsake(root.child("keepsake"), folder, exhibit.keepsake);
  read_store(root.child("store"), exhibit.store);
  read_screen(root.child("screen"), exhibit.screen);
  read_sound(root.child("sound"), exhibit.sound);
  read_access(root.child("access"), exhibit.access);
  read_phone(root.child("phone"), exhibit.phone);
  read_hours(root.child("hours"), exhibit.hours);
  read_reader(root.child("reader"), exhibit.reader);
  root.finish();

  read.problems.insert(read.problems.begin(), reader.problems().begin(), reader.problems().end());
  read.keys_checked += reader.keys_checked();
  return read;
}

}  // namespace onggi::settings
