#include "kiosk/ground/toml/ascii_toml.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <utility>

#include "kiosk/ground/toml/toml_text.h"

namespace onggi::toml {
namespace {

constexpr int kLongestChain = 16;

bool beyond_ascii(char c) { return static_cast<unsigned char>(c) >= 0x80; }

struct Letter {
  char32_t point = 0;
  std::size_t bytes = 0;  ///< 0: it is not UTF-8 (RFC 3629: no overlong form, no surrogate).
};

Letter letter_at(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) {
    return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0u;
  };
  const unsigned lead = byte(0);
  const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4) return {};
  char32_t point = lead & (0xFFu >> (bytes + 1));
  for (std::size_t k = 1; k < bytes; ++k) {
    if ((byte(k) & 0xC0u) != 0x80u) return {};
    point = point << 6 | (byte(k) & 0x3Fu);
  }
  const char32_t least = bytes == 4 ? 0x10000 : bytes == 3 ? 0x800 : 0x80;
  if (point < least || point > 0x10FFFF || (point >= 0xD800 && point < 0xE000)) return {};
  return {point, bytes};
}

std::string hex(const char* format, char32_t point) {
  std::array<char, 16> out{};
  std::snprintf(out.data(), out.size(), format, static_cast<unsigned>(point));
  return out.data();
}

bool one_of(char32_t point, std::u32string_view points) {
  return points.find(point) != std::u32string_view::npos;
}

}  // namespace

AsciiToml::AsciiToml(const std::string& text, const std::string& name) : in_(text), name_(name) {
  out_.reserve(in_.size());
  if (in_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  while (at_ < in_.size()) {
    const char c = in_[at_];
    const bool good = c == '#'    ? comment()
                      : c == '"'  ? basic_string(behind_string(in_, at_))
                      : c == '\'' ? literal_string(behind_string(in_, at_))
                                  : outside(c);
    if (good) continue;
    out_.resize(line_begin_);
    out_ += '\x01';  // TOML allows it nowhere, so that a parser that gets so far stops in this line
    return;
  }
}

bool AsciiToml::outside(char c) {
  if (beyond_ascii(c)) return letter(false);
  if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}') {
    parts_ = 0;
  } else if (c == '.' && ++parts_ >= kLongestChain) {
    refuse("The name has more than 16 parts with points between them.",
           "Names here have three parts at most. Put quotes round a name that has a point in it.");
    return false;
  }
  copy();
  return true;
}

bool AsciiToml::comment() {
  while (at_ < in_.size() && in_[at_] != '\n') {
    if (!beyond_ascii(in_[at_])) {
      copy();
      continue;
    }
    const Letter letter = letter_at(in_, at_);
    if (letter.bytes == 0) return this->letter(true);
    put("?", letter.bytes);
  }
  return true;
}

bool AsciiToml::basic_string(std::size_t end) {
  while (at_ < end) {
    const bool escapes = in_[at_] == '\\';
    if (beyond_ascii(in_[at_])) {
      if (!letter(true)) return false;
      continue;
    }
    copy();
    if (!escapes || at_ >= end) continue;
    if (!beyond_ascii(in_[at_]))
      copy();
    else if (const Letter after = letter_at(in_, at_); after.bytes > 0)
      put("?", after.bytes);  // no escape, which the parser will say
  }
  return true;
}

bool AsciiToml::literal_string(std::size_t end) {
  const std::string_view whole = std::string_view(in_).substr(at_, end - at_);
  const std::size_t quotes = whole.starts_with("'''") ? 3 : 1;
  const bool closed = whole.size() >= 2 * quotes && whole.ends_with(whole.substr(0, quotes));
  if (std::none_of(whole.begin(), whole.end(), beyond_ascii)) {
    while (at_ < end) copy();
    return true;
  }
  for (std::size_t n = at_; at_ < end;) {
    const char c = in_[at_];
    const bool delimits = at_ < n + quotes || at_ >= end - quotes;
    if (beyond_ascii(c)) {
      if (!letter(true)) return false;
    } else if (!closed) {
      copy();
    } else if (delimits) {
      put("\"", 1);
    } else if (c == '\\' || c == '"') {
      put(std::string{'\\', c}, 1);
    } else {
      copy();
    }
  }
  return true;
}

/// The letter beyond ASCII at hand. False where it may not stand there.
bool AsciiToml::letter(bool in_string) {
  const Letter letter = letter_at(in_, at_);
  if (letter.bytes == 0) {
    refuse("The bytes here are not UTF-8.", "Save the file as UTF-8.");
    return false;
  }
  if (!in_string) {
    refuse_letter(letter.point);
    return false;
  }
  put(hex("\\U%08X", letter.point), letter.bytes);
  return true;
}

void AsciiToml::copy() {
  const char c = in_[at_++];
  out_ += c;
  ++column_;
  if (c != '\n') return;
  ++line_;
  column_ = 1;
  shift_ = 0;
  line_begin_ = out_.size();
}

void AsciiToml::put(const std::string& stand_in, std::size_t bytes) {
  const auto more = static_cast<std::uint32_t>(stand_in.size() - 1);
  if (more > 0) {
    const std::uint32_t begin = column_ + shift_;
    shifts_.push_back({line_, begin, begin + more + 1, shift_, shift_ + more});
    shift_ += more;
  }
  out_ += stand_in;
  ++column_;
  at_ += bytes;
}

Place AsciiToml::original(Place place) const {
  auto after = std::ranges::upper_bound(
      shifts_, std::pair(place.line, place.column), {},
      [](const Shift& shift) { return std::pair(shift.line, shift.begin); });
  if (after == shifts_.begin()) return place;
  const Shift& shift = *--after;
  if (shift.line != place.line) return place;
  place.column = place.column < shift.end ? shift.begin - shift.before : place.column - shift.after;
  return place;
}

void AsciiToml::refuse(std::string what, std::string remedy) {
  fault_ = Problem{name_ + ":" + std::to_string(line_) + ":" + std::to_string(column_),
                   std::move(what), std::move(remedy)};
}

void AsciiToml::refuse_letter(char32_t point) {
  const std::string code = hex("U+%04X", point);
  const std::string line = ", in the line: " + line_of(in_, line_);
  if (one_of(point,
             U"\u00A0\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200A"
             U"\u200B\u200C\u200D\u200E\u200F\u2028\u2029\u202A\u202B\u202C\u202D\u202E"
             U"\u202F\u205F\u2060\u2066\u2067\u2068\u2069\u3000\u00AD\u0085\uFEFF"))
    return refuse("A character that cannot be seen (" + code + ") stands here" + line,
                  "Delete it, and type a plain space where one is wanted. It often comes along "
                  "when text is copied.");
  if (one_of(point,
             U"\u201C\u201D\u201E\u201F\u2018\u2019\u201A\u201B\u00AB\u00BB\u2039\u203A"
             U"\u300C\u300D\uFF02\uFF07"))
    return refuse("A typographic quotation mark (" + code + ") stands here" + line,
                  "Write plain quotation marks round the text: \"text\".");
  if (one_of(point, U"\u2010\u2011\u2012\u2013\u2014\u2015\u2212\uFF0D"))
    return refuse("A dash (" + code + ") stands where a number or a name is wanted" + line,
                  "Write a plain minus: -.");
  refuse("\"" + in_.substr(at_, letter_at(in_, at_).bytes) + "\" (" + code +
             ") stands outside quotation marks" + line,
         "Put \"quotation marks\" round a name or a text. Write a number without its unit.");
}

}  // namespace onggi::toml
