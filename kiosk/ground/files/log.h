#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::files {

/// Main thread and workers only; never the 1 kHz loop. Lines go to standard error with the time.
void log_line(const std::string& line);
void log_problem(const Problem& p);
void log_problems(const std::vector<Problem>& problems);

}  // namespace onggi::files
