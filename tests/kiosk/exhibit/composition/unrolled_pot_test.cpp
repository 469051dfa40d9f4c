#include "kiosk/exhibit/composition/unrolled_pot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "engine/surface/surface.h"

namespace onggi::exhibit::unrolled_pot_test {
namespace {

/// A bellied jar with a floor.
ClayView jar() {
  ClayDef def;
  def.rows = 160, def.sectors = 120, def.height = 0.16, def.floor_thickness = 0.01;
  ClayView clay;
  clay.lay(def);
  std::vector<float> out(120), in(120);
  for (int j = 0; j < def.rows; ++j) {
    const auto r = static_cast<float>(0.05 + 0.015 * std::sin(3.0 * j / def.rows));
    std::fill(out.begin(), out.end(), r);
    std::fill(in.begin(), in.end(), j < clay.floor_rows() ? 0.0f : r - 0.006f);
    clay.shape(j, out, in);
  }
  return clay;
}

struct Pot {
  ClayView clay = jar();
  Profile made = clay.profile();
  surface::Surface surface = *surface::Surface::create(made, "jar");
  decoration::CoatPicture coat{surface, {}};
};

/// What would be read at each place: red by `red`, green by `green`, 0..1 from the left and top.
UnrolledPot filled(const Pot& pot, float (*red)(double), float (*green)(double)) {
  UnrolledPot unrolled(pot.made, pot.coat);
  int row = 0;
  while (!unrolled.whole()) {
    const ClayMesh places = unrolled.next_places();
    std::vector<view::SkinPoint> skin;
    for (int n = 0; n < static_cast<int>(places.faces.size()); ++n) {
      const double x = (n % UnrolledPot::kWidth + 0.5) / UnrolledPot::kWidth;
      const double y = (row + n / UnrolledPot::kWidth + 0.5) / unrolled.height();
      skin.push_back({{red(x), green(y), 0.0f}, 1.0f});
    }
    row += static_cast<int>(skin.size()) / UnrolledPot::kWidth;
    unrolled.take(skin);
  }
  return unrolled;
}

TEST(UnrolledPot, EveryPlaceOfThePictureIsFoundThereAgain) {
  const Pot pot;
  UnrolledPot unrolled(pot.made, pot.coat);
  EXPECT_EQ(unrolled.height() & (unrolled.height() - 1), 0) << "some phones want a power of two";
  int row = 0;
  std::set<ClayFace> faces;
  while (!unrolled.whole()) {
    ClayMesh places = unrolled.next_places();
    const auto at = unrolled.places_of(places);
    ASSERT_EQ(at.size(), places.faces.size());
    for (std::size_t n = 0; n < at.size(); n += 37) {
      faces.insert(places.faces[n]);
      const double column = static_cast<double>(n % UnrolledPot::kWidth) + 0.5;
      EXPECT_NEAR(at[n][0] * UnrolledPot::kWidth, column, 0.01);
      const int here = row + static_cast<int>(n) / UnrolledPot::kWidth;
      EXPECT_NEAR(at[n][1] * static_cast<float>(unrolled.height()), here + 0.5, 0.3)
          << "face " << static_cast<int>(places.faces[n]);
    }
    row += static_cast<int>(places.faces.size()) / UnrolledPot::kWidth;
    unrolled.take(std::vector<view::SkinPoint>(places.faces.size()));
  }
  EXPECT_EQ(row, unrolled.height());
  EXPECT_EQ(faces.size(), 4u) << "outside, lip, inside and floor";
}

TEST(UnrolledPot, ThePlacesLieOnTheClay) {
  const Pot pot;
  UnrolledPot unrolled(pot.made, pot.coat);
  while (!unrolled.whole()) {
    const ClayMesh places = unrolled.next_places();
    for (std::size_t n = 0; n < places.faces.size(); n += 101) {
      const auto& [x, y, z] = places.mesh.positions[n];
      const double rho = std::hypot(double{x}, double{z}), h = double{y};
      if (places.faces[n] == ClayFace::outer) {
        EXPECT_NEAR(rho, pot.made.outer_at(h), 1e-5);
      } else if (places.faces[n] == ClayFace::inner) {
        EXPECT_NEAR(rho, pot.made.inner_at(h), 1e-5);
      } else if (places.faces[n] == ClayFace::floor) {
        EXPECT_NEAR(h, pot.made.floor_height(), 1e-5);
      } else {
        EXPECT_GT(h, pot.made.height() - 0.0031);
        EXPECT_LE(h, pot.made.height() + 1e-6);
      }
    }
    unrolled.take(std::vector<view::SkinPoint>(places.faces.size()));
  }
}

TEST(UnrolledPot, NoCornerOfTheModelsMeshIsOutsideItAndEachFaceHasItsPart) {
  const Pot pot;
  const UnrolledPot unrolled(pot.made, pot.coat);
  const ClayMesh mesh = faced_mesh_of(pot.clay, 160, 96);
  const auto places = unrolled.places_of(mesh);
  std::map<ClayFace, std::pair<float, float>> part;
  for (std::size_t n = 0; n < places.size(); ++n) {
    auto& [low, high] = part.try_emplace(mesh.faces[n], 2.0f, -1.0f).first->second;
    low = std::min(low, places[n][1]), high = std::max(high, places[n][1]);
    EXPECT_GE(places[n][0], 0.0f);
    EXPECT_LE(places[n][0], 1.0f);
  }
  EXPECT_EQ(part[ClayFace::foot].second, 0.0f);
  EXPECT_NEAR(part[ClayFace::outer].first, 0.0f, 0.002f);
  EXPECT_NEAR(part[ClayFace::outer].second, part[ClayFace::rim].first, 0.001f);
  EXPECT_NEAR(part[ClayFace::rim].second, part[ClayFace::inner].first, 0.001f);
  EXPECT_NEAR(part[ClayFace::inner].second, part[ClayFace::floor].first, 0.003f);
  EXPECT_EQ(part[ClayFace::floor].second, 1.0f);
  // No triangle on the axis goes round more than its own sector.
  for (const auto& [a, b, c] : mesh.mesh.triangles) {
    const float low = std::min({places[a][0], places[b][0], places[c][0]});
    const float high = std::max({places[a][0], places[b][0], places[c][0]});
    EXPECT_TRUE(high - low < 0.02f || high - low > 0.98f) << low << ' ' << high;
  }
}

TEST(UnrolledPot, WhatIsPolishedIsDarkerInThePictureOfRoughness) {
  const Pot pot;
  UnrolledPot unrolled(pot.made, pot.coat);
  // A band of a quarter of the rows, and a column's width in it that is rough.
  int row = 0;
  while (!unrolled.whole()) {
    const std::size_t places = unrolled.next_places().faces.size();
    std::vector<view::SkinPoint> skin(places);
    for (std::size_t n = 0; n < places; ++n) {
      const double y = (row + static_cast<double>(n / UnrolledPot::kWidth)) / unrolled.height();
      const bool polished = y >= 0.25 && y < 0.5 && n % UnrolledPot::kWidth != 101;
      skin[n].roughness = polished ? 0.28f : 0.8f;
    }
    row += static_cast<int>(places) / UnrolledPot::kWidth;
    unrolled.take(skin);
  }
  const view::Image rough = unrolled.roughness();
  EXPECT_EQ(rough.width, UnrolledPot::kWidth / 2);
  EXPECT_EQ(rough.height, unrolled.height() / 2);
  ASSERT_EQ(rough.rgba.size(), 4u * static_cast<std::size_t>(rough.width * rough.height));
  const auto at = [&](int x, double y) {
    const auto line = static_cast<std::size_t>(y * rough.height);
    return rough
        .rgba[4 * (line * static_cast<std::size_t>(rough.width) + static_cast<std::size_t>(x))];
  };
  EXPECT_EQ(at(300, 0.4), 71) << "0.28 of 255";
  EXPECT_EQ(at(300, 0.1), 204);
  EXPECT_EQ(at(300, 0.9), 204);
  EXPECT_EQ(at(50, 0.4), (71 + 204 + 1) / 2) << "two pixels wide";
}

TEST(UnrolledPot, TheRolloutStandsOnItsFootAndReadsAsSeenFromOutside) {
  const Pot pot;
  const auto left_half = [](double x) { return x < 0.5 ? 1.0f : 0.0f; };
  const auto top_tenth = [](double y) { return y < 0.05 ? 1.0f : 0.0f; };
  const view::Image rollout = filled(pot, left_half, top_tenth).rollout();
  EXPECT_EQ(rollout.width, UnrolledPot::kWidth);
  const auto at = [&](double x, double y, std::size_t k) {
    const auto column = static_cast<std::size_t>(x * rollout.width);
    const auto row = static_cast<std::size_t>(y * rollout.height);
    return rollout.rgba[4 * (row * static_cast<std::size_t>(rollout.width) + column) + k];
  };
  // Angles grow to the left of who stands before the pot.
  EXPECT_EQ(at(0.25, 0.5, 0), 0);
  EXPECT_EQ(at(0.75, 0.5, 0), 255);
  EXPECT_EQ(at(0.5, 0.98, 1), 255) << "the foot is below";
  EXPECT_EQ(at(0.5, 0.02, 1), 0);
  // True along the outline, and round the belly.
  double outline = 0, widest = 0;
  for (std::size_t n = 1; n < pot.made.points.size(); ++n) {
    const auto &a = pot.made.points[n - 1], &b = pot.made.points[n];
    outline += std::hypot(b.height - a.height, b.outer - a.outer);
    widest = std::max(widest, b.outer);
  }
  const double true_ratio = outline / (6.283185307 * widest);
  EXPECT_NEAR(1.0 * rollout.height / rollout.width, true_ratio, 0.03 * true_ratio);
}

}  // namespace
}  // namespace onggi::exhibit::unrolled_pot_test
