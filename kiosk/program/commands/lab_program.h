#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::commands {

/// The arguments (without the program's name) for the program onggi-lab: those after "lab", or
/// "soak" and those after it. None if onggi answers itself: other commands, "lab tune", "lab
/// prices", and "lab" or "lab --help", which say where the rest is.
std::optional<std::vector<std::string>> words_for_laboratory(const std::vector<std::string>& words);

/// Replaces this process with onggi-lab, the program beside this one, with these arguments. Returns
/// only on failure. Problem (exit 2) if the laboratory is not installed. Call from main, before any
/// thread.
Problem become_laboratory(const std::vector<std::string>& words);

}  // namespace onggi::commands
