#include "kiosk/collection/settings/setting.h"

#include <algorithm>
#include <type_traits>

#include "engine/base/field_check.h"

namespace onggi::settings {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

std::string written(bool value) { return value ? "true" : "false"; }
std::string written(int value) { return std::to_string(value); }
std::string written(double value) { return number_text(value); }
std::string written(const std::string& value) { return quoted(value); }
std::string written(const fs::path& value) { return quoted(value.string()); }
std::string written(const std::optional<fs::path>& value) {
  return value ? written(*value) : "none";
}
std::string written(const std::vector<std::string>& values) {
  std::string out;
  for (const std::string& value : values) out += (out.empty() ? "" : ", ") + quoted(value);
  return "[" + out + "]";
}

}  // namespace

void read_setting(const Setting& setting, SettingReading& reading) {
  if (setting.reads != nullptr) return setting.reads(setting, reading);
  auto& table = reading.table;
  std::visit(
      [&]<class Value>(SettingPlace<Value> place) {
        Value& value = place(reading.read.exhibit);
        if constexpr (std::is_same_v<Value, bool>)
          table.boolean(setting.key, value);
        else if constexpr (std::is_same_v<Value, int>)
          table.integer(setting.key, value, static_cast<int>(setting.least),
                        static_cast<int>(setting.most), setting.unit);
        else if constexpr (std::is_same_v<Value, double>)
          table.number(setting.key, value, setting.least, setting.most, setting.unit);
        else if constexpr (std::is_same_v<Value, std::string>)
          table.text(setting.key, value);
      },
      setting.place);
}

std::string written_value(const Setting& setting, Exhibit exhibit) {
  return std::visit([&exhibit](auto place) { return written(place(exhibit)); }, setting.place);
}

std::string usual_value(const Setting& setting) {
  return setting.usual.empty() ? written_value(setting, Exhibit{}) : std::string(setting.usual);
}

std::string allowed_range(const Setting& setting) {
  if (!setting.range.empty()) return std::string(setting.range);
  if (std::holds_alternative<SettingPlace<bool>>(setting.place)) return "true or false";
  const bool whole = std::holds_alternative<SettingPlace<int>>(setting.place);
  const auto end = [whole](double value) {
    return whole ? std::to_string(static_cast<int>(value)) : number_text(value);
  };
  return (setting.unit.empty() ? "" : std::string(setting.unit) + ", ") + end(setting.least) +
         " to " + end(setting.most);
}

std::string page_row(const Setting& setting) {
  std::string row = "| `" + std::string(setting.key) + "` | " + std::string(setting.words);
  if (setting.restarts_console) row += "; start onggi-console again after a change";
  if (!setting.page.empty()) {
    std::string stem = fs::path(setting.page).stem().string();
    std::replace(stem.begin(), stem.end(), '_', ' ');
    row += " ([" + stem + "](../" + std::string(setting.page) + "))";
  }
  // Texts and lists stand as code.
  const std::string usual = usual_value(setting);
  const char* const mark = usual.starts_with('"') || usual.starts_with('[') ? "`" : "";
  return row + " | " + allowed_range(setting) + " | " + mark + usual + mark + " |";
}

}  // namespace onggi::settings
