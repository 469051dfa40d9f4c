#pragma once

#include <string>

#include "engine/base/result.h"
#include "kiosk/exhibit/composition/kiosk.h"

namespace onggi::commands {

/// Index among the shelf's cards of the vessel `id`; "": the first. `searched`: the shelf, for
/// messages. Problem, exit 2: it is not there, with the nearest name; or nothing is.
Result<int> card_on_shelf(exhibit::Shelf& shelf, const std::string& searched,
                          const std::string& id);

}  // namespace onggi::commands
