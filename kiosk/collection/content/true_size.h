#pragma once

#include <string>

#include "engine/base/result.h"

namespace onggi::content {

/// The source of a vessel's size.
enum class SizeFrom {
  height,    ///< true_height_mm of vessel.toml.
  diameter,  ///< true_diameter_mm.
  units,     ///< units.
  file,      ///< The format's own unit, if that gives a possible vessel.
  guess,     ///< Another unit that gives a possible vessel.
  unknown,   ///< Not known: it is shown at a medium size.
};

/// True if remarks may give millimetres of the real vessel.
inline bool is_known(SizeFrom from) { return from < SizeFrom::guess; }

/// "height", "guess": as reports write it.
const char* name_of(SizeFrom from);

/// A vessel, or the largest of a set in one unit; in the file's units.
struct FileSize {
  double height = 0.0, widest = 0.0;
};

/// The size as given by the pack, in metres; 0: not given.
struct ToldSize {
  double height = 0.0, diameter = 0.0;
  double unit = 0.0;         ///< Metres in a unit of the file.
  double format_unit = 1.0;  ///< The same, by the rules of its format; 0: the format has none.
};

struct TrueSize {
  double unit = 1.0;  ///< Metres in a unit of the file.
  SizeFrom from = SizeFrom::file;
  std::string doubt;  ///< What the curator should know and write; empty if the size is known.
};

/// A size as remarks write it: "12.3", in three digits.
std::string three_digits(double value);

/// Finds how long one unit of a file is. `size` must be above 0. Problem, by `name`, for a shape
/// that no wheel can hold: a needle, a sheet, or a vessel that is too large or too small at the
/// given size.
Result<TrueSize> true_size(const FileSize& size, const ToldSize& told, const std::string& name);

}  // namespace onggi::content
