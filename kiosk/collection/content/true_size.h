#pragma once

#include <string>

#include "engine/base/result.h"

namespace onggi::content {

/// What told how large a vessel is.
enum class SizeFrom {
  height,    ///< true_height_mm of vessel.toml.
  diameter,  ///< true_diameter_mm.
  units,     ///< units.
  file,      ///< The format's own unit, in which it is a vessel.
  guess,     ///< Another unit, in which it is one.
  unknown,   ///< Nothing: it is shown at a middling size.
};

/// Whether remarks may speak in millimetres of the real vessel.
inline bool is_known(SizeFrom from) { return from < SizeFrom::guess; }

/// "height", "guess": as reports write it.
const char* name_of(SizeFrom from);

/// A vessel, or the largest of a set that was modelled in one unit; in units of its file.
struct FileSize {
  double height = 0.0, widest = 0.0;
};

/// What is said of its size, in metres; 0: not said.
struct ToldSize {
  double height = 0.0, diameter = 0.0;
  double unit = 0.0;         ///< Metres in a unit of the file.
  double format_unit = 1.0;  ///< The same, by the rules of its format; 0: it has none.
};

struct TrueSize {
  double unit = 1.0;  ///< Metres in a unit of the file.
  SizeFrom from = SizeFrom::file;
  std::string doubt;  ///< What a curator should know and write; empty where it is known.
};

/// Settles what a unit of a file is worth. `size` must be above 0. Problem, by `name`, for what no
/// wheel ever held: a needle, a sheet, or what is too large or small at the size that was told.
Result<TrueSize> true_size(const FileSize& size, const ToldSize& told, const std::string& name);

}  // namespace onggi::content
