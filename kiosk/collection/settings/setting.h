#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/ground/fields/field.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::settings {

/// Where a setting's value lies in an exhibit.
template <class Value>
using SettingPlace = Value& (*)(Exhibit&);

/// `member` of an exhibit, or `member` of its `part`, as a SettingPlace.
template <auto member>
auto& exhibit_place(Exhibit& exhibit) {
  return exhibit.*member;
}
template <auto part, auto member>
auto& exhibit_part_place(Exhibit& exhibit) {
  return exhibit.*part.*member;
}

struct Setting;

/// What a setting's own reader works on.
struct SettingReading {
  toml::TomlReader::Table table;                 ///< The table with the key.
  const std::filesystem::path& folder;           ///< Where relative paths start.
  const std::filesystem::path& language_folder;  ///< Empty: languages' files are not looked for.
  ExhibitRead& read;
};

/// One key of exhibit.toml. Reader, page (config/README.md), shipped file and tests go by the list
/// exhibit_settings(), so a setting is written down once. Its default is its member's.
struct Setting {
  std::string_view table;  ///< "screen": below [screen]; "": above all tables.
  std::string_view key;
  std::variant<SettingPlace<bool>, SettingPlace<int>, SettingPlace<double>,
               SettingPlace<std::string>, SettingPlace<std::filesystem::path>,
               SettingPlace<std::optional<std::filesystem::path>>,
               SettingPlace<std::vector<std::string>>>
      place;
  std::string_view words;      ///< What it does, for curators. One line of Markdown.
  double least = 0, most = 0;  ///< Of a number, both included.
  std::string_view unit{};     ///< Of a number: "s", "mm"; "": none.
  std::string_view range{};  ///< What is allowed, in words, where `least` to `most` is not enough.
  std::string_view page{};   ///< A page with more, from the root: "kiosk/docs/lesson.md"; "": none.
  std::string_view usual{};  ///< The default where the member's is not it, as the file writes it.
  /// Reads what needs more than a kind and a range; null: by `place`.
  void (*reads)(const Setting&, SettingReading&) = nullptr;
  /// onggi-console must be started again. The kiosk itself takes every change without.
  bool restarts_console = false;
};

/// Reads one setting. An invalid value is noted and leaves the default. Allocates.
void read_setting(const Setting& setting, SettingReading& reading);

/// Its value in `exhibit`, as the file writes it: `600`, `true`, `"Onggi"`, `["en", "ko"]`.
std::string written_value(const Setting& setting, Exhibit exhibit);

/// Its default, as the file writes it.
std::string usual_value(const Setting& setting);

/// Setting as a Field, with its default.
fields::Field field_of(const Setting& setting);

}  // namespace onggi::settings
