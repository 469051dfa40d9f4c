#pragma once

#include <cstdint>
#include <vector>

namespace onggi::files {

/// From inside a helper (helper_process.h) that reads what nobody made in particular: no more than
/// this memory and processor time from now on, no file but the three streams, no core. When its
/// time is over it ends with exit 1 and `words` on standard error, not with a bare kill. `words`
/// stay where they are. Ends the process (exit 1) where the system sets no such limits. Under a
/// sanitizer, whose shadow is larger than any memory, only time is limited.
void confine(unsigned long memory_mib, unsigned long seconds, const char* words);

/// All of standard input.
std::vector<std::uint8_t> standard_input();

}  // namespace onggi::files
