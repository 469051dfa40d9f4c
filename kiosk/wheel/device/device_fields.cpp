#include "kiosk/wheel/device/device_fields.h"

#include <string>

namespace onggi::device {
namespace {

using fields::Field;
using fields::FieldKind;

Field number_field(const char* table, const char* key, const char* unit, double least, double most,
                   const char* usual, const char* words) {
  return {.table = table,
          .key = key,
          .kind = FieldKind::number,
          .words = words,
          .least = least,
          .most = most,
          .unit = unit,
          .usual = usual};
}

/// Three numbers, each within the range.
Field three_field(const char* table, const char* key, const char* unit, double least, double most,
                  const char* usual, const char* words) {
  Field out = number_field(table, key, unit, least, most, usual, words);
  out.kind = FieldKind::list;
  out.range = std::string("three") + (*unit == '\0' ? ", " : std::string(" of ") + unit + ", ") +
              fields::bounds_words(out);
  return out;
}

fields::FieldList all_device_fields() {
  const char* const body = "body";
  const char* const arm = "arm";
  fields::FieldList list{
      "devices/KIND.toml",
      {
          {.key = "axes",
           .kind = FieldKind::texts,
           .words = "its axes that go right, up and towards the visitor",
           .range = "each of `\"x\"`, `\"y\"`, `\"z\"` once, `-` before it turns it round",
           .usual = "as the kind has them"},
          three_field("", "middle_mm", "mm", -500, 500, "[0, 0, 0]",
                      "middle of its workspace, along those axes"),
          three_field("", "home_mm", "mm", -450, 450,
                      "puck and sticks `[120, 100, 40]`, handles `[60, 100, 20]`",
                      "where that middle lies, or a puck or stick begins: right, up, towards the "
                      "visitor, from the wheel head's middle"),
          number_field("", "scale", "", 0.1, 10, "1.0", "way of the tool / way of the handle"),
          number_field("", "speed", "m/s", 0.01, 1, "0.16; sticks 0.10",
                       "of the tool at the greatest push"),
          number_field("", "dead", "", 0, 0.5, "0.06; sticks 0.12",
                       "share of its way that is no push"),
          number_field("", "turn_speed", "rad/s", 0, 10, "2.0",
                       "of the tool at a puck's greatest twist"),
          number_field("", "smoothing", "s", 0, 0.05, "0.008; handles 0",
                       "joins reports slower than the ticks"),
          number_field("", "lifts_after", "s", 0.1, 30, "0.7",
                       "a puck at rest this long lifts the tool"),
          number_field("force", "max", "N", 0, 22.2, "3.3",
                       "greatest force; the device's own limit if that is less"),
          number_field("force", "slew", "N/s", 10, 100000, "600",
                       "fastest change of force, except to end it"),
          number_field("force", "ramp", "s", 0.05, 5, "0.5", "time from no force to full force"),
          number_field("force", "damping", "N s/m", 0, 20, "0", "that the device adds (onggi-hid)"),
          number_field(
              "force", "stiffness_limit", "N/m", 5, 100000, "none",
              "stiffest spring between hand and tool; `onggi lab loop --write "
              "config/devices/KIND.toml` (package `onggi-lab`) derives it from `[body]`; a "
              "value that theory does not support is ignored. **Without it: no more than 1 N "
              "through 19 N/m**"),
          number_field(body, "mass", "kg", 0.005, 5, "0.045", "of the handle, as felt"),
          number_field(body, "damping", "N s/m", 0, 20, "0.1",
                       "how fast the handle's swing dies away"),
          number_field(body, "friction", "N", 0, 5, "0", "least force that moves it"),
          number_field(body, "step_mm", "mm", 0, 1, "0.055", "smallest step of its encoders"),
          number_field(body, "delay", "ticks", 0, 8, "3", "of 1 ms, from position to force"),
          three_field(arm, "capstan_mm", "mm", 1, 200, "[10, 10, 10]",
                      "diameters of the motors' capstans"),
          three_field(arm, "body_mm", "mm", 10, 1000, "[160, 120, 120]",
                      "diameters of what they turn"),
          three_field(arm, "length_mm", "mm", 10, 2000, "[80, 205, 245]",
                      "height of the first joint, then the links"),
          three_field(arm, "torque", "N m a ampere", 0.001, 10, "[0.0259, 0.0259, 0.0259]",
                      "of the motors"),
          three_field(arm, "counts", "", 10, 1000000, "[2000, 2000, 2000]", "of a motor's turn"),
          three_field(arm, "parked", "", -32768, 32767, "[0, 0, 6000]", "counts when switched on"),
          number_field(arm, "most_milliamperes", "mA", 0, 32767, "2000",
                       "of any motor; all are reduced together"),
      }};
  for (Field& field : list.fields)
    if (field.key == "delay") field.kind = FieldKind::whole;
  return list;
}

}  // namespace

const fields::FieldList& device_fields() {
  static const fields::FieldList kList = all_device_fields();
  return kList;
}

}  // namespace onggi::device
