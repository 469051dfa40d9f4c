#include "kiosk/program/commands/lab_program.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace onggi::commands {

std::optional<std::vector<std::string>> words_for_laboratory(
    const std::vector<std::string>& words) {
  if (words.empty()) return {};
  if (words.front() == "soak") return words;
  // onggi's own help names tune and prices, and says where the other commands are.
  if (words.front() != "lab" || words.size() == 1 || words[1] == "tune" || words[1] == "prices" ||
      words[1] == "--help" || words[1] == "-h")
    return {};
  return std::vector<std::string>(words.begin() + 1, words.end());
}

Problem become_laboratory(const std::vector<std::string>& words) {
  std::error_code none;
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe", none).parent_path() / "onggi-lab";
  std::string name = "onggi-lab";
  std::vector<char*> arguments{name.data()};
  std::vector<std::string> copies = words;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execv(program.c_str(), arguments.data());
  if (errno == ENOENT)
    return {program.string(), "The laboratory is not installed.",
            "Install the package onggi-lab, or build the target onggi-lab. \"onggi lab tune\" "
            "and \"onggi lab prices\" work without it.",
            2};
  return {program.string(), std::string("It cannot be started: ") + std::strerror(errno) + ".",
          "Install the package onggi-lab again.", 1};
}

}  // namespace onggi::commands
