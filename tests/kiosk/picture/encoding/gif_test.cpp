#include "kiosk/picture/encoding/gif.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "tests/kiosk/picture/encoding/shown_gif.h"

namespace onggi::encoding::gif_test {
namespace {

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
      EXPECT_EQ(shown_gif(write_gif(side, side, 10, joined(pictures))), pictures)
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
      ASSERT_EQ(shown_gif(write_gif(pixels, 1, 10, row)), wanted) << pixels;
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
  const Pictures seen = shown_gif(write_gif(kSide, kSide, 10, joined(pictures)));
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
  EXPECT_EQ(shown_gif(all), ten);
}

/// Pictures of a slow shade. In picture n it is `moved(n)` levels lighter.
template <class Moved>
Pictures shades(int side, std::size_t count, Moved&& moved) {
  Pictures pictures(count);
  for (std::size_t n = 0; n < count; ++n)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const double v = 100.0 + x + 0.5 * y + moved(static_cast<double>(n));
        for (const double own : {v, 0.9 * v, 0.8 * v})
          pictures[n].push_back(static_cast<std::uint8_t>(own));
      }
  return pictures;
}

// As light does on a pot that turns.
TEST(Gif, AShadeThatTremblesByALevelTakesLittleRoom) {
  const auto size = [](std::size_t count) {
    return write_gif(64, 64, 10,
                     joined(shades(64, count, [](double n) { return std::fmod(n, 2); })))
        .size();
  };
  EXPECT_LT(size(40), 3 * size(2));
}

TEST(Gif, AShadeThatMovesSlowlyIsNeverFarOff) {
  const Pictures pictures = shades(64, 40, [](double n) { return 0.2 * n; });
  const Pictures seen = shown_gif(write_gif(64, 64, 10, joined(pictures)));
  int most = 0;
  for (std::size_t n = 0; n < seen.size(); ++n)
    for (std::size_t i = 0; i < seen[n].size(); ++i)
      most = std::max(most, std::abs(seen[n][i] - pictures[n][i]));
  EXPECT_LE(most, 6);
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
  const Pictures seen = shown_gif(write_gif(kSide, kSide, 10, joined(pictures)));
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
}  // namespace onggi::encoding::gif_test
