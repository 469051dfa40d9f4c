#pragma once

#include <filesystem>

#include "engine/base/result.h"

namespace onggi::commands {

/// Makes the folder of `onggi visit --out` if it is missing. Problem if it belongs to the exhibit
/// `config`, or if anything lies in it that no earlier `onggi visit` wrote: the visit would be
/// mixed with it, and would write over it.
Result<void> make_visit_out(const std::filesystem::path& out, const std::filesystem::path& config);

}  // namespace onggi::commands
