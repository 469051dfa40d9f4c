#pragma once

#include "kiosk/keepsake/store/database.h"

namespace onggi::store {

/// The version that this program writes. `PRAGMA user_version` says a file's; 0 is an empty file.
int newest_version();

/// Brings a file forward, a step and a transaction a version, to `version` at most (1 ..
/// newest_version(); tests make a file of each former version so). Rows stay. False where the
/// file's version is newer than this program's, or a step failed: then the file is as it was before
/// that step.
bool migrate(Database& database, int version = newest_version());

}  // namespace onggi::store
