#pragma once

#include "engine/base/result.h"
#include "kiosk/program/setup/step.h"

namespace onggi::setup {

/// Step::Kind::share: lets the group `step.from` write in the folder `step.to`, which is made if it
/// is missing. A group of the museum's own is replaced there; other rights stay. Of the folder of
/// keepsakes (kKeepsakesGroup): in it and in the kiosk's folders beneath it, so that a visit can be
/// deleted; the store of visits there is shut to others. Of another: in every folder and file
/// beneath it; what is made there later is the group's, and to be written by it once this was done
/// again. Follows no link. Problem, exit 1.
Result<Change> share(const Step& step, const System& system, bool dry);

/// Takes the group's right in the exhibit back; keepsakes keep theirs, which visitors' phones need.
Result<Change> unshare(const Step& step, const System& system, bool dry);

}  // namespace onggi::setup
