#pragma once

#include "engine/base/result.h"

namespace onggi::files {

/// Writes what standard output still holds. Problem, exit 1, if it did not take everything that was
/// printed: its disk is full, or its reader has gone.
Result<void> all_printed();

}  // namespace onggi::files
