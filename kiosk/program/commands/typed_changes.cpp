#include "kiosk/program/commands/typed_changes.h"

#include <cstddef>
#include <sstream>

namespace onggi::commands {

Result<std::vector<changes::Change>> typed_changes(const std::vector<std::string>& words,
                                                   const std::string& without,
                                                   const std::string& command) {
  if (words.size() % 2 != 0)
    return problem(command, "The key " + words.back() + " has no value.",
                   "Write a value behind each key; one with spaces in quotes: "
                   "credit 'Museum of Clay'.");
  std::vector<changes::Change> all;
  for (std::size_t n = 0; n < words.size(); n += 2) all.push_back({words[n], words[n + 1]});
  std::istringstream keys(without);
  for (std::string key; std::getline(keys, key, ',');) all.push_back({key, std::nullopt});
  return all;
}

}  // namespace onggi::commands
