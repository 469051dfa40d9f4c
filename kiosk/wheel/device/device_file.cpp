#include "kiosk/wheel/device/device_file.h"

#include <optional>
#include <string>

#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::device {

namespace {

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

void read_place(Table& root, const char* key, Vec3& out, double most) {
  std::vector<double> numbers;
  if (!root.numbers(key, numbers)) return;
  bool good = numbers.size() == 3;
  for (const double value : numbers) good = good && value >= -most && value <= most;
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
void read_three(Table& table, const char* key, std::array<Value, 3>& out, double low, double high,
                double unit) {
  std::vector<double> numbers;
  if (!table.numbers(key, numbers)) return;
  bool good = numbers.size() == 3;
  for (const double value : numbers) good = good && value >= low && value <= high;
  if (!good)
    return table.complain(key, std::string(key) + " is not three numbers within the range.",
                          "Write one for each of the three bodies of the arm.");
  for (std::size_t n = 0; n < 3; ++n) out[n] = static_cast<Value>(unit * numbers[n]);
}

void read_force(Table table, device::DeviceDef& def) {
  table.number("max", def.max_force, 0.0, 22.2, "N");
  table.number("slew", def.max_slew, 10.0, 1e5, "N/s");
  table.number("ramp", def.engage_time, 0.05, 5.0, "s");
  table.number("damping", def.damping, 0.0, 20.0, "N s/m");
  double limit = 0.0;
  if (table.number("stiffness_limit", limit, 5.0, 1e5, "N/m")) def.stiffness_limit = limit;
  table.finish();
}

void read_body(Table table, device::DeviceBody& body) {
  table.number("mass", body.mass, 0.005, 5.0, "kg");
  table.number("damping", body.damping, 0.0, 20.0, "N s/m");
  table.number("friction", body.friction, 0.0, 5.0, "N");
  double step_mm = 1e3 * body.step;
  if (table.number("step_mm", step_mm, 0.0, 1.0, "mm")) body.step = 1e-3 * step_mm;
  table.integer("delay", body.delay, 0, 8, "ticks");
  table.finish();
}

void read_arm(Table table, device::ArmDef& arm) {
  read_three(table, "capstan_mm", arm.capstan, 1.0, 200.0, 1e-3);
  read_three(table, "body_mm", arm.body, 10.0, 1000.0, 1e-3);
  read_three(table, "length_mm", arm.length, 10.0, 2000.0, 1e-3);
  read_three(table, "torque", arm.torque, 0.001, 10.0, 1.0);
  read_three(table, "counts", arm.counts, 10.0, 1e6, 1.0);
  read_three(table, "parked", arm.parked, -32768.0, 32767.0, 1.0);
  table.number("most_milliamperes", arm.most_milliamperes, 0.0, 32767.0, "mA");
  table.finish();
}

}  // namespace

DeviceRead read_device(const std::filesystem::path& file, const device::DeviceDef& usual) {
  DeviceRead read;
  read.def = usual;
  toml::TomlReader reader(file);
  auto root = reader.root();
  read_axes(root, read.def);
  read_place(root, "middle_mm", read.def.middle, 500.0);
  read_place(root, "home_mm", read.def.home, 450.0);
  root.number("scale", read.def.scale, 0.1, 10.0);
  root.number("speed", read.def.speed, 0.01, 1.0, "m/s");
  root.number("dead", read.def.dead, 0.0, 0.5);
  root.number("turn_speed", read.def.turn_speed, 0.0, 10.0, "rad/s");
  root.number("smoothing", read.def.smoothing, 0.0, 0.05, "s");
  root.number("lifts_after", read.def.lifts_after, 0.1, 30.0, "s");
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
