#include "kiosk/collection/settings/visitor_text.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <iterator>

#include "engine/base/plain_text.h"

namespace onggi::settings {
namespace {

bool begins_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }

/// Calls `see(code)` for each Unicode character. The text came through a TOML or JSON parser, which
/// refuses other bytes; a broken sequence here gives some character, and reads no further.
template <class See>
void each_letter(std::string_view utf8, See see) {
  for (std::size_t i = 0; i < utf8.size();) {
    const auto head = static_cast<unsigned char>(utf8[i++]);
    std::uint32_t code = head < 0x80   ? head
                         : head < 0xE0 ? head & 0x1Fu
                         : head < 0xF0 ? head & 0x0Fu
                                       : head & 0x07u;
    for (; i < utf8.size() && !begins_letter(utf8[i]); ++i)
      code = code << 6 | (static_cast<unsigned char>(utf8[i]) & 0x3Fu);
    see(code);
  }
}

struct Span {
  std::uint32_t first, last;
};
bool is_in(const Span* begin, const Span* end, std::uint32_t code) {
  return std::any_of(begin, end, [code](Span s) { return code >= s.first && code <= s.last; });
}

/// What turns the writing's direction by hand, so that a text reads otherwise than it is written.
/// The marks U+200E, U+200F and U+061C turn nothing, and good Arabic and Hebrew texts have them.
bool turns_direction(std::uint32_t code) {
  return (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}
bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x2028 || code == 0x2029 ||
         turns_direction(code);
}
bool breaks_a_line(std::uint32_t code) { return code == '\n' || code == '\r' || code == '\t'; }

// Spaces, fillers and characters of no width (Unicode's White_Space, Default_Ignorable, blanks).
constexpr Span kUnseen[] = {
    {0x20, 0x20},       {0xA0, 0xA0},      {0xAD, 0xAD},     {0x34F, 0x34F},   {0x61C, 0x61C},
    {0x115F, 0x1160},   {0x1680, 0x1680},  {0x17B4, 0x17B5}, {0x180B, 0x180F}, {0x2000, 0x200F},
    {0x2028, 0x202F},   {0x205F, 0x206F},  {0x2800, 0x2800}, {0x3000, 0x3000}, {0x3164, 0x3164},
    {0xFE00, 0xFE0F},   {0xFEFF, 0xFEFF},  {0xFFA0, 0xFFA0}, {0xFFF0, 0xFFFC}, {0x1BCA0, 0x1BCA3},
    {0x1D173, 0x1D17A}, {0xE0000, 0xE0FFF}};
bool is_unseen(std::uint32_t code) {
  return is_control(code) || is_in(std::begin(kUnseen), std::end(kUnseen), code);
}

// Thai, Lao, Myanmar, Khmer; Chinese, Japanese, Korean; what lies beyond the first plane.
constexpr Span kBreaksAnywhere[] = {{0x0E00, 0x0EFF}, {0x1000, 0x109F},   {0x1100, 0x11FF},
                                    {0x1780, 0x17FF}, {0x2E80, 0xA4CF},   {0xA960, 0xA97F},
                                    {0xAC00, 0xD7FF}, {0xF900, 0xFAFF},   {0xFE30, 0xFE6F},
                                    {0xFF00, 0xFFEF}, {0x10000, 0x10FFFF}};
bool ends_word(std::uint32_t code) {
  return breaks_a_line(code) || code == ' ' || code == '-' || code == '/' || code == 0x1680 ||
         (code >= 0x2000 && code <= 0x200B && code != 0x2007) ||
         (code >= 0x2010 && code <= 0x2015 && code != 0x2011) || code == 0x3000 ||
         is_in(std::begin(kBreaksAnywhere), std::end(kBreaksAnywhere), code);
}

std::string count(std::size_t n) { return std::to_string(n) + (n == 1 ? " letter" : " letters"); }

std::optional<std::uint32_t> control_in(std::string_view text, TextBound bound) {
  std::optional<std::uint32_t> found;
  each_letter(text, [&](std::uint32_t code) {
    if (!found && is_control(code) && !(bound.lines && breaks_a_line(code))) found = code;
  });
  return found;
}

std::string named(std::uint32_t control) {
  if (breaks_a_line(control)) return "a line break or tab";
  char text[80];
  std::snprintf(text, sizeof text, "the control character U+%04X%s", static_cast<unsigned>(control),
                turns_direction(control)                 ? " (it turns the direction of writing)"
                : control == 0x2028 || control == 0x2029 ? " (it breaks a line)"
                                                         : "");
  return text;
}

}  // namespace

TextBound bound_beside(std::string_view english) { return {2 * letters(english) + 20}; }

std::size_t letters(std::string_view utf8) {
  return static_cast<std::size_t>(std::ranges::count_if(utf8, begins_letter));
}

std::size_t count_for(std::string_view utf8, TextBound bound) {
  return bound.wide ? std::max(letters(utf8), terminal::columns(utf8)) : letters(utf8);
}

std::size_t longest_word(std::string_view utf8) {
  std::size_t longest = 0, here = 0;
  each_letter(utf8, [&](std::uint32_t code) {
    here = ends_word(code) ? 0 : here + 1;
    longest = std::max(longest, here);
  });
  return longest;
}

bool is_blank(std::string_view utf8) {
  bool seen = false;
  each_letter(utf8, [&seen](std::uint32_t code) { seen = seen || !is_unseen(code); });
  return !seen;
}

std::optional<TextFault> fault_of(std::string_view text, const std::string& name, TextBound bound) {
  const std::string write =
      std::string(bound.lines ? "Write " : "Write one line of ") + "1 to " + count(bound.letters);
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    return TextFault{name + " is empty.", write + "."};
  if (const auto control = control_in(text, bound))
    return TextFault{name + " has " + named(*control) + " in it.",
                     write + ", without control characters."};
  if (is_blank(text))
    return TextFault{name + " has only characters that nobody can see.", write + "."};
  if (const std::size_t n = count_for(text, bound); n > bound.letters)
    return TextFault{name + " has " + count(n) + ", but there is room for only " +
                         std::to_string(bound.letters) + ".",
                     n == letters(text)
                         ? "Shorten it: at most " + count(bound.letters) + "."
                         : "Shorten it: a Chinese, Japanese or Korean letter counts as two."};
  if (const std::size_t n = longest_word(text); n > kMostWordLetters)
    return TextFault{name + " has a word of " + count(n) + ", but a line has room for only " +
                         std::to_string(kMostWordLetters) + ".",
                     "Put spaces or hyphens into it."};
  return std::nullopt;
}

std::string fitted(std::string_view text, TextBound bound) {
  const bool cut = count_for(text, bound) > bound.letters;
  const std::size_t most = cut ? bound.letters - 1 : bound.letters;
  std::string out;
  std::size_t n = 0;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    while (end < text.size() && !begins_letter(text[end])) ++end;
    const std::string_view letter = text.substr(i, end - i);
    n += count_for(letter, bound);
    if (n > most) break;
    out += control_in(letter, bound) ? std::string_view(" ") : letter;
    i = end;
  }
  return cut ? out + "…" : out;
}

std::string with_breaks(std::string_view utf8) {
  std::string out;
  std::size_t here = 0, read = 0;
  each_letter(utf8, [&](std::uint32_t code) {
    here = ends_word(code) ? 0 : here + 1;
    if (here > kMostWordLetters) {
      out += "\u200b";
      here = 1;
    }
    do out += utf8[read++];
    while (read < utf8.size() && !begins_letter(utf8[read]));
  });
  return out;
}

bool read_visitor_text(toml::TomlReader::Table& table, std::string_view key,
                       const std::string& name, TextBound bound, std::string& out) {
  std::string text;
  if (!table.text(key, text)) return false;
  if (auto fault = fault_of(text, name, bound)) {
    table.complain(key, std::move(fault->what), std::move(fault->remedy));
    return false;
  }
  out = std::move(text);
  return true;
}

}  // namespace onggi::settings
