#pragma once

#include "kiosk/keepsake/store/database.h"

namespace onggi::store {

/// The version that this program writes. A file's version is `PRAGMA user_version`; 0 is an empty
/// file.
int newest_version();

/// Migrates a file, one step and transaction a version, up to `version` (1 .. newest_version();
/// tests make old files that way). Rows are kept. False if the file's version is newer than this
/// program's, or if a step failed; the file is then as it was before that step.
bool migrate(Database& database, int version = newest_version());

}  // namespace onggi::store
