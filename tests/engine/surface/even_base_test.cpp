#include "engine/surface/even_base.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/engine/surface/decorated_pots.h"
#include "tests/engine/surface/random_strokes.h"

namespace onggi::surface_test::even_base_test {
namespace {

int base_of(const Surface& surface, int j, int i) {
  return surface.relief(j, i) * int{kNanometres} + surface.slip(j, i).thickness();
}

/// Root of the mean square of a step to the next cell round the pot and along it, nm.
double grain(int from, int to, const std::function<int(int j, int i)>& height) {
  double sum = 0.0;
  for (int j = from; j < to; ++j)
    for (int i = 0; i < kSectors; ++i) {
      const double round = height(j, wrapped(i + 1)) - height(j, i),
                   along = height(j + 1, i) - height(j, i);
      sum += round * round + along * along;
    }
  return std::sqrt(sum / ((to - from) * double{kSectors}));
}

/// All of a pot's, a row after the other.
std::vector<int> even(const Surface& surface) {
  std::vector<int> all;
  EvenBase base(surface, 0, kSectors);
  for (int j = 0; j < surface.rows(); ++j)
    for (const int height : base.row(j)) all.push_back(height);
  return all;
}

// Slip that is laid again and again comes to lie between two codes, and rounding carries what is
// over from cell to cell.
TEST(EvenBase, AnEvenCoatHasAFifthOfItsGrain) {
  Surface surface = made(jar());
  BrushDef flood;
  flood.width = 0.03, flood.tracks = 1;
  for (int n = 0; n < 3; ++n) done(surface, flood, band(surface, 0.08, 100.0));
  const std::vector<int> all = even(surface);
  const auto at = [&](int j, int i) { return all[static_cast<std::size_t>(j * kSectors + i)]; };
  const double before = grain(300, 340, [&](int j, int i) { return base_of(surface, j, i); });
  EXPECT_GT(before, 20'000) << "nm: what this is against";
  EXPECT_LT(grain(300, 340, at), 0.2 * before);
  // It is no thinner.
  double was = 0.0, is = 0.0;
  for (int i = 0; i < kSectors; ++i) was += base_of(surface, 320, i), is += at(320, i);
  EXPECT_NEAR(is / was, 1.0, 0.02);
}

TEST(EvenBase, BareClayIsAsItIsHoweverItIsCut) {
  Surface surface = made(bowl());
  CutDef comb;
  comb.teeth = 5, comb.depth = 0.001;
  done(surface, comb, straight(surface, {0.02, 0.1}, {0.05, 0.6}));
  const std::vector<int> all = even(surface);
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i)
      ASSERT_EQ(all[static_cast<std::size_t>(j * kSectors + i)], base_of(surface, j, i))
          << j << ' ' << i;
}

TEST(EvenBase, TheEdgeOfACoatStaysWhereItIs) {
  Surface surface = made(jar());
  FillDef fill;
  fill.thickness = 3e-4;
  const auto way = straight(surface, {0.06, 0.1}, {0.09, 0.1});
  auto corners = way;
  for (const Station& back : straight(surface, {0.09, 0.3}, {0.06, 0.3})) corners.push_back(back);
  done(surface, fill, corners);
  const std::vector<int> all = even(surface);
  int inside = 0, outside = 0;
  for (int j = 0; j < surface.rows(); ++j)
    for (int i = 0; i < kSectors; ++i) {
      const int height = all[static_cast<std::size_t>(j * kSectors + i)],
                was = base_of(surface, j, i);
      if (was == 0) {
        ASSERT_EQ(height, 0) << j << ' ' << i;
        ++outside;
      } else {
        ASSERT_NEAR(height, was, 0.25 * was) << j << ' ' << i;
        ++inside;
      }
    }
  EXPECT_GT(inside, 30'000);
  EXPECT_GT(outside, 30'000);
}

TEST(EvenBase, APartOfThePotIsThePartOfTheWholeInWhateverOrderItIsRead) {
  Surface surface = made(bowl());
  RandomStrokes random(11);
  for (int n = 0; n < 60; ++n) ASSERT_TRUE(apply(surface, random.next(surface)));
  const std::vector<int> all = even(surface);
  const int last = surface.rows() - 1;
  for (const int first : {-1, 59, kSectors - 30, 1000}) {
    EvenBase part(surface, first, 62);
    for (const int j : {last, 0, 7, 5, 6, last / 2, last / 2 - 4, last + 3, -2, 1}) {
      const std::span<const int> row = part.row(j);
      ASSERT_EQ(row.size(), 62u);
      for (int n = 0; n < 62; ++n)
        ASSERT_EQ(
            row[static_cast<std::size_t>(n)],
            all[static_cast<std::size_t>(std::clamp(j, 0, last) * kSectors + wrapped(first + n))])
            << first << ' ' << j << ' ' << n;
    }
  }
}

}  // namespace
}  // namespace onggi::surface_test::even_base_test
