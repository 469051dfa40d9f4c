#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::commands {

/// The words of a command line (without the program's name) that are for the program onggi-lab:
/// what follows "lab", or "soak" with what follows. None where onggi answers itself: other
/// commands, and "lab tune".
std::optional<std::vector<std::string>> words_for_laboratory(const std::vector<std::string>& words);

/// Becomes onggi-lab, the program beside this one, with these words: returns only where that
/// cannot be. Problem (exit 2) where the laboratory is not installed. Call from main, before any
/// thread.
Problem become_laboratory(const std::vector<std::string>& words);

}  // namespace onggi::commands
