#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace onggi::encoding {

using Pictures = std::vector<std::vector<std::uint8_t>>;  ///< rgb each

/// The codes' values, by the letter of GIF89a, appendix F; independent of the writer.
inline std::string gif_values(const std::string& data, std::size_t bits) {
  const std::size_t clear = std::size_t{1} << bits, end = clear + 1;
  std::vector<std::string> table;
  std::string out, last;
  std::size_t width = bits + 1, held = 0;
  std::uint32_t some = 0;
  const auto begin = [&] {
    table.clear();
    for (std::size_t k = 0; k < clear + 2; ++k)
      table.push_back(k < clear ? std::string(1, static_cast<char>(k)) : std::string());
    width = bits + 1;
    last.clear();
  };
  begin();
  for (const char byte : data) {
    some |= static_cast<std::uint32_t>(static_cast<unsigned char>(byte)) << held;
    held += 8;
    while (held >= width) {
      const std::size_t code = some & ((1u << width) - 1);
      some >>= width;
      held -= width;
      if (code == end) return out;
      if (code == clear) {
        begin();
        continue;
      }
      EXPECT_LE(code, table.size());
      if (code > table.size()) return out;
      const std::string entry = code < table.size() ? table[code] : last + last[0];
      out += entry;
      if (!last.empty() && table.size() < 4096) {
        table.push_back(last + entry[0]);
        if (table.size() == std::size_t{1} << width && width < 12) ++width;
      }
      last = entry;
    }
  }
  ADD_FAILURE() << "the codes have no end";
  return out;
}

/// What a viewer shows, picture after picture.
inline Pictures shown_gif(std::span<const std::byte> gif) {
  const auto at = [&](std::size_t i) {
    EXPECT_LT(i, gif.size());
    return i < gif.size() ? std::to_integer<std::size_t>(gif[i]) : 0x3b;
  };
  const auto u16 = [&](std::size_t i) { return at(i) + 256 * at(i + 1); };
  const std::size_t width = u16(6);
  std::vector<std::uint8_t> canvas(3 * width * u16(8));
  Pictures out;
  std::size_t i = 13 + 768, none = 256;
  while (at(i) != 0x3b) {
    const bool picture = at(i) == 0x2c;
    const std::size_t left = u16(i + 1), top = u16(i + 3), wide = u16(i + 5), high = u16(i + 7);
    std::size_t bits = 0;
    if (picture) {
      bits = at(i + 10);
      i += 11;
    } else {
      if (at(i + 1) == 0xf9) none = at(i + 6);
      i += 2;
    }
    std::string data;
    for (; at(i) != 0; i += at(i) + 1)
      for (std::size_t k = 1; k <= at(i); ++k) data += static_cast<char>(at(i + k));
    ++i;
    if (!picture) continue;
    const std::string values = gif_values(data, bits);
    EXPECT_EQ(values.size(), wide * high);
    for (std::size_t n = 0; n < std::min(values.size(), wide * high); ++n) {
      const std::size_t value = static_cast<unsigned char>(values[n]);
      if (value == none) continue;
      const std::size_t pixel = (top + n / wide) * width + left + n % wide;
      for (std::size_t k = 0; k < 3; ++k)
        canvas.at(3 * pixel + k) = static_cast<std::uint8_t>(at(13 + 3 * value + k));
    }
    out.push_back(canvas);
  }
  return out;
}

}  // namespace onggi::encoding
