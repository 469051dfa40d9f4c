#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::commands {

using files::test::content;
using files::test::ScratchFolder;

/// Writes `folder`/exhibit.toml: the project's shelf, glazes and the scene `scene`, on one line
/// each, and then `more`, from line 4 on. Where `vessels` are named, the shelf has copies of these
/// alone, in `folder`/shelf: to read all of the project's takes a program seconds. Gives the file's
/// name.
inline std::string write_exhibit(const ScratchFolder& folder, const std::string& scene,
                                 const std::string& more,
                                 const std::vector<std::string>& vessels = {}) {
  namespace fs = std::filesystem;
  const fs::path here = fs::current_path(), all = here / "content/vessels";
  const fs::path shelf = vessels.empty() ? all : folder / "shelf";
  if (!vessels.empty()) fs::create_directories(shelf);
  for (const std::string& vessel : vessels)
    fs::copy(all / vessel, shelf / vessel,
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  const std::string file = (folder / "exhibit.toml").string();
  std::ofstream(file) << "shelf = \"" << shelf.string() << "\"\nglazes = \"" << here.string()
                      << "/content/glazes.toml\"\nscene = \"" << here.string() << "/config/scenes/"
                      << scene << ".toml\"\n"
                      << more;
  return file;
}

}  // namespace onggi::commands
