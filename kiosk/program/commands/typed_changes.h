#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/collection/changes/draft.h"

namespace onggi::commands {

/// The changes that `words` (KEY VALUE KEY VALUE ...) and `without` (keys with commas between them)
/// ask for. Problem, exit 2, where a key has no value. `command`: of which it is said.
Result<std::vector<changes::Change>> typed_changes(const std::vector<std::string>& words,
                                                   const std::string& without,
                                                   const std::string& command);

}  // namespace onggi::commands
