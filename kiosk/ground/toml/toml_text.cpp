#include "kiosk/ground/toml/toml_text.h"

#include <string_view>

#include "kiosk/ground/files/read_file.h"

namespace onggi::toml {
namespace {

constexpr int kLongestChain = 16;

bool beyond_ascii(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// The position after the string that begins at `i`; the end of its line, or of `text`, if it is
/// not closed.
std::size_t behind_string(const std::string& text, std::size_t i) {
  const char quote = text[i];
  const bool escapes = quote == '"';
  const bool multi = text.compare(i, 3, std::string(3, quote)) == 0;
  i += multi ? 3 : 1;
  while (i < text.size()) {
    if (text[i] == '\n' && !multi) return i;  // an unclosed string; the parser will report it
    if (escapes && text[i] == '\\' && text.compare(i + 1, 1, "\n") != 0) {
      i += 2;
    } else if (multi ? text.compare(i, 3, std::string(3, quote)) == 0 : text[i] == quote) {
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

/// "file:line:column" of byte `at`; columns count letters.
std::string place_in(const std::string& text, std::size_t at, const std::string& file_name) {
  const std::size_t start = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;  // npos + 1 is 0
  const auto begin = text.begin(), there = begin + static_cast<std::ptrdiff_t>(at);
  const auto line = 1 + std::count(begin, there, '\n');
  const auto column =
      1 + std::count_if(begin + static_cast<std::ptrdiff_t>(start), there,
                        [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
  return file_name + ":" + std::to_string(line) + ":" + std::to_string(column);
}

/// The bytes of the UTF-8 letter at `i`; 0 where there is none.
std::size_t letter_size(const std::string& text, std::size_t i) {
  const auto lead = static_cast<unsigned char>(text[i]);
  const std::size_t size = lead >= 0xF0 && lead < 0xF5 ? 4
                           : lead >= 0xE0              ? 3
                           : lead >= 0xC2              ? 2
                                                       : 0;
  if (lead >= 0xF5 || size == 0 || i + size > text.size()) return 0;
  for (std::size_t k = 1; k < size; ++k)
    if ((static_cast<unsigned char>(text[i + k]) & 0xC0) != 0x80) return 0;
  return size;
}

/// \UXXXXXXXX for the letter of `size` bytes at `i`.
std::string escape_of(const std::string& text, std::size_t i, std::size_t size) {
  std::uint32_t point = static_cast<unsigned char>(text[i]) & (0xFFu >> (size + 1));
  for (std::size_t k = 1; k < size; ++k)
    point = point << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3Fu);
  char out[11];
  std::snprintf(out, sizeof out, "\\U%08X", point);
  return out;
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

Result<void> check_outside_quotes(const std::string& text, const std::string& file_name) {
  int chain = 0;
  for (std::size_t i = text.starts_with("\xEF\xBB\xBF") ? 3 : 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = behind_string(text, i);
      continue;
    }
    if (c == '#') {
      while (i < text.size() && text[i] != '\n') ++i;
      continue;
    }
    if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}') {
      chain = 0;
    } else if (c == '.' && ++chain >= kLongestChain) {
      return problem(place_in(text, i, file_name),
                     "The name has more than 16 parts separated by points.",
                     "Use three parts at most, or put quotes round a name that contains a point.");
    } else if (beyond_ascii(c)) {
      const std::string place = place_in(text, i, file_name);
      return problem(
          place,
          "Outside quotes a name may hold only a to z, digits, _ and -. "
          "The line is: " +
              line_of(text,
                      1 + static_cast<std::size_t>(std::count(
                              text.begin(), text.begin() + static_cast<std::ptrdiff_t>(i), '\n'))),
          "Put \"quotes\" round the name or the text.");
    }
    ++i;
  }
  return {};
}

std::string escaped_after_line_ends(const std::string& text) {
  std::string out;
  std::size_t copied = 0;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '#') {
      while (i < text.size() && text[i] != '\n') ++i;
      continue;
    }
    if (text[i] != '"' && text[i] != '\'') {
      ++i;
      continue;
    }
    const std::size_t end = behind_string(text, i);
    if (text.compare(i, 3, R"(""")") != 0) {
      i = end;
      continue;
    }
    while (i < end) {
      if (text[i] != '\\') {
        ++i;
        continue;
      }
      const std::size_t next = text.find_first_not_of(" \t\r\n", i + 1);
      const bool joins_lines = text.find('\n', i) < next;
      if (!joins_lines) {
        i += 2;
        continue;
      }
      i = std::min(next, end);
      if (i == end || !beyond_ascii(text[i])) continue;
      if (const std::size_t size = letter_size(text, i); size > 0) {
        out.append(text, copied, i - copied).append(escape_of(text, i, size));
        i += size;
        copied = i;
      }
    }
    i = end;
  }
  return out.append(text, copied);
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

}  // namespace onggi::toml
