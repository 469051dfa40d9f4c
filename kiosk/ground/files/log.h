#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::files {

/// Writes a line with the time to standard error. Main thread and workers only; never the 1 kHz
/// loop.
void log_line(const std::string& line);
void log_problem(const Problem& p);
void log_problems(const std::vector<Problem>& problems);

}  // namespace onggi::files
