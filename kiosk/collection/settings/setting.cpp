#include "kiosk/collection/settings/setting.h"

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

fields::Field field_of(const Setting& setting) {
  using fields::FieldKind;
  const FieldKind kind = std::visit(
      []<class Value>(SettingPlace<Value>) {
        if constexpr (std::is_same_v<Value, bool>) return FieldKind::boolean;
        if constexpr (std::is_same_v<Value, int>) return FieldKind::whole;
        if constexpr (std::is_same_v<Value, double>) return FieldKind::number;
        if constexpr (std::is_same_v<Value, std::vector<std::string>>) return FieldKind::texts;
        return FieldKind::text;
      },
      setting.place);
  return {.table = std::string(setting.table),
          .key = std::string(setting.key),
          .kind = kind,
          .words = std::string(setting.words),
          .least = setting.least,
          .most = setting.most,
          .unit = std::string(setting.unit),
          .range = std::string(setting.range),
          .usual = usual_value(setting),
          .page = std::string(setting.page),
          .choices = {},
          .restarts_console = setting.restarts_console};
}

}  // namespace onggi::settings
