#include "kiosk/collection/content/data_uri.h"

#include <algorithm>
#include <string_view>

namespace onggi::content {
namespace {

constexpr std::string_view kScheme = "data:", kCoding = ";base64,";
/// Longest media type with its parameters, bytes.
constexpr std::size_t kLongestHead = 256;

std::string_view head_of(std::span<const unsigned char> text) {
  return {reinterpret_cast<const char*>(text.data()), std::min(text.size(), kLongestHead)};
}

/// Start of the base64; 0 if `text` is not a data URI.
std::size_t payload_at(std::span<const unsigned char> text) {
  const std::string_view head = head_of(text);
  if (!head.starts_with(kScheme)) return 0;
  const std::size_t coding = head.find(kCoding);
  return coding == std::string_view::npos ? 0 : coding + kCoding.size();
}

/// Six bits; 64 for the padding's '='; -1 for anything else.
int six_bits(unsigned char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return c == '=' ? 64 : -1;
}

/// Reads the character at `at` and moves `at` behind it, undoing JSON's escapes. 0 for an escape
/// that base64 cannot contain.
unsigned char next(std::span<const unsigned char> text, std::size_t& at) {
  const unsigned char c = text[at++];
  if (c != '\\') return c;
  if (at < text.size() && text[at] == '/') return text[at++];
  if (at + 5 > text.size() || text[at] != 'u') return 0;
  unsigned code = 0;
  for (std::size_t i = at + 1; i < at + 5; ++i) {
    const unsigned char h = text[i];
    const bool digit = h >= '0' && h <= '9';
    const unsigned char low = static_cast<unsigned char>(h | 0x20);
    if (!digit && (low < 'a' || low > 'f')) return 0;
    code = code * 16 + (digit ? h - unsigned{'0'} : low - unsigned{'a'} + 10);
  }
  at += 5;
  return code < 0x80 ? static_cast<unsigned char>(code) : static_cast<unsigned char>(0);
}

}  // namespace

bool is_data_uri(std::span<const unsigned char> text) { return payload_at(text) > 0; }

std::size_t most_bytes_in(std::span<const unsigned char> uri) {
  return (uri.size() - payload_at(uri)) / 4 * 3 + 3;
}

std::optional<std::span<unsigned char>> decode_data_uri(std::span<unsigned char> uri,
                                                        std::size_t most) {
  std::size_t at = payload_at(uri), written = 0;
  unsigned bits = 0;
  int held = 0;
  bool padded = false;
  while (at < uri.size() && written < most) {
    const int six = six_bits(next(uri, at));
    if (six < 0 || (padded && six != 64)) return std::nullopt;
    padded = six == 64;
    if (padded) continue;
    bits = bits << 6 | static_cast<unsigned>(six);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    uri[written++] = static_cast<unsigned char>(bits >> held);
  }
  return uri.first(written);
}

}  // namespace onggi::content
