#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace onggi::commands {

/// A folder of its own, gone with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "onggi-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Writes `folder`/exhibit.toml: the project's shelf, glazes and the scene `scene`, on one line
/// each, and then `more`, from line 4 on. Gives the file's name.
inline std::string write_exhibit(const TemporaryFolder& folder, const std::string& scene,
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
