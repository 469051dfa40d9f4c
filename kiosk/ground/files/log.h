#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::files {

/// Writes a line with the time to standard error. Main thread and workers only; never the 1 kHz
/// loop.
void log_line(const std::string& line);
void log_problem(const Problem& p);
void log_problems(const std::vector<Problem>& problems);

/// A problem that stands in the log.
struct Trouble {
  Problem problem;
  std::int64_t at = 0;      ///< When it was logged, s since 1970.
  std::uint64_t count = 0;  ///< How many problems this process has logged, with this one.
};
/// The last one of this process. Any thread.
std::optional<Trouble> last_trouble();

}  // namespace onggi::files
