#pragma once

#include <cstdint>
#include <vector>

namespace onggi::files {

/// Call this inside a helper (helper_process.h) that reads untrusted files. It limits memory and
/// processor time from now on, and allows no file beyond the three streams and no core dump. When
/// the time is over the process prints `words` to standard error and exits with 1. `words` must
/// stay valid. Exits with 1 if the system cannot set the limits. Under a sanitizer, whose shadow
/// memory is larger than any limit, only time is limited.
void confine(unsigned long memory_mib, unsigned long seconds, const char* words);

/// All of standard input.
std::vector<std::uint8_t> standard_input();

}  // namespace onggi::files
