#pragma once

#include "kiosk/ground/files/json.h"

namespace onggi::ends {

/// Every key that a curator's files may have, with the ends of what `onggi check` accepts, from the
/// lists that the program itself reads by: {file, table, key, ends: ["20", "3600"]} with values as
/// TOML writes them, or {file, table, key, letters, wide, lines} for a text. `file`: "exhibit",
/// "scene" (every effect but [paper]), "paper", "rubric", "pack", "label", "glaze", "step",
/// "mission". Allocates.
files::Json every_key();

}  // namespace onggi::ends
