#include "kiosk/program/console/line_keys.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace onggi::console {

LineKeys::LineKeys(const std::string& text, std::string name)
    : places_(text), name_(std::move(name) + ':') {
  std::vector<std::size_t> begins{0};
  for (std::size_t at = 0; at < text.size(); ++at)
    if (text[at] == '\n') begins.push_back(at + 1);
  const auto line = [&begins](std::size_t at) {
    return static_cast<std::size_t>(std::ranges::upper_bound(begins, at) - begins.begin());
  };
  for (const toml::TomlPlaces::Value& value : places_.values())
    values_.emplace(line(value.begin), &value);
  for (const toml::TomlPlaces::Header& header : places_.headers())
    if (!header.path.empty()) headers_.emplace(line(header.begin), &header);
}

std::size_t LineKeys::line_of(const Problem& problem) const {
  if (!problem.where.starts_with(name_)) return 0;
  return std::strtoul(problem.where.c_str() + name_.size(), nullptr, 10);
}

const toml::TomlPlaces::Value* LineKeys::value_at(const Problem& problem) const {
  const auto found = values_.find(line_of(problem));
  return found == values_.end() ? nullptr : found->second;
}

const toml::TomlPlaces::Header* LineKeys::header_at(const Problem& problem) const {
  const auto found = headers_.find(line_of(problem));
  return found == headers_.end() ? nullptr : found->second;
}

}  // namespace onggi::console
