#include "kiosk/settings/toml_text.h"

#include <string_view>

#include "kiosk/files/read_file.h"

namespace onggi::settings {
namespace {

constexpr int kLongestChain = 16;

/// Skips a string that starts at `i`, after which `i` is behind it; counts lines in `line`.
void skip_string(const std::string& text, std::size_t& i, std::size_t& line) {
  const char quote = text[i];
  const bool escapes = quote == '"';
  const bool multi = text.compare(i, 3, std::string(3, quote)) == 0;
  i += multi ? 3 : 1;
  while (i < text.size()) {
    if (text[i] == '\n') {
      if (!multi) return;  // an unclosed string: the parser will say so
      ++line;
    }
    if (escapes && text[i] == '\\' && text.compare(i + 1, 1, "\n") != 0) {
      i += 2;
    } else if (multi ? text.compare(i, 3, std::string(3, quote)) == 0 : text[i] == quote) {
      i += multi ? 3 : 1;
      // Up to two more quotes belong to the string: """He said "go"""".
      for (int extra = 0; multi && extra < 2 && i < text.size() && text[i] == quote; ++extra) ++i;
      return;
    } else {
      ++i;
    }
  }
}

}  // namespace

Result<std::string> read_toml_text(const std::filesystem::path& file) {
  using Kind = files::ReadFault::Kind;
  const std::string name = file.string();
  const auto bytes = files::read_file(file, kLargestToml);
  if (!bytes) {
    const files::ReadFault& fault = bytes.error();
    switch (fault.kind) {
      case Kind::missing:
        return problem(name, "There is no such file.", "Correct the path, or put the file there.");
      case Kind::folder:
        return problem(name, "This is a folder, and a TOML file is wanted.", "Name a TOML file.");
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
    return problem(name + ":1:1", "The file is written in UTF-16, and TOML is UTF-8.",
                   "Save it again as UTF-8.");
  }
  return text;
}

Result<void> check_depth(const std::string& text, const std::string& file_name) {
  std::size_t line = 1, line_start = 0;
  int chain = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      skip_string(text, i, line);
      continue;
    }
    if (c == '#') {
      while (i < text.size() && text[i] != '\n') ++i;
      continue;
    }
    if (c == '\n') {
      ++line;
      line_start = i + 1;
    }
    if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}') {
      chain = 0;
    } else if (c == '.' && ++chain >= kLongestChain) {
      return problem(
          file_name + ":" + std::to_string(line) + ":" + std::to_string(i - line_start + 1),
          "The name has more than 16 parts with points between them.",
          "Names here have three parts at most: put quotes round the point if it is meant.");
    }
    ++i;
  }
  return {};
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

}  // namespace onggi::settings
