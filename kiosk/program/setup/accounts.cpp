#include "kiosk/program/setup/accounts.h"

#include <charconv>
#include <fstream>
#include <sstream>
#include <vector>

namespace onggi::setup {

namespace {

std::optional<unsigned> number_in(const std::string& text) {
  unsigned number = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || at != end) return {};
  return number;
}

/// The numbers of `name` in a list of users or groups: its third field, and those behind it.
std::vector<std::optional<unsigned>> numbers_of(const System& system, const char* list,
                                                const std::string& name, std::size_t count) {
  std::ifstream lines(system.at(list));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string found, field;
    std::getline(fields, found, ':');
    std::getline(fields, field, ':');
    if (found != name) continue;
    std::vector<std::optional<unsigned>> numbers;
    for (std::size_t n = 0; n < count; ++n)
      numbers.push_back(std::getline(fields, field, ':') ? number_in(field) : std::nullopt);
    return numbers;
  }
  return std::vector<std::optional<unsigned>>(count);
}

}  // namespace

Result<Owner> user_of(const System& system, const std::string& name) {
  const auto numbers = numbers_of(system, "/etc/passwd", name, 2);
  if (numbers[0] && numbers[1]) return Owner{*numbers[0], *numbers[1]};
  return problem(system.at("/etc/passwd").string(), "There is no user " + name + ".",
                 "Install the package onggi, which creates it.", 1);
}

Result<gid_t> group_of(const System& system, const std::string& name) {
  if (const auto number = numbers_of(system, "/etc/group", name, 1)[0]) return *number;
  return problem(system.at("/etc/group").string(), "There is no group " + name + ".",
                 "Install the package onggi, which creates it.", 1);
}

}  // namespace onggi::setup
