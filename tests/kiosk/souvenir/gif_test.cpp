#include "kiosk/souvenir/gif.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace onggi::souvenir {
namespace {

using Pictures = std::vector<std::vector<std::uint8_t>>;  // rgb each

/// The codes' values, by the letter of GIF89a, appendix F; independent of the writer.
std::string values_of(const std::string& data, std::size_t bits) {
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
Pictures shown(const std::vector<std::byte>& gif) {
  const auto at = [&](std::size_t i) { return std::to_integer<std::size_t>(gif.at(i)); };
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
      for (std::size_t k = 1; k <= at(i); ++k)
        data += static_cast<char>(std::to_integer<unsigned char>(gif.at(i + k)));
    ++i;
    if (!picture) continue;
    const std::string values = values_of(data, bits);
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

std::vector<std::uint8_t> joined(const Pictures& pictures) {
  std::vector<std::uint8_t> all;
  for (const auto& picture : pictures) all.insert(all.end(), picture.begin(), picture.end());
  return all;
}

/// Of each of `colors` a chequer, moved on by a pixel in each picture.
Pictures chequers(int side, int pictures, int colors) {
  Pictures out(static_cast<std::size_t>(pictures));
  for (int n = 0; n < pictures; ++n)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const int c = (x + n + 7 * y) % colors;
        // 40 levels apart, so that no dither takes one for the other.
        for (const int v : {40 * (c % 6), 40 * (c / 6 % 6), 40 * (c / 36 % 6)})
          out[static_cast<std::size_t>(n)].push_back(static_cast<std::uint8_t>(v));
      }
  return out;
}

TEST(Gif, PicturesOfFewColoursComeBackPixelForPixelWhateverTheirSize) {
  for (const int side : {1, 2, 3, 17, 64, 150})
    for (const int colors : {1, 2, 30, 200}) {
      const Pictures pictures = chequers(side, 3, colors);
      EXPECT_EQ(shown(write_gif(side, side, 10, joined(pictures))), pictures)
          << side << ' ' << colors;
    }
}

// Codes grow from 9 to 12 bits and begin anew; wherever the pixels end among them, they are read.
TEST(Gif, ItIsReadHoweverManyPixelsItHas) {
  // No two neighbours come again, so that there are as many codes as pixels.
  std::vector<std::uint8_t> row;
  int color = 0, pixels = 0;
  for (const int step :
       {1, 5, 7, 11, 13, 17, 19, 23, 25, 29, 31, 35, 37, 41, 43, 47, 49, 53, 55, 59})
    for (int k = 0; k < 216; ++k, color = (color + step) % 216) {
      for (const int v : {color % 6, color / 6 % 6, color / 36})
        row.push_back(static_cast<std::uint8_t>(40 * v));
      ++pixels;
      bool near = pixels < 4 || pixels % 512 == 0;
      for (const int grown : {255, 767, 1791, 3839, 4096}) near |= std::abs(pixels - grown) < 4;
      if (!near) continue;
      const Pictures wanted{row};
      ASSERT_EQ(shown(write_gif(pixels, 1, 10, row)), wanted) << pixels;
    }
}

TEST(Gif, WhatStandsStillInThePicturesStandsStillInIt) {
  constexpr int kSide = 96;
  Pictures pictures(8);
  for (std::size_t n = 0; n < pictures.size(); ++n)
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        // A slow shade on the left; on the right thousands of colours that come and go.
        const int shade = 150 + x / 2 + y / 3;
        const bool still = x < kSide / 2;
        const int other = static_cast<int>(n) * 31 + x * 5 + y * y;
        for (const int v : {shade, shade - 8, shade - 20})
          pictures[n].push_back(static_cast<std::uint8_t>(still ? v : (v * other) & 255));
      }
  const Pictures seen = shown(write_gif(kSide, kSide, 10, joined(pictures)));
  ASSERT_EQ(seen.size(), pictures.size());
  double off = 0;
  for (std::size_t n = 0; n < seen.size(); ++n)
    for (std::size_t y = 0; y < kSide; ++y)
      for (std::size_t i = 3 * kSide * y; i < 3 * (kSide * y + kSide / 2); ++i) {
        ASSERT_EQ(seen[n][i], seen[0][i]) << n;
        off += std::abs(seen[n][i] - pictures[n][i]);
      }
  EXPECT_LT(off / (8 * 3 * kSide * kSide / 2), 8.0);
}

TEST(Gif, WhatStandsStillTakesNoRoom) {
  const auto one = chequers(100, 1, 90);
  const Pictures ten(10, one[0]);
  const std::size_t alone = write_gif(100, 100, 10, joined(one)).size();
  const auto all = write_gif(100, 100, 10, joined(ten));
  EXPECT_LT(all.size(), alone + 9 * 40);
  EXPECT_EQ(shown(all), ten);
}

TEST(Gif, ASlowShadeIsDitheredAndKeepsItsMean) {
  constexpr int kSide = 128;
  Pictures pictures(1);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const double v = 90.0 + 100.0 * x / kSide;
      for (const double own : {v, 0.9 * v, 0.8 * v + 0.1 * y})
        pictures[0].push_back(static_cast<std::uint8_t>(own));
    }
  const Pictures seen = shown(write_gif(kSide, kSide, 10, joined(pictures)));
  // Means over 16 x 16 pixels: what an eye sees.
  for (std::size_t y = 0; y < kSide; y += 16)
    for (std::size_t x = 0; x < kSide; x += 16)
      for (std::size_t k = 0; k < 3; ++k) {
        double apart = 0;
        for (std::size_t n = 0; n < 256; ++n) {
          const std::size_t i = 3 * ((y + n / 16) * kSide + x + n % 16) + k;
          apart += (seen[0][i] - pictures[0][i]) / 256.0;
        }
        EXPECT_LT(std::abs(apart), 2.0) << x << ' ' << y;
      }
}

TEST(Gif, TheSamePicturesGiveTheSameBytes) {
  const auto pictures = joined(chequers(40, 4, 90));
  EXPECT_EQ(write_gif(40, 40, 10, pictures), write_gif(40, 40, 10, pictures));
  EXPECT_NE(write_gif(40, 40, 10, pictures), write_gif(40, 40, 11, pictures));
}

}  // namespace
}  // namespace onggi::souvenir
