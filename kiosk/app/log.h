#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::app {

/// Main thread and workers only; never the 1 kHz loop. Lines go to standard error with the time.
void log_line(const std::string& line);
void log_problem(const Problem& p);
void log_problems(const std::vector<Problem>& problems);

/// Prints `p` to standard error in its one form and gives its exit code, for a command to return.
int exit_with(const Problem& p);

}  // namespace onggi::app
