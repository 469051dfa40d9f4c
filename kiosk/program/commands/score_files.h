#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"
#include "engine/profile/profile.h"

namespace onggi::commands {

/// Anything that has a profile, read from a file.
struct Shape {
  std::string file, node;
  std::string kind;       ///< "vessel", "drawing" or "replay".
  Profile profile;        ///< Metres; a replay's is of the size it was thrown.
  bool true_size = true;  ///< False where the file's unit was guessed.
};

/// Reads a GLB or glTF, a vessel pack (its folder or vessel.toml), a drawing's TOML, or a replay,
/// which is thrown again. `node` names the object of a set. A Problem for anything else. Allocates;
/// reads files.
Result<Shape> read_shape(const std::filesystem::path& file, const std::string& node = {});

}  // namespace onggi::commands
