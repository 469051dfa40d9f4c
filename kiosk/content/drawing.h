#pragma once

#include <filesystem>

#include "engine/base/result.h"
#include "engine/profile/mesh.h"

namespace onggi::content {

/// An archaeological drawing as TOML: outer and inner outline, foot ring and rim, in millimetres.
/// The format, with an example, is in kiosk/docs/curators.md.
struct Drawing {
  std::string title;
  std::string source;  ///< Where the figures come from.
  Section section;     ///< Metres.
};

/// Problems with line and column.
Result<Drawing> read_drawing(const std::filesystem::path& toml);

}  // namespace onggi::content
