#include "kiosk/exhibit/composition/pot_relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "engine/surface/laws.h"
#include "kiosk/exhibit/composition/unrolled_pot.h"
#include "tests/kiosk/keepsake/souvenir/relief_file_on_disk.h"

namespace onggi::exhibit::pot_relief_test {
namespace {

using souvenir::test::faces_of;
using souvenir::test::KeptRelief;
using souvenir::test::open_edges;
using souvenir::test::StlFace;
using souvenir::test::volume_of;

constexpr double kOuter = 0.05, kWall = 0.006, kTall = 0.09, kFloor = 0.01;

/// A straight cup, not round by `oval`.
ClayView straight_cup(double oval = 0.0) {
  ClayDef def;
  def.rows = 180, def.sectors = 120, def.height = kTall, def.floor_thickness = kFloor;
  ClayView clay;
  clay.lay(def);
  std::vector<float> out(120), in(120);
  for (int j = 0; j < def.rows; ++j) {
    for (std::size_t i = 0; i < 120; ++i) {
      const double angle = 2.0 * 3.14159265358979 * (static_cast<double>(i) + 0.5) / 120.0;
      out[i] = static_cast<float>(kOuter + oval * std::cos(2.0 * angle));
      in[i] = j < clay.floor_rows() ? 0.0f : out[i] - static_cast<float>(kWall);
    }
    clay.shape(j, out, in);
  }
  return clay;
}

surface::Stroke ring_at(double height, double width, double depth) {
  surface::CutDef def;
  def.section = surface::CutDef::flat, def.width = width, def.depth = depth, def.burr = 0.0;
  surface::Stroke ring{def, {}, false};
  for (int n = 0; n <= 560; ++n) {
    surface::Station at;
    at.along = static_cast<std::int32_t>(1e6 * height);
    at.round = n * 3 * surface::kParts;
    ring.stations.push_back(at);
  }
  return ring;
}

struct Cup {
  explicit Cup(double oval = 0.0) : clay(straight_cup(oval)) {}
  std::vector<StlFace> printed(double size = 1.0) const {
    const UnrolledPot unrolled(made, coat);
    const ClayMesh body = faced_mesh_of(clay, 400, 120);
    return faces_of(
        KeptRelief(souvenir::relief_file(
                       relief_of(body, unrolled.places_of(body), surface, size, "cup"), 0))
            .stl());
  }
  ClayView clay;
  Profile made = clay.profile();
  surface::Surface surface = *surface::Surface::create(made, "cup");
  decoration::CoatPicture coat{surface, {}};
};

double volume_of_mesh(const TriangleMesh& mesh) {
  std::vector<StlFace> faces;
  for (const auto& t : mesh.triangles)
    faces.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
  return 1e9 * volume_of(faces);
}

TEST(PotRelief, ABarePotIsTheClayClosedAndCoarse) {
  const Cup cup;
  const auto faces = cup.printed();
  EXPECT_EQ(open_edges(faces), 0);
  EXPECT_LT(faces.size(), 120000u) << "nothing there needs the fine grid";
  EXPECT_NEAR(volume_of(faces) / volume_of_mesh(mesh_of(cup.clay, 400, 120)), 1.0, 3e-3);
}

TEST(PotRelief, APotThatIsNotRoundIsPrintedAsItIs) {
  const Cup cup(0.002);
  const auto faces = cup.printed();
  EXPECT_EQ(open_edges(faces), 0);
  double most_x = 0, most_y = 0;
  for (const auto& face : faces)
    for (const auto& [x, y, z] : face)
      if (z > 20.0f && z < 60.0f) {
        most_x = std::max(most_x, double{std::abs(x)});
        most_y = std::max(most_y, double{std::abs(y)});
      }
  EXPECT_NEAR(most_x, 52.0, 0.05);
  EXPECT_NEAR(most_y, 48.0, 0.05);
}

TEST(PotRelief, ACutRingIsMissingFromThePrintToItsVolumeAndDepth) {
  Cup cup;
  const double before = volume_of(cup.printed());
  ASSERT_TRUE(surface::apply(cup.surface, ring_at(0.045, 4e-3, 1e-3)));
  const auto faces = cup.printed();
  EXPECT_EQ(open_edges(faces), 0);
  // A ring of 4 mm by 1 mm at 49.5 mm; its walls are a cell steep.
  const double ring = 2.0 * 3.14159265358979 * 49.5 * 4.0 * 1.0;
  EXPECT_NEAR((before - volume_of(faces)) / ring, 1.0, 0.05);
  double least = 100;
  for (const auto& face : faces)
    for (const auto& [x, y, z] : face)
      if (std::abs(z - 45.0f) < 1.9f && std::hypot(x, y) > 47.0f)
        least = std::min(least, std::hypot(double{x}, double{y}));
  EXPECT_NEAR(least, 49.0, 0.02);
}

TEST(PotRelief, AFigureHasTheFineGridAndTheRestOfItsRowsHasNot) {
  Cup cup;
  const auto plain = cup.printed().size();
  surface::CutDef def;
  def.width = 2e-3, def.depth = 8e-4;
  surface::Stroke dot{def, {}, false};
  surface::Station at;
  at.along = 45000;
  dot.stations.push_back(at);
  ASSERT_TRUE(surface::apply(cup.surface, dot));
  const auto faces = cup.printed();
  EXPECT_EQ(open_edges(faces), 0);
  EXPECT_GT(faces.size(), plain + 300);
  EXPECT_LT(faces.size(), plain + 20000);
  // Places of the grid stand 0.3 mm apart there.
  double closest = 1e9;
  for (const auto& [a, b, c] : faces)
    if (std::abs(a[2] - 45.0f) < 1.0f && a[0] > 45.0f && std::abs(a[1]) < 1.0f)
      closest = std::min(closest,
                         std::hypot(double(a[0] - b[0]), double(a[1] - b[1]), double(a[2] - b[2])));
  EXPECT_NEAR(closest, 0.3, 0.05);
}

TEST(PotRelief, AFiredPotIsSmallerWithItsCuts) {
  Cup cup;
  ASSERT_TRUE(surface::apply(cup.surface, ring_at(0.045, 4e-3, 1e-3)));
  EXPECT_NEAR(volume_of(cup.printed(0.9)) / volume_of(cup.printed()), 0.9 * 0.9 * 0.9, 2e-3);
}

TEST(PotRelief, WhatStandsUpMovesTheModelAndStaysClosed) {
  Cup cup;
  for (int j = 170; j < 190; ++j)
    for (int i = 0; i < surface::kSectors; ++i) cup.surface.set_relief(j, i, 900);
  const UnrolledPot unrolled(cup.made, cup.coat);
  ClayMesh pot = faced_mesh_of(cup.clay, 160, 96);
  auto places = unrolled.places_of(pot);
  decoration::Skin skin{std::move(pot.mesh), std::move(places)};
  decoration::close_round(skin);
  const auto before = skin.mesh.positions;
  EXPECT_FALSE(raise(skin, cup.surface, 1.0, 0.15, 1.0 / 96, 1.0 / 350)) << "under glass";
  EXPECT_EQ(skin.mesh.positions, before);
  ASSERT_TRUE(raise(skin, cup.surface, 1.0, 1.0, 1.0 / 96, 1.0 / 350));
  double most = 0;
  for (std::size_t n = 0; n < before.size(); ++n) {
    const auto &a = before[n], &b = skin.mesh.positions[n];
    const double far = std::hypot(double(a[0] - b[0]), double(a[1] - b[1]), double(a[2] - b[2]));
    most = std::max(most, far);
    if (std::abs(a[1] - 0.045f) > 0.006f) {
      EXPECT_EQ(far, 0.0);
    }
  }
  EXPECT_NEAR(most, 9e-4, 2e-5);
  std::vector<StlFace> faces;
  for (const auto& t : skin.mesh.triangles)
    faces.push_back(
        {skin.mesh.positions[t[0]], skin.mesh.positions[t[1]], skin.mesh.positions[t[2]]});
  EXPECT_EQ(open_edges(faces), 0);
}

TEST(PotRelief, WhatIsFinerThanTheModelOrLowerMovesNothing) {
  Cup cup;
  for (int i = 0; i < surface::kSectors; i += 40) cup.surface.set_relief(180, i, 900);
  for (int j = 100; j < 120; ++j)
    for (int i = 0; i < surface::kSectors; ++i) cup.surface.set_relief(j, i, 250);
  const UnrolledPot unrolled(cup.made, cup.coat);
  ClayMesh pot = faced_mesh_of(cup.clay, 160, 96);
  auto places = unrolled.places_of(pot);
  decoration::Skin skin{std::move(pot.mesh), std::move(places)};
  const auto before = skin.mesh.positions;
  EXPECT_FALSE(raise(skin, cup.surface, 1.0, 1.0, 1.0 / 96, 1.0 / 350));
  EXPECT_EQ(skin.mesh.positions, before);
}

}  // namespace
}  // namespace onggi::exhibit::pot_relief_test
