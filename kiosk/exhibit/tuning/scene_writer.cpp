#include "kiosk/exhibit/tuning/scene_writer.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "kiosk/collection/settings/scene_file.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/toml/toml_text.h"

namespace onggi::tuning {
namespace {

std::string_view trimmed(std::string_view line) {
  const auto first = line.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

// "rows" of "rows = 400   # and why".
std::string_view key_of(std::string_view line) {
  line = trimmed(line);
  const auto end = line.find_first_of(" \t=");
  const auto sign = line.find('=');
  if (line.starts_with('#') || sign == std::string_view::npos) return {};
  return line.substr(0, end);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

}  // namespace

std::string with_grid(const std::string& toml, int rows, int sectors, const std::string& note) {
  const std::vector<std::string> grid{"rows = " + std::to_string(rows) + "  # " + note,
                                      "sectors = " + std::to_string(sectors)};
  std::string out;
  bool in_clay = false, written = false, at_top = true;
  for (const std::string& line : lines_of(toml)) {
    const std::string_view words = trimmed(line);
    if (words.starts_with('[')) {
      at_top = false;
      in_clay = words == "[clay]" || words.starts_with("[clay] ") || words.starts_with("[clay]#");
      out += line + "\n";
      if (in_clay && !written)
        for (const std::string& one : grid) out += one + "\n";
      written = written || in_clay;
      continue;
    }
    const std::string_view key = key_of(line);
    if ((in_clay && (key == "rows" || key == "sectors")) || (at_top && key == "quality")) continue;
    out += line + "\n";
  }
  if (!written) {
    out += "\n[clay]\n";
    for (const std::string& one : grid) out += one + "\n";
  }
  return out;
}

Result<void> write_grid(const std::filesystem::path& file, int rows, int sectors,
                        const std::string& note) {
  const settings::SceneRead before = settings::read_scene(file);
  if (!before.problems.empty()) return tl::unexpected(before.problems.front());
  const auto text = toml::read_toml_text(file);
  if (!text) return tl::unexpected(text.error());
  const auto write = [&](const std::string& what) {
    return files::write_durably(file, std::as_bytes(std::span(what)));
  };
  if (auto done = write(with_grid(*text, rows, sectors, note)); !done) return done;
  const settings::SceneRead after = settings::read_scene(file);
  if (after.problems.empty() && after.def.clay.rows == rows && after.def.clay.sectors == sectors)
    return {};
  if (auto done = write(*text); !done) return done;
  return problem(file.string(), "The grid could not be written, so the file is unchanged.",
                 "Write clay.rows and clay.sectors by hand.", 1);
}

}  // namespace onggi::tuning
