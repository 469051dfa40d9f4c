#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/profile/mesh.h"

namespace onggi::content {

/// An archaeological drawing as TOML: outer and inner outline, foot ring and rim, in millimetres.
/// The format, with an example, is in kiosk/docs/draw_a_vessel.md.
struct Drawing {
  std::string title;
  std::string source;  ///< Where the figures come from.
  Section section;     ///< Metres.
};

/// A drawing and everything found wrong with it; use `drawing` only where `problems` is empty.
struct DrawingRead {
  Drawing drawing;
  std::vector<Problem> problems;  ///< With file, line and column.
  int keys_checked = 0;
};
DrawingRead check_drawing(const std::filesystem::path& toml);

/// The drawing, or the first Problem of check_drawing().
Result<Drawing> read_drawing(const std::filesystem::path& toml);

}  // namespace onggi::content
