#pragma once

#include <filesystem>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/picture/render/font_coverage.h"

namespace onggi::exhibit {

/// What the fonts of a machine say of the texts in some files.
struct LettersReport {
  std::vector<Problem> notes;     ///< Texts of which some letters would be boxes.
  std::vector<Problem> problems;  ///< Texts of which every letter would be a box.
};

/// Looks at every text of those of `files` that are TOML. Any thread.
LettersReport check_letters(const std::vector<std::filesystem::path>& files,
                            const render::FontCoverage& fonts);

}  // namespace onggi::exhibit
