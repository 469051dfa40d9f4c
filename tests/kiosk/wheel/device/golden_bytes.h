#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace onggi::device {

/// The golden bytes that kiosk/docs/onggi-hid.md prints, by name: what a maker reads is what is
/// tested. Empty when the page has none.
inline std::map<std::string, std::vector<std::uint8_t>> golden_bytes() {
  std::ifstream page("kiosk/docs/onggi-hid.md");
  std::map<std::string, std::vector<std::uint8_t>> all;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("```")) {
      inside = line == "```golden";
      continue;
    }
    if (!inside) continue;
    std::istringstream words(line);
    std::string name, byte;
    words >> name;
    while (words >> byte)
      all[name].push_back(static_cast<std::uint8_t>(std::stoi(byte, nullptr, 16)));
  }
  return all;
}

}  // namespace onggi::device
