#include "engine/base/plain_text.h"

#include <cstdint>

namespace onggi::terminal {
namespace {

/// The character at the beginning of `text` and its length in bytes; a length of 0 where that is no
/// UTF-8.
struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;
};

Character first_of(std::string_view text) {
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned head = byte(0);
  if (head < 0x80) return {head, 1};
  const std::size_t bytes = head >= 0xF0 ? 4 : head >= 0xE0 ? 3 : 2;
  if (head < 0xC2 || head > 0xF4 || text.size() < bytes) return {};
  std::uint32_t code = head & (0xFFu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0u) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[bytes] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return {};
  return {code, bytes};
}

bool is_command(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x200E || code == 0x200F ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

struct Block {
  std::uint32_t first, last;
};

template <std::size_t kCount>
bool is_in(const Block (&blocks)[kCount], std::uint32_t code) {
  for (const Block& block : blocks)
    if (code >= block.first && code <= block.last) return true;
  return false;
}

// Marks, vowels and finals of a Hangul syllable, joiners and variants.
constexpr Block kOnTheOneBefore[] = {{0x300, 0x36F},   {0x483, 0x489},   {0x591, 0x5BD},
                                     {0x64B, 0x65F},   {0x1160, 0x11FF}, {0x1AB0, 0x1AFF},
                                     {0x1DC0, 0x1DFF}, {0x200B, 0x200D}, {0x20D0, 0x20FF},
                                     {0x3099, 0x309A}, {0xFE00, 0xFE0F}, {0xFE20, 0xFE2F}};
constexpr Block kWide[] = {
    {0x1100, 0x115F},   {0x2E80, 0x303E},   {0x3041, 0x4DBF},   {0x4E00, 0xA4CF},  {0xA960, 0xA97F},
    {0xAC00, 0xD7A3},   {0xF900, 0xFAFF},   {0xFE30, 0xFE6F},   {0xFF00, 0xFF60},  {0xFFE0, 0xFFE6},
    {0x1F300, 0x1F64F}, {0x1F680, 0x1F6FF}, {0x1F900, 0x1FAFF}, {0x20000, 0x3FFFD}};

std::size_t columns_of(std::uint32_t code) {
  return is_in(kOnTheOneBefore, code) ? 0 : is_in(kWide, code) ? 2 : 1;
}

}  // namespace

std::string plain(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const Character c = first_of(text);
    if (c.bytes == 0 || is_command(c.code))
      out += '?';
    else
      out += text.substr(0, c.bytes);
    text.remove_prefix(c.bytes == 0 ? 1 : c.bytes);
  }
  return out;
}

std::size_t columns(std::string_view text) {
  std::size_t used = 0;
  while (!text.empty()) {
    const Character c = first_of(text);
    used += c.bytes == 0 ? 1 : columns_of(c.code);
    text.remove_prefix(c.bytes == 0 ? 1 : c.bytes);
  }
  return used;
}

std::string column(std::string_view text, std::size_t width) {
  std::string out = plain(text);
  std::size_t bytes = 0, used = 0;
  while (bytes < out.size()) {
    const Character c = first_of(std::string_view(out).substr(bytes));
    if (used + columns_of(c.code) > width) break;
    used += columns_of(c.code);
    bytes += c.bytes;
  }
  out.resize(bytes);
  return out.append(width - used, ' ');
}

}  // namespace onggi::terminal
