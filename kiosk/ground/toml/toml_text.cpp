#include "kiosk/ground/toml/toml_text.h"

#include <array>
#include <string_view>

#include "kiosk/ground/files/read_file.h"
#include "kiosk/ground/toml/stand_in.h"

namespace onggi::toml {
Result<std::string> read_toml_text(const std::filesystem::path& file) {
  using Kind = files::ReadFault::Kind;
  if (const std::string* text = standing_in_for(file)) return *text;
  const std::string name = file.string();
  const auto bytes = files::read_file(file, kLargestToml);
  if (!bytes) {
    const files::ReadFault& fault = bytes.error();
    switch (fault.kind) {
      case Kind::missing:
        return problem(name, "There is no such file.", "Correct the path, or put the file there.");
      case Kind::folder:
        return problem(name, "This is a folder, not a TOML file.", "Name a TOML file.");
      case Kind::special:
        return problem(name, "This is not an ordinary file.", "Name a TOML file.");
      case Kind::too_large:
        return problem(name, "The file is over 4 MiB, far more than settings or labels need.",
                       "Check that the right file is named.");
      case Kind::unreadable:
        return problem(name, "The file cannot be read: " + fault.reason + ".",
                       "Check the disk, and let the user that runs the kiosk read the file.", 1);
      default:
        return problem(name, "The file cannot be opened: " + fault.reason + ".",
                       "Let the user that runs the kiosk read it.");
    }
  }
  const std::string text(bytes->begin(), bytes->end());
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    return problem(name + ":1:1", "The file is in UTF-16, but TOML must be UTF-8.",
                   "Save it again as UTF-8.");
  }
  return text;
}

std::string shown(std::string_view text, std::size_t most) {
  std::string out;
  bool cut = false;
  if (text.size() > most) {
    // Step back to the start of a character: continuation bytes are 10xxxxxx.
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
    text = text.substr(0, most);
    cut = true;
  }
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    out += byte < 0x20 || byte == 0x7F ? '?' : c;
  }
  return cut ? out + "..." : out;
}

std::string line_of(const std::string& text, std::size_t line, std::size_t most) {
  std::size_t start = 0;
  for (std::size_t n = 1; n < line; ++n) {
    const std::size_t end = text.find('\n', start);
    if (end == std::string::npos) return "";
    start = end + 1;
  }
  std::size_t end = text.find('\n', start);
  if (end == std::string::npos) end = text.size();
  if (end > start && text[end - 1] == '\r') --end;
  std::string_view whole = std::string_view(text).substr(start, end - start);
  const std::size_t first = whole.find_first_not_of(" \t");
  if (first == std::string_view::npos) return "";
  return shown(whole.substr(first), most);
}

std::size_t behind_string(std::string_view text, std::size_t begin) {
  std::size_t i = begin;
  const char quote = text[i];
  const std::array<char, 3> three{quote, quote, quote};
  const std::string_view triple(three.data(), three.size());
  const bool escapes = quote == '"';
  const bool multi = text.substr(i, 3) == triple;
  i += multi ? 3 : 1;
  while (i < text.size()) {
    if (text[i] == '\n' && !multi) return i;  // an unclosed string: the parser will say so
    if (escapes && text[i] == '\\' && text.substr(i + 1, 1) != "\n") {
      i += 2;
    } else if (multi ? text.substr(i, 3) == triple : text[i] == quote) {
      i += multi ? 3 : 1;
      // Up to two more quotes belong to the string: """He said "go"""".
      for (int extra = 0; multi && extra < 2 && i < text.size() && text[i] == quote; ++extra) ++i;
      return i;
    } else {
      ++i;
    }
  }
  return text.size();
}

}  // namespace onggi::toml
