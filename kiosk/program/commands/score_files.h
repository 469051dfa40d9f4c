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
  Profile profile;        ///< Metres; a replay's has the size at which it was thrown.
  bool true_size = true;  ///< False if the file's unit was guessed.
};

/// Reads a GLB or glTF, a vessel pack (its folder or vessel.toml), a drawing's TOML, or a replay,
/// which is simulated again. `node` names an object of a set. Problem for anything else. Allocates;
/// reads files.
Result<Shape> read_shape(const std::filesystem::path& file, const std::string& node = {});

}  // namespace onggi::commands
