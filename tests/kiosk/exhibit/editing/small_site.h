#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::editing::test {

namespace fs = std::filesystem;
using files::test::content;

/// A museum's exhibit with one vessel, copied from the one that ships.
class SmallSite {
 public:
  SmallSite() {
    fs::create_directories(folder_ / "content/vessels");
    fs::copy("config", folder_ / "config", fs::copy_options::recursive);
    for (const char* one : {"languages", "lessons", "ways"})
      fs::copy(fs::path("content") / one, folder_ / "content" / one);
    for (const char* one : {"glazes.toml", "missions.toml", "names.toml"})
      fs::copy(fs::path("content") / one, folder_ / "content" / one);
    fs::copy("content/vessels/moon_jar", folder_ / "content/vessels/moon_jar");
  }
  fs::path operator/(const fs::path& name) const { return folder_ / name; }
  const fs::path& path() const { return folder_.path(); }
  fs::path exhibit() const { return folder_ / "config/exhibit.toml"; }

  /// The text of each file in config/ and content/, by name.
  std::map<std::string, std::string> texts() const {
    std::map<std::string, std::string> out;
    for (const char* folder : {"config", "content"})
      for (const auto& entry : fs::recursive_directory_iterator(folder_ / folder))
        if (entry.is_regular_file()) out[entry.path().string()] = content(entry.path());
    return out;
  }
  void write(const fs::path& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  /// Changes the file as a hand with an editor does.
  void by_hand(const fs::path& name, const std::string& what, const std::string& with) const {
    std::string text = content(folder_ / name);
    text.replace(text.find(what), what.size(), with);
    write(name, text);
  }

 private:
  const files::test::ScratchFolder folder_;
};

inline std::string replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

}  // namespace onggi::editing::test
