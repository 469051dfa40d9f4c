#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

namespace onggi::toml::test {

/// Every TOML file that a curator may change: config/ and content/, in the order of names.
inline std::vector<std::filesystem::path> real_files() {
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"config", "content"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace onggi::toml::test
