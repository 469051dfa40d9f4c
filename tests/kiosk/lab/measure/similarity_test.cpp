#include "kiosk/lab/measure/similarity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::measure::similarity_test {
namespace {

/// Stripes of `period` pixels, `phase` of them shifted, `contrast` round the middle grey.
view::Image stripes(double period, double phase, double contrast) {
  view::Image image{64, 48, {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double v = 128 + contrast * std::sin(2 * 3.14159265358979 * (x + phase) / period);
      for (int k = 0; k < 3; ++k) image.rgba.push_back(static_cast<std::uint8_t>(std::lround(v)));
      image.rgba.push_back(255);
    }
  return image;
}

constexpr view::Rect kAll{0, 0, 64, 48};

TEST(StructuralSimilarity, APictureIsOneWithItself) {
  EXPECT_DOUBLE_EQ(structural_similarity(stripes(8, 0, 60), stripes(8, 0, 60), kAll), 1.0);
}

// Stripes far shorter than the window have its mean and twice its spread everywhere: the formula in
// closed form. Of half the contrast: 2ab/(a^2+b^2) with a = 2b is 0.8.
TEST(StructuralSimilarity, HalfTheContrastIsFourFifths) {
  EXPECT_NEAR(structural_similarity(stripes(4, 0, 80), stripes(4, 0, 40), kAll), 0.8, 0.02);
}

TEST(StructuralSimilarity, BlackForWhiteIsBelowNothing) {
  EXPECT_LT(structural_similarity(stripes(4, 0, 80), stripes(4, 2, 80), kAll), -0.9);
}

TEST(StructuralSimilarity, OnlyThePartAskedForCounts) {
  view::Image other = stripes(8, 0, 60);
  for (int y = 0; y < 48; ++y)
    for (int x = 40; x < 64; ++x)
      for (std::size_t k = 0; k < 3; ++k)
        other.rgba[4 * static_cast<std::size_t>(y * 64 + x) + k] = 0;
  EXPECT_DOUBLE_EQ(structural_similarity(stripes(8, 0, 60), other, {0, 0, 40, 48}), 1.0);
  EXPECT_LT(structural_similarity(stripes(8, 0, 60), other, kAll), 0.9);
}

TEST(StructuralSimilarity, NothingToCompareIsNoLikeness) {
  EXPECT_EQ(structural_similarity(stripes(8, 0, 60), stripes(8, 0, 60), {0, 0, 8, 48}), 0.0);
  EXPECT_EQ(structural_similarity(stripes(8, 0, 60), {}, kAll), 0.0);
}

}  // namespace
}  // namespace onggi::measure::similarity_test
