#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::commands {

using files::test::content;
using files::test::ScratchFolder;

/// Writes `folder`/exhibit.toml: the project's shelf, glazes and the scene `scene`, on one line
/// each, and then `more`, from line 4 on. Gives the file's name.
inline std::string write_exhibit(const ScratchFolder& folder, const std::string& scene,
                                 const std::string& more) {
  const std::string here = std::filesystem::current_path().string();
  const std::string file = (folder / "exhibit.toml").string();
  std::ofstream(file) << "shelf = \"" << here << "/content/vessels\"\nglazes = \"" << here
                      << "/content/glazes.toml\"\nscene = \"" << here << "/config/scenes/" << scene
                      << ".toml\"\n"
                      << more;
  return file;
}

}  // namespace onggi::commands
