#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace onggi::toml {

/// A text in a TOML file: the value of a key, or an element of a list.
struct TextAt {
  std::string where;  ///< "file:line:column"
  std::string text;
};

/// Every text of `file`, in file order, whatever its key. None where the file cannot be read as
/// TOML: TomlReader says why.
std::vector<TextAt> texts_of(const std::filesystem::path& file);

}  // namespace onggi::toml
