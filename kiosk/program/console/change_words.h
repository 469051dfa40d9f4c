#pragma once

#include <string>
#include <vector>

#include "kiosk/ground/web/message.h"
#include "kiosk/program/console/edited_file.h"

namespace onggi::console {

/// {"faults": [{key, what, remedy}]}
web::Answer answer_of(const std::vector<ChangeFault>& faults, int status = 200);

/// The changes of a draft as `onggi set` and `onggi screen` take them.
struct ChangeWords {
  std::string without;             ///< Keys, commas between them.
  std::vector<std::string> pairs;  ///< KEY VALUE KEY VALUE ...
};
ChangeWords words_of(const changes::Draft& draft);

}  // namespace onggi::console
