#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/surface/laws.h"

namespace onggi::surface_test {

using namespace onggi::surface;

/// A bowl with a foot, a belly, a lip and a floor: 60 mm high, 45 mm in radius.
inline Profile bowl() {
  return {{{0.0, 0.020, 0.0}, {0.006, 0.024, 0.018}, {0.040, 0.045, 0.040}, {0.060, 0.042, 0.038}}};
}
/// A jar as tall as the wheel allows: 200 mm, with a belly of 80 mm in radius and a neck.
inline Profile jar() {
  return {{{0.0, 0.050, 0.0},
           {0.008, 0.052, 0.046},
           {0.110, 0.080, 0.074},
           {0.180, 0.040, 0.035},
           {0.200, 0.045, 0.041}}};
}

inline Surface made(const Profile& profile) {
  Result<Surface> surface = Surface::create(profile, "pot");
  EXPECT_TRUE(surface) << (surface ? "" : to_text(surface.error()));
  return std::move(*surface);
}

/// The stations of a straight way. m along the outline, and turns.
inline std::vector<Station> straight(const Surface& surface, HandPlace from, HandPlace to,
                                     double reach = 0.4) {
  Tracer tracer(surface, reach);
  tracer.go(from), tracer.go(to), tracer.lift();
  return tracer.stations();
}
/// Once round the pot at a height.
inline std::vector<Station> band(const Surface& surface, double along, double reach = 0.4) {
  return straight(surface, {along, 0.0}, {along, 1.0}, reach);
}

inline Work done(Surface& surface, const Tool& tool, std::vector<Station> stations = {}) {
  const Result<Work> work = apply(surface, {tool, std::move(stations), false});
  EXPECT_TRUE(work) << (work ? "" : to_text(work.error()));
  return work ? *work : Work{};
}

/// A dip of the whole pot.
inline DipDef whole_dip(int coat = DipDef::kGlaze) {
  DipDef def;
  def.coat = coat;
  def.to = 2.0;
  return def;
}

/// Of all pigments, with what rounding left over.
inline Volume all_slip(const Surface& surface) {
  Volume sum = 0;
  for (int j = 0; j < surface.rows(); ++j) {
    Volume thickness = 0;
    for (int i = 0; i < kSectors; ++i) thickness += surface.slip(j, i).thickness();
    sum += thickness * surface.row(j).area;
    for (int pigment = 0; pigment < kPigments; ++pigment) sum += surface.rest(j, pigment);
  }
  return sum;
}

/// Every cell of `b` is the cell of `a` that lies `sectors` before it.
inline void expect_turned(const Surface& a, const Surface& b, int sectors) {
  ASSERT_EQ(a.rows(), b.rows());
  for (int j = 0; j < a.rows(); ++j) {
    for (int i = 0; i < kSectors; ++i) {
      const int t = wrapped(i + sectors);
      ASSERT_EQ(a.relief(j, i), b.relief(j, t)) << j << ' ' << i;
      ASSERT_EQ(a.slip(j, i).word(), b.slip(j, t).word()) << j << ' ' << i;
      ASSERT_EQ(a.glaze(j, i), b.glaze(j, t)) << j << ' ' << i;
      ASSERT_EQ(a.resist(j, i), b.resist(j, t)) << j << ' ' << i;
      ASSERT_EQ(a.coil(j, i), b.coil(j, t)) << j << ' ' << i;
      ASSERT_EQ(a.burnish(j, i), b.burnish(j, t)) << j << ' ' << i;
      ASSERT_EQ(a.smoke(j, i), b.smoke(j, t)) << j << ' ' << i;
    }
    for (int kind = 0; kind < Surface::kRests; ++kind)
      ASSERT_EQ(a.rest(j, kind), b.rest(j, kind)) << j << ' ' << kind;
  }
}

/// No value is broken: strata have no hole, nothing is cut deeper than it may be, and a rest is
/// less than what the thickest cells of its row can swallow.
inline void expect_whole(const Surface& surface) {
  for (int j = 0; j < surface.rows(); ++j) {
    for (int i = 0; i < kSectors; ++i) {
      const Strata strata = surface.slip(j, i);
      for (int k = 0; k < kStrata; ++k) {
        const Stratum stratum = strata.at(k);
        ASSERT_LT(stratum.code, kCodes);
        if (k > 0 && stratum.code > 0) {
          ASSERT_GT(strata.at(k - 1).code, 0) << j << ' ' << i;
        }
        if (stratum.code == 0) {
          ASSERT_EQ(stratum.pigment, 0) << j << ' ' << i;
        }
      }
      ASSERT_EQ(strata.word() >> 30, 0u);
      ASSERT_GE(surface.relief(j, i), -surface.deepest(j)) << j << ' ' << i;
      ASSERT_LE(surface.relief(j, i), 3000) << j << ' ' << i;
    }
  }
}

}  // namespace onggi::surface_test
