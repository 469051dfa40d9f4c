#include "kiosk/wheel/device/device_file.h"

#include <algorithm>
#include <optional>
#include <string>

#include "kiosk/ground/fields/field_reader.h"
#include "kiosk/ground/toml/toml_reader.h"
#include "kiosk/wheel/device/device_fields.h"

namespace onggi::device {

namespace {

using fields::Field;
using Table = toml::TomlReader::Table;

// Colgate's b > K (T / 2 + delay T), with the margin of onggi lab loop (engine/lab).
constexpr double kTick = 0.001, kMarginInFile = 1.5, kRounding = 1.01;

/// "x", "+y" or "-z".
std::optional<device::DeviceAxis> axis_of(const std::string& text) {
  const bool has_sign = !text.empty() && (text[0] == '+' || text[0] == '-');
  const std::string name = text.substr(has_sign ? 1 : 0);
  if (name != "x" && name != "y" && name != "z") return std::nullopt;
  return device::DeviceAxis{name[0] - 'x', text[0] == '-' ? -1.0 : 1.0};
}

void read_axes(Table& root, device::DeviceDef& def) {
  std::vector<std::string> texts;
  if (!root.texts("axes", texts)) return;
  auto axes = def.axes;
  bool good = texts.size() == 3;
  int used = 0;
  for (std::size_t n = 0; n < 3 && good; ++n) {
    const auto axis = axis_of(texts[n]);
    good = axis.has_value();
    if (good) axes[n] = *axis;
    if (good) used |= 1 << axes[n].from;
  }
  if (good && used == 7)
    def.axes = axes;
  else
    root.complain("axes", "axes does not name each of the device's axes once.",
                  "Write which axis points right, up and towards the visitor: [\"x\", \"z\", "
                  "\"-y\"].");
}

const Field& device_field(const char* table, const char* key) {
  return fields::field_at(device_fields(), table, key);
}

/// Three numbers within the field's range.
bool are_three(const std::vector<double>& numbers, const Field& wanted) {
  return numbers.size() == 3 && std::ranges::all_of(numbers, [&wanted](double value) {
           return value >= wanted.least && value <= wanted.most;
         });
}

void read_place(Table& root, const char* key, Vec3& out) {
  std::vector<double> numbers;
  if (!root.numbers(key, numbers)) return;
  const bool good = are_three(numbers, device_field("", key));
  if (good)
    out = {1e-3 * numbers[0], 1e-3 * numbers[1], 1e-3 * numbers[2]};
  else
    root.complain(key, std::string(key) + " is not three numbers within the range.",
                  "Write right, up and towards the visitor in mm: [60, 100, 20].");
}

/// Rejects a hand-typed limit that is above the theory's.
void check_limit(Table table, device::DeviceDef& def) {
  if (!def.stiffness_limit) return;
  const double bears = def.own_damping() / ((0.5 + def.body.delay) * kTick);
  if (*def.stiffness_limit <= bears / kMarginInFile * kRounding) return;
  def.stiffness_limit.reset();
  table.complain("stiffness_limit",
                 "stiffness_limit is too high for a device with this [body], so it is ignored.",
                 "Run onggi lab loop --write with this file, which derives and writes it.");
}

template <class Value>
void read_three(Table& table, const char* key, std::array<Value, 3>& out, double unit) {
  std::vector<double> numbers;
  if (!table.numbers(key, numbers)) return;
  if (!are_three(numbers, device_field("arm", key)))
    return table.complain(key, std::string(key) + " is not three numbers within the range.",
                          "Write one for each of the three bodies of the arm.");
  for (std::size_t n = 0; n < 3; ++n) out[n] = static_cast<Value>(unit * numbers[n]);
}

void read_force(Table table, device::DeviceDef& def) {
  fields::read_number(table, device_field("force", "max"), def.max_force);
  fields::read_number(table, device_field("force", "slew"), def.max_slew);
  fields::read_number(table, device_field("force", "ramp"), def.engage_time);
  fields::read_number(table, device_field("force", "damping"), def.damping);
  double limit = 0.0;
  if (fields::read_number(table, device_field("force", "stiffness_limit"), limit))
    def.stiffness_limit = limit;
  table.finish();
}

void read_body(Table table, device::DeviceBody& body) {
  fields::read_number(table, device_field("body", "mass"), body.mass);
  fields::read_number(table, device_field("body", "damping"), body.damping);
  fields::read_number(table, device_field("body", "friction"), body.friction);
  double step_mm = 1e3 * body.step;
  if (fields::read_number(table, device_field("body", "step_mm"), step_mm))
    body.step = 1e-3 * step_mm;
  fields::read_whole(table, device_field("body", "delay"), body.delay);
  table.finish();
}

void read_arm(Table table, device::ArmDef& arm) {
  read_three(table, "capstan_mm", arm.capstan, 1e-3);
  read_three(table, "body_mm", arm.body, 1e-3);
  read_three(table, "length_mm", arm.length, 1e-3);
  read_three(table, "torque", arm.torque, 1.0);
  read_three(table, "counts", arm.counts, 1.0);
  read_three(table, "parked", arm.parked, 1.0);
  fields::read_number(table, device_field("arm", "most_milliamperes"), arm.most_milliamperes);
  table.finish();
}

}  // namespace

DeviceRead read_device(const std::filesystem::path& file, const device::DeviceDef& usual) {
  DeviceRead read;
  read.def = usual;
  toml::TomlReader reader(file);
  auto root = reader.root();
  read_axes(root, read.def);
  read_place(root, "middle_mm", read.def.middle);
  read_place(root, "home_mm", read.def.home);
  fields::read_number(root, device_field("", "scale"), read.def.scale);
  fields::read_number(root, device_field("", "speed"), read.def.speed);
  fields::read_number(root, device_field("", "dead"), read.def.dead);
  fields::read_number(root, device_field("", "turn_speed"), read.def.turn_speed);
  fields::read_number(root, device_field("", "smoothing"), read.def.smoothing);
  fields::read_number(root, device_field("", "lifts_after"), read.def.lifts_after);
  read_force(root.child("force"), read.def);
  read_body(root.child("body"), read.def.body);
  check_limit(root.child("force"), read.def);
  read_arm(root.child("arm"), read.def.arm);
  root.finish();
  read.problems = reader.problems();
  read.keys_checked = reader.keys_checked();
  return read;
}

}  // namespace onggi::device
