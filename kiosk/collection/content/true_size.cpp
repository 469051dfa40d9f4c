#include "kiosk/collection/content/true_size.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace onggi::content {

namespace {

/// Sizes of thrown vessels, from a toy dish to a storage jar, metres.
constexpr double kLeastHeight = 0.004, kMostHeight = 2.0;
constexpr double kLeastWidest = 0.010, kMostWidest = 1.5;
/// Height and width ratios, from a flat dish to a stem.
constexpr double kFlattest = 40.0, kSlimmest = 25.0;
/// For a guess, in metres: the range of the larger of height and width, the likeliest value, and
/// the size shown if no guess is possible.
constexpr double kLeastUsual = 0.04, kMostUsual = 0.8, kLikely = 0.2, kShown = 0.3;

bool held(const FileSize& s, double unit) {
  const double h = s.height * unit, w = s.widest * unit;
  return h >= kLeastHeight && h <= kMostHeight && w >= kLeastWidest && w <= kMostWidest;
}

std::string in_words(const FileSize& s, double unit) {
  return three_digits(1000.0 * s.height * unit) + " mm tall and " +
         three_digits(1000.0 * s.widest * unit) + " mm wide";
}

TrueSize guessed(const FileSize& size, const ToldSize& told) {
  struct Unit {
    double metres;
    const char* name;
  };
  const double most = std::max(size.height, size.widest);
  const Unit* best = nullptr;
  static constexpr Unit kUnits[] = {{1.0, "metres"}, {0.01, "centimetres"}, {0.001, "millimetres"}};
  for (const Unit& unit : kUnits) {
    const double large = most * unit.metres;
    if (large < kLeastUsual || large > kMostUsual || !held(size, unit.metres)) continue;
    if (best == nullptr ||
        std::abs(std::log(large / kLikely)) < std::abs(std::log(most * best->metres / kLikely)))
      best = &unit;
  }
  const std::string own =
      three_digits(size.height) + " units tall and " + three_digits(size.widest) + " wide";
  const std::string ask =
      " Write true_height_mm, true_diameter_mm or units in vessel.toml to set it.";
  TrueSize out;
  out.from = best != nullptr ? SizeFrom::guess : SizeFrom::unknown;
  out.unit = best != nullptr ? best->metres : kShown / most;
  if (best != nullptr)
    out.doubt = "Its true size is a guess: it is " + own +
                (told.format_unit == 1.0 ? ". They cannot be metres; in " : "; in ") + best->name +
                " the vessel is " + in_words(size, out.unit) + "." + ask;
  else
    out.doubt =
        "Its true size is not known: it is " + own +
        ", which is no size for a vessel in metres, centimetres or millimetres. It is shown " +
        in_words(size, out.unit) + "." + ask;
  return out;
}

}  // namespace

std::string three_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

const char* name_of(SizeFrom from) {
  switch (from) {
    case SizeFrom::height:
      return "height";
    case SizeFrom::diameter:
      return "diameter";
    case SizeFrom::units:
      return "units";
    case SizeFrom::file:
      return "file";
    case SizeFrom::guess:
      return "guess";
    case SizeFrom::unknown:
      break;
  }
  return "unknown";
}

Result<TrueSize> true_size(const FileSize& size, const ToldSize& told, const std::string& name) {
  if (size.widest > kFlattest * size.height || size.height > kSlimmest * size.widest)
    return problem(name,
                   "it has no shape for a wheel: it is " + three_digits(size.height) +
                       " units tall and " + three_digits(size.widest) + " wide.",
                   "Export the vessel alone, with its scale applied alike to all three axes.");
  TrueSize out;
  if (told.height > 0.0)
    out = {told.height / size.height, SizeFrom::height, ""};
  else if (told.diameter > 0.0)
    out = {told.diameter / size.widest, SizeFrom::diameter, ""};
  else if (told.unit > 0.0)
    out = {told.unit, SizeFrom::units, ""};
  else if (told.format_unit > 0.0 && held(size, told.format_unit))
    out = {told.format_unit, SizeFrom::file, ""};
  else
    return guessed(size, told);
  if (!held(size, out.unit))
    return problem(
        name, "it has no size for a wheel: vessel.toml makes it " + in_words(size, out.unit) + ".",
        "Correct true_height_mm, true_diameter_mm or units in vessel.toml.");
  return out;
}

}  // namespace onggi::content
