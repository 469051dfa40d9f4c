#pragma once

#include <filesystem>
#include <string>

#include "kiosk/collection/settings/setting.h"

namespace onggi::settings {

// Readers of the settings that need more than a kind and a range (Setting::reads). Each notes
// Problems with place and remedy, and leaves the default where the value is invalid. Allocate.

/// A line of 1 to 120 letters.
void read_words(const Setting& setting, SettingReading& reading);
/// Codes of languages, each once, each with a file of words.
void read_languages(const Setting& setting, SettingReading& reading);
/// The names of scripts, 1 to 32.
void read_scripts(const Setting& setting, SettingReading& reading);
/// A folder that must exist.
void read_shelf_folder(const Setting& setting, SettingReading& reading);
/// Ids of vessels, each once. Whether the shelf has them, `onggi check` looks later.
void read_vessel_ids(const Setting& setting, SettingReading& reading);
/// A file that must exist. The Problem names the setting's key as what it is.
void read_needed_file(const Setting& setting, SettingReading& reading);
/// A file that may be absent if the key is.
void read_optional_file(const Setting& setting, SettingReading& reading);
/// A folder that may be absent if the key is.
void read_optional_folder(const Setting& setting, SettingReading& reading);
/// The rubric's file, and its values; without the key and without the file the defaults apply.
void read_rubric_file(const Setting& setting, SettingReading& reading);
/// A folder that is made when first needed.
void read_keepsake_folder(const Setting& setting, SettingReading& reading);
/// Seconds of a gesture: 0, or long enough that no normal touch is one.
void read_hold(const Setting& setting, SettingReading& reading);
/// A web address, short enough for a code that a phone reads off the screen.
void read_phone_address(const Setting& setting, SettingReading& reading);
/// A Wi-Fi name (IEEE 802.11) and its password (WPA2). After the address.
void read_network(const Setting& setting, SettingReading& reading);
void read_password(const Setting& setting, SettingReading& reading);

/// Reads a path relative to `folder`; an invalid one leaves the default. True if valid.
bool read_path(toml::TomlReader::Table& table, const std::string& key,
               const std::filesystem::path& folder, std::filesystem::path& out);

}  // namespace onggi::settings
