#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::editing {

/// The faults that `onggi check` would find if `file` held `text`, and that it does not find now:
/// in the whole exhibit where `file` is one or belongs to one. Old faults are no reason to refuse a
/// change. `onggi check` calls the file by its real name and line. Reads the exhibit once, twice
/// where there are faults: 1 to 2 s for twelve vessels.
std::vector<Problem> new_faults(const std::filesystem::path& file, const std::string& text);

}  // namespace onggi::editing
