#include "kiosk/collection/settings/setting_readers.h"

#include <algorithm>
#include <regex>

#include "kiosk/collection/settings/visitor_text.h"

namespace onggi::settings {
namespace {

namespace fs = std::filesystem;
using Table = toml::TomlReader::Table;

constexpr std::size_t kMostLanguages = 12;

bool has_control_character(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) == 0x7F;
  });
}

// http or https, a name or number or [number] of a machine, a port or none, a path or none.
bool is_phone_address(const std::string& address) {
  static const std::regex kForm(
      R"(https?://(?:[A-Za-z0-9](?:[A-Za-z0-9-]*[A-Za-z0-9])?(?:\.[A-Za-z0-9](?:[A-Za-z0-9-]*[A-Za-z0-9])?)*|\[[0-9A-Fa-f:.]+\])(?::([0-9]{1,5}))?(?:/[A-Za-z0-9._~/-]*)?)");
  std::smatch parts;
  if (!std::regex_match(address, parts, kForm)) return false;
  return !parts[1].matched || (std::stoi(parts[1]) >= 1 && std::stoi(parts[1]) <= 65535);
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

template <class Value>
Value& value_of(const Setting& setting, const SettingReading& reading) {
  return std::get<SettingPlace<Value>>(setting.place)(reading.read.exhibit);
}

/// True if `file`, read from the setting, is there; else notes a Problem where `needed`.
bool read_file(const Setting& setting, SettingReading& reading, bool needed, fs::path& file) {
  const std::string key(setting.key);
  read_path(reading.table, key, reading.folder, file);
  std::error_code error;
  if (fs::is_regular_file(file, error)) return true;
  if (needed)
    reading.table.complain(
        key, "There is no file " + file.string() + ".",
        "Write " + key + " = \"FILE\" with a file such as " + usual_value(setting) + ".");
  return false;
}

}  // namespace

void read_words(const Setting& setting, SettingReading& reading) {
  const std::string key(setting.key);
  read_visitor_text(reading.table, key, key, bounds::kExhibitCredit,
                    value_of<std::string>(setting, reading));
}

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

void read_languages(const Setting& setting, SettingReading& reading) {
  auto& root = reading.table;
  const fs::path& language_folder = reading.language_folder;
  std::vector<std::string>& out = value_of<std::vector<std::string>>(setting, reading);
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
      const fs::path file = language_folder / (code + ".toml");
      if (!language_folder.empty() && !fs::is_regular_file(file, error)) {
        root.complain_at("languages", i, "There are no words for \"" + code + "\".",
                         "Write " + file.string() +
                             " (copy another language and translate it), or remove the language.");
      }
      good.push_back(code);
    }
  }
  if (!good.empty()) out = good;
}

void read_scripts(const Setting& setting, SettingReading& reading) {
  constexpr std::size_t kMostScripts = 32;
  std::vector<std::string> names;
  if (!reading.table.texts(setting.key, names)) return;
  if (names.empty() || names.size() > kMostScripts)
    reading.table.complain(setting.key, "scripts is empty, or it has more than 32 elements.",
                           "Write what attract mode shows, pot by pot: scripts = [\"follow\"].");
  else
    value_of<std::vector<std::string>>(setting, reading) = names;
}

void read_shelf_folder(const Setting& setting, SettingReading& reading) {
  const std::string key(setting.key);
  fs::path& folder = value_of<fs::path>(setting, reading);
  read_path(reading.table, key, reading.folder, folder);
  std::error_code error;
  if (!fs::is_directory(folder, error))
    reading.table.complain(
        key, "The shelf " + folder.string() + " is not a folder.",
        "Write shelf = \"FOLDER\" with the folder that holds a folder for each vessel.");
}

void read_vessel_ids(const Setting& setting, SettingReading& reading) {
  std::vector<std::string> ids, good;
  if (!reading.table.texts(setting.key, ids)) return;
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (std::ranges::find(good, ids[i]) != good.end())
      reading.table.complain_at(setting.key, i, "\"" + ids[i] + "\" is named twice.",
                                "Name it once.");
    else
      good.push_back(ids[i]);
  value_of<std::vector<std::string>>(setting, reading) = std::move(good);
}

void read_needed_file(const Setting& setting, SettingReading& reading) {
  read_file(setting, reading, true, value_of<fs::path>(setting, reading));
}

void read_optional_file(const Setting& setting, SettingReading& reading) {
  const std::string usual(setting.usual);  // in quotes, as the exhibit's file writes it
  fs::path file = usual.substr(1, usual.size() - 2);
  if (read_file(setting, reading, reading.table.has(setting.key), file))
    value_of<std::optional<fs::path>>(setting, reading) = file;
}

void read_optional_folder(const Setting& setting, SettingReading& reading) {
  const std::string key(setting.key), usual(setting.usual);  // in quotes
  fs::path folder = usual.substr(1, usual.size() - 2);
  read_path(reading.table, key, reading.folder, folder);
  std::error_code error;
  if (fs::is_directory(folder, error))
    value_of<std::optional<fs::path>>(setting, reading) = folder;
  else if (reading.table.has(key))
    reading.table.complain(key, folder.string() + " is not a folder.",
                           "Name an existing folder, or remove the line.");
}

void read_rubric_file(const Setting& setting, SettingReading& reading) {
  fs::path& file = value_of<fs::path>(setting, reading);
  if (!read_file(setting, reading, reading.table.has(setting.key), file)) return;
  RubricRead rubric = read_rubric(file);
  reading.read.exhibit.rubric = rubric.rubric;
  reading.read.keys_checked += rubric.keys_checked;
  reading.read.problems = std::move(rubric.problems);
}

void read_keepsake_folder(const Setting& setting, SettingReading& reading) {
  const std::string key(setting.key);
  fs::path& folder = value_of<fs::path>(setting, reading);
  read_path(reading.table, key, reading.folder, folder);
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error))
    reading.table.complain(key, folder.string() + " is a file, not a folder.",
                           "Name another folder, or move the file away.");
}

void read_hold(const Setting& setting, SettingReading& reading) {
  double& seconds = value_of<double>(setting, reading);
  double hold = seconds;
  if (!reading.table.number(setting.key, hold, setting.least, setting.most, setting.unit)) return;
  if (hold > 0 && hold < 1)
    reading.table.complain(setting.key, "Under 1 s every normal touch would start speech.",
                           "Write 1 to 10 s, or 0 to turn this gesture off.");
  else
    seconds = hold;
}

void read_phone_address(const Setting& setting, SettingReading& reading) {
  // Short enough for a code that a phone reads off the screen.
  constexpr std::size_t kLongest = 100;
  std::string address;
  if (!reading.table.text(setting.key, address) || address.empty()) return;
  while (address.ends_with("/")) address.pop_back();
  if (address.size() > kLongest || !is_phone_address(address))
    reading.table.complain(setting.key,
                           "\"" + address + "\" is not an address that a phone can open.",
                           "Write one such as \"http://192.168.4.1:8080\", at most 100 letters.");
  else
    value_of<std::string>(setting, reading) = address;
}

void read_network(const Setting& setting, SettingReading& reading) {
  constexpr std::size_t kLongest = 32;  // IEEE 802.11
  std::string network;
  if (!reading.table.text(setting.key, network)) return;
  if (network.size() > kLongest || has_control_character(network))
    return reading.table.complain(
        setting.key, "\"" + network + "\" is not a valid network name.",
        "Write the name from hostapd.conf, 1 to 32 Latin letters, or fewer in other scripts.");
  value_of<std::string>(setting, reading) = network;
  if (!network.empty() && reading.read.exhibit.phone.address.empty())
    reading.table.complain(setting.key, "There is a network for phones, but no address.",
                           "Write the kiosk's address: address = \"http://192.168.4.1\".");
}

void read_password(const Setting& setting, SettingReading& reading) {
  constexpr std::size_t kShort = 8, kLong = 63;  // WPA2
  std::string password;
  if (!reading.table.text(setting.key, password)) return;
  const bool printable =
      std::all_of(password.begin(), password.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (!password.empty() && (password.size() < kShort || password.size() > kLong || !printable))
    reading.table.complain(
        setting.key, "This is not a valid WPA2 password.",
        "Write the password from hostapd.conf, 8 to 63 Latin letters and digits.");
  else
    value_of<std::string>(setting, reading) = password;
}

}  // namespace onggi::settings
