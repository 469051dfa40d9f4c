#include "engine/contact/paper_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/math/random.h"
#include "tests/engine/contact/papers_pot.h"

// That the printed equations are what runs: one element after another against figures worked out by
// hand, from the points E1, E2 and M themselves.
namespace onggi::paper_model_test {
namespace {

using namespace papers_pot;

constexpr PaperCoefficients kCoefficients{10.0, 0.864, 200.0};

struct Whole {
  Vec3 force;
  double deepest = 0.0;
  std::int64_t touched = 0;
};

// Every element of the clay, points in space, no window: the tools below stand where eq. 2's
// interval leaves out nothing that collides.
Whole by_hand(Clay& clay, WallSide mode, Vec3 h, double wheel_angle) {
  Whole out;
  const double d = std::hypot(h.x, h.z);
  const double pi = std::acos(-1.0);
  for (int j = 0; j < clay.rows(); ++j) {
    for (int i = 0; i < clay.sectors(); ++i) {
      const double angle = (i + 0.5) * 2.0 * pi / clay.sectors() + wheel_angle;
      const Vec3 c{0.0, clay.row_height(j), 0.0};
      const Vec3 ray{std::cos(angle), 0.0, std::sin(angle)};
      // |C + t ray - H| = H_r
      const double middle = dot(h - c, ray);
      const double root = middle * middle - dot(h - c, h - c) + kRadius * kRadius;
      if (root < 0.0 || middle < 0.0) continue;
      const Vec3 e1 = c + (middle - std::sqrt(root)) * ray;
      const Vec3 e2 = c + (middle + std::sqrt(root)) * ray;
      const Vec3 m = 0.5 * (e1 + e2);
      const Vec3 e = mode == WallSide::outside ? e1 : e2;
      float& face = clay.outer_mut(j)[static_cast<std::size_t>(i)];
      const double s_r = double{face};
      const bool point = mode == WallSide::outside ? s_r < d : s_r > d;
      const double sign = mode == WallSide::outside ? 1.0 : -1.0;
      const double r = std::sqrt(kRadius * kRadius - std::pow(h.y - c.y, 2));
      const double p = point ? sign * (s_r - length(e - c)) : r - length(h - m);
      if (p <= 0.0) continue;
      const Vec3 from = point ? e : m;
      out.force += (kCoefficients.c_v * p / length(h - from)) * (h - from);
      out.deepest = std::max(out.deepest, p);
      ++out.touched;
      face = static_cast<float>(s_r - (s_r - length(e - c)) / kCoefficients.c_eta);
    }
  }
  return out;
}

TEST(PaperModel, IsThePrintedEquationsElementByElement) {
  Random random(1);
  for (int round = 0; round < 40; ++round) {
    const WallSide mode = round % 2 == 0 ? WallSide::outside : WallSide::inside;
    // Contraction with the centre before and beyond the surface, and expansion likewise.
    const double d = random.uniform(0.0435, 0.0575);
    const double angle = random.uniform(0.1, 3.0);
    const double wheel = random.uniform(0.0, 6.28);
    const Vec3 h{d * std::cos(angle), random.uniform(0.0, 0.072), d * std::sin(angle)};
    Clay a = made(sheet());
    Clay b = made(sheet());
    const PaperModel model(a);
    for (int tick = 0; tick < 3; ++tick) {
      const PaperTouch got = model.tick(a, mode, h, kRadius, wheel, 0.01, kCoefficients);
      const Whole expected = by_hand(b, mode, h, wheel);
      EXPECT_NEAR(static_cast<double>(got.touched), static_cast<double>(expected.touched), 4.0);
      EXPECT_NEAR(got.depth, expected.deepest, 1e-8);
      EXPECT_LT(length(got.resistance - expected.force), 1e-4 * length(expected.force) + 1e-6);
      const Vec3 friction = got.force - got.resistance;
      EXPECT_NEAR(friction.x, -200.0 * got.depth * std::sin(angle), 1e-9);
      EXPECT_NEAR(friction.z, 200.0 * got.depth * std::cos(angle), 1e-9);
    }
    for (int j = 0; j < a.rows(); ++j)
      for (std::size_t i = 0; i < 360; ++i) ASSERT_NEAR(a.outer(j)[i], b.outer(j)[i], 2e-6);
  }
}

TEST(PaperModel, KeepsTheClaysInvariantWhateverTheToolDoes) {
  Random random(2);
  Clay clay = made(sheet());
  const PaperModel model(clay);
  for (int n = 0; n < 4000; ++n) {
    const Vec3 at{random.uniform(-0.07, 0.07), random.uniform(-0.01, 0.08),
                  random.uniform(-0.07, 0.07)};
    const PaperCoefficients wild{random.uniform(0.5, 12.0), 0.864, 200.0};
    model.tick(clay, n % 2 == 0 ? WallSide::outside : WallSide::inside, at,
               random.uniform(0.001, 0.05), random.uniform(0.0, 6.28), random.uniform(-1.0, 1.0),
               wild);
  }
  const ClayDef& def = clay.def();
  for (int j = 0; j < clay.rows(); ++j) {
    for (std::size_t i = 0; i < 360; ++i) {
      ASSERT_GE(clay.inner(j)[i], 0.0f);
      ASSERT_GE(double{clay.outer(j)[i]}, double{clay.inner(j)[i]} + def.wall_min - 1e-8);
      ASSERT_LE(double{clay.outer(j)[i]}, def.radius_max + 1e-8);
    }
  }
}

TEST(PaperModel, AWallThatIsPressedTakesItsInnerFaceWithItOnceItIsAtItsThinnest) {
  ClayDef def;
  def.outer_radius = 0.05;
  def.inner_radius = 0.048;
  def.floor_thickness = 0.0;
  def.wall_min = 0.0015;
  Clay clay = made(def);
  const PaperModel model(clay);
  for (int n = 0; n < 200; ++n)
    model.tick(clay, WallSide::outside, {0.05, 0.1, 0.0}, kRadius, 0.0, 1.0, kCoefficients);
  const int row = clay.first_row_above(0.1);
  EXPECT_LT(clay.outer(row)[0], 0.046f);
  EXPECT_NEAR(double{clay.outer(row)[0]} - double{clay.inner(row)[0]}, def.wall_min, 1e-8);
}

TEST(PaperModel, AToolOverTheRimOrUnderTheFootIsOnTheSideOfTheRowThatIsNext) {
  Clay clay = made(sheet());
  const int top = clay.rows() - 1;
  for (float& r : clay.outer_mut(top)) r = 0.060f;
  for (float& r : clay.outer_mut(0)) r = 0.040f;
  const auto side = [&](double y) {
    return PaperModel::mode(clay, {0.0, y, 0.05}, 1.0, SideWish::by_position);
  };
  EXPECT_EQ(side(0.0721), WallSide::inside);
  EXPECT_EQ(side(0.5), WallSide::inside);
  EXPECT_EQ(side(-0.0001), WallSide::outside);
  EXPECT_EQ(side(-0.5), WallSide::outside);
}

TEST(PaperFilter, AFilterThatIsSettledGivesNothingForNothing) {
  PaperFilter filter;
  filter.filter({1.0, -2.0, 3.0});
  filter.settle();
  const Vec3 out = filter.filter({});
  EXPECT_EQ(length(out), 0.0);
}

}  // namespace
}  // namespace onggi::paper_model_test
