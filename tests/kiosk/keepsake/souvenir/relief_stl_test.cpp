#include "kiosk/keepsake/souvenir/relief_stl.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/kiosk/keepsake/souvenir/relief_file_on_disk.h"

namespace onggi::souvenir::relief_stl_test {
namespace {

using test::faces_of;
using test::KeptRelief;
using test::open_edges;
using test::volume_of;

constexpr int kBlocksRound = 24, kPlacesRound = kBlocksRound * ReliefModel::kFine;

/// A cup of 50 mm, 40 rows up, a lip, 30 rows down to its floor, and 8 mm of the floor.
ReliefModel cup() {
  ReliefModel model{"cup", kBlocksRound, {}};
  const auto row = [&](double rho, double height, double out, double up) {
    ReliefModel::Row one;
    one.out = static_cast<float>(out), one.up = static_cast<float>(up);
    one.body.assign(12, {static_cast<float>(rho), static_cast<float>(height)});
    one.heights.assign(kPlacesRound, 0);
    one.fine.assign(kBlocksRound, false);
    model.rows.push_back(std::move(one));
  };
  for (int n = 0; n <= 40; ++n) row(0.05, 0.001 * n, 1, 0);
  row(0.048, 0.041, 0, 1);
  row(0.046, 0.040, -1, 0);
  for (int n = 1; n <= 30; ++n) row(0.046, 0.040 - 0.001 * n, -1, 0);
  row(0.038, 0.010, 0, 1);
  return model;
}

/// Some blocks fine, as a figure or as chance has them, and a relief there.
ReliefModel carved(unsigned seed) {
  ReliefModel model = cup();
  std::mt19937 any(seed);
  for (auto& row : model.rows) {
    for (std::size_t b = 0; b < kBlocksRound; ++b) row.fine[b] = any() % 3 == 0;
    for (auto& height : row.heights)
      height = static_cast<std::int16_t>(static_cast<int>(any() % 1400) - 700);
  }
  return model;
}

TEST(ReliefStl, APlainCupIsClosedAndHoldsItsClay) {
  const auto faces = faces_of(KeptRelief(relief_file(cup(), 0)).stl());
  ASSERT_FALSE(faces.empty());
  EXPECT_EQ(open_edges(faces), 0);
  const double n = kBlocksRound, polygon = n / 2 * std::sin(2 * std::numbers::pi / n);
  // The lip is two cones' frustums; 48 to 50 up, and 46 to 48 down.
  const auto frustum = [&](double a, double b, double h) {
    return polygon * h / 3 * (a * a + a * b + b * b);
  };
  const double mm3 = polygon * (50 * 50 * 40.0) + frustum(50, 48, 1) - frustum(46, 48, 1) -
                     polygon * (46 * 46 * 30.0);
  EXPECT_NEAR(volume_of(faces) / mm3, 1.0, 1e-4);
}

TEST(ReliefStl, WhicheverBlocksAreFineItIsClosed) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const auto faces = faces_of(KeptRelief(relief_file(carved(seed), 0)).stl());
    ASSERT_GT(faces.size(), 3000u);
    EXPECT_EQ(open_edges(faces), 0) << "seed " << seed;
    EXPECT_GT(volume_of(faces), 0.0);
  }
}

TEST(ReliefStl, ARingThatIsCutIsWhereItWasCutAndAsDeep) {
  ReliefModel model = cup();
  model.rows[20].heights.assign(kPlacesRound, -800);
  const auto faces = faces_of(KeptRelief(relief_file(model, 0)).stl());
  int met = 0;
  for (const auto& face : faces)
    for (const auto& [x, y, z] : face)
      if (std::abs(z - 20.0f) < 1e-3f && std::hypot(x, y) > 48.0f) {
        EXPECT_NEAR(std::hypot(x, y), 49.2, 1e-3);
        ++met;
      }
  EXPECT_EQ(met, 6 * kBlocksRound);
  EXPECT_EQ(open_edges(faces), 0);
}

TEST(ReliefStl, AFineBlockHasAllItsPlacesAndAnEvenOneItsCorner) {
  ReliefModel model = cup();
  model.rows[20].fine[5] = true;
  model.rows[20].heights[5 * ReliefModel::kFine + 3] = 500;
  const KeptRelief kept(relief_file(model, 0));
  const auto stl = ReliefStl::of(kept.file);
  ASSERT_TRUE(stl);
  const std::uint64_t plain = 2u * kBlocksRound * (model.rows.size() - 1) + 2u * kBlocksRound;
  EXPECT_EQ(stl->triangles(), plain + 14 + 7 + 7) << "and both its neighbours' edges";
  const auto faces = faces_of(kept.stl());
  float highest = 0;
  for (const auto& face : faces)
    for (const auto& [x, y, z] : face) highest = std::max(highest, std::hypot(x, y));
  EXPECT_NEAR(highest, 50.5, 1e-3);
  EXPECT_EQ(open_edges(faces), 0);
}

TEST(ReliefStl, AnySpanOfItIsThatPartOfTheWhole) {
  const KeptRelief kept(relief_file(carved(3), 0));
  const auto whole = kept.stl();
  const auto stl = StlOfPot::of(kept.file);
  ASSERT_TRUE(stl);
  std::mt19937 any(7);
  for (int n = 0; n < 60; ++n) {
    const std::size_t from = any() % whole.size();
    const std::size_t size = std::min<std::size_t>(whole.size() - from, any() % 40000);
    std::vector<std::byte> part(size);
    ASSERT_TRUE(stl->read(kept.file, from, part));
    EXPECT_TRUE(
        std::equal(part.begin(), part.end(), whole.begin() + static_cast<std::ptrdiff_t>(from)))
        << from << ' ' << size;
  }
}

TEST(ReliefStl, ADamagedOrShortenedFileIsRefusedOrCutOff) {
  const auto good = relief_file(carved(5), 0);
  ASSERT_FALSE(KeptRelief(good).stl().empty());
  for (const std::size_t at :
       {std::size_t{2}, std::size_t{9}, std::size_t{14}, std::size_t{18}, std::size_t{22},
        std::size_t{40}, good.size() / 2, good.size() - 3}) {
    auto bad = good;
    bad[at] ^= std::byte{0x55};
    EXPECT_TRUE(KeptRelief(bad).stl().empty()) << at;
  }
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{12}, std::size_t{100}, good.size() - 1})
    EXPECT_TRUE(KeptRelief(std::span(good).first(size)).stl().empty()) << size;
}

TEST(ReliefStl, ItIsOfThePotWhoseModelItWasMadeForAndNotAByteMayDiffer) {
  std::vector<std::byte> glb(200'000);
  for (std::size_t n = 0; n < glb.size(); ++n) glb[n] = static_cast<std::byte>(n * n / 7);
  const auto good = relief_file(carved(4), mark_of_model(glb, glb.size()));
  const KeptRelief pot(glb), kept(good);
  EXPECT_EQ(fit_of(kept.file, pot.file), ReliefFit::good);
  auto other = glb;
  other[60'000] ^= std::byte{1};
  EXPECT_EQ(fit_of(kept.file, KeptRelief(other).file), ReliefFit::foreign);
  other = glb;
  other.push_back({});
  EXPECT_EQ(fit_of(kept.file, KeptRelief(other).file), ReliefFit::foreign);
  for (std::size_t at = 0; at < good.size(); at += 1 + at / 8) {
    auto bad = good;
    bad[at] ^= std::byte{0x10};
    EXPECT_EQ(fit_of(KeptRelief(bad).file, pot.file), ReliefFit::damaged) << at;
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{20}, good.size() - 1})
    EXPECT_EQ(fit_of(KeptRelief(std::span(good).first(size)).file, pot.file), ReliefFit::damaged);
  std::filesystem::resize_file(kept.scratch.path() / kRelief, kMostRelief + 1);
  EXPECT_EQ(fit_of(kept.file, pot.file), ReliefFit::damaged);
}

TEST(ReliefStl, TheSamePotHasTheSameBytesAndItsTitle) {
  EXPECT_EQ(relief_file(carved(2), 0), relief_file(carved(2), 0));
  const auto stl = KeptRelief(relief_file(carved(2), 0)).stl();
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(stl.data()), 20), "Onggi, mm, z up: cup");
}

}  // namespace
}  // namespace onggi::souvenir::relief_stl_test
